// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/block_structure.hpp"
#include "graph/normal_equations.hpp"

namespace lanefuse {

/// Eliminates all landmarks from the equations: block Cholesky, column by column, each subtracting its share
/// from the later columns. Leaves the Schur complement in the poses' part, and the factor in the landmarks'
/// part. False if a landmark is undetermined.
bool eliminate_landmarks(const BlockStructure& structure, NormalEquations& equations);

/// The landmarks' steps, once `equations.rhs` holds those of the poses; they take the place of the right hand
/// side.
void substitute_landmarks(const BlockStructure& structure, NormalEquations& equations);

}  // namespace lanefuse
