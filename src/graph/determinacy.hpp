// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace lanefuse {

/// Whether a vertex is determined, judged when its turn to be eliminated comes.
///
/// `remaining` is its own 3x3 block with all earlier vertices accounted for: what is known of it beyond what
/// only relates it to those. `diagonal` is the diagonal that its block had before. In exact arithmetic an
/// undetermined vertex has a singular remaining block. Rounding blurs that by some 1e-16 of the diagonal; a
/// chain of n poses held at one end only legitimately comes down to about 1/n^3, 1e-12 for n = 10,000. The
/// line is drawn between.
///
/// The block is taken apart with its largest pivot first, as the undetermined direction of an edge with
/// Omega_xx = 0 lies in no axis: a fixed order would divide by the rounding of a small pivot and call the
/// noise information. Metres are measured against the larger of the two position entries, radians against the
/// heading's own.
bool is_determined(const Eigen::Matrix3d& remaining, const Eigen::Vector3d& diagonal);

}  // namespace lanefuse
