// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/block_structure.hpp"
#include "graph/normal_equations.hpp"

namespace lanefuse {

/// The least share of an unknown's own information that must remain once all it is tied to has been accounted
/// for.
///
/// A pivot of the Cholesky factor is what is known of an unknown beyond what only relates it to others. In
/// exact arithmetic it is zero for an undetermined unknown; rounding leaves some 1e-16 of the diagonal it was
/// subtracted from. A chain of n poses held at one end only legitimately comes down to about 1/n^3, 1e-12 for
/// n = 10,000. The test is by the unknown's own diagonal, so that metres and radians need no common scale.
inline constexpr double kLeastPivotShare = 1e-13;

/// Whether a pivot says that its unknown is determined; false for NaN.
inline bool is_determined(double pivot, double diagonal) {
  return pivot > kLeastPivotShare * diagonal && pivot > 0;
}

/// Eliminates all landmarks from the equations: block Cholesky, column by column, each subtracting its share
/// from the later columns. Leaves the Schur complement in the poses' part, and the factor in the landmarks'
/// part. False if a landmark is undetermined.
bool eliminate_landmarks(const BlockStructure& structure, NormalEquations& equations);

/// The landmarks' steps, once `equations.rhs` holds those of the poses; they take the place of the right hand
/// side.
void substitute_landmarks(const BlockStructure& structure, NormalEquations& equations);

}  // namespace lanefuse
