// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/landmark_elimination.hpp"

#include <cmath>

#include "graph/determinacy.hpp"

namespace lanefuse {

namespace {

/// The three lines of a landmark's column.
struct Lines {
  double* line[3];
  std::size_t length;

  Lines(const BlockStructure::Column& column, double* values)
      : line{values + column.values, values + column.values + column.stride,
             values + column.values + 2 * column.stride},
        length(column.stride) {}
  [[nodiscard]] double& factor(int r, int c) const { return line[r][c]; }
};

Eigen::Matrix3d own_block(const Lines& h) {
  Eigen::Matrix3d block;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c <= r; ++c) block(r, c) = block(c, r) = h.factor(r, c);
  }
  return block;
}

/// Puts the Cholesky factor L of the column's own block in its place, with the reciprocals of its diagonal.
/// False if rounding leaves no positive pivot.
bool factor_own_block(const Lines& h) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < r; ++c) {
      for (int k = 0; k < c; ++k) h.factor(r, c) -= h.factor(r, k) * h.factor(c, k);
      h.factor(r, c) *= h.factor(c, c);
      h.factor(r, r) -= h.factor(r, c) * h.factor(r, c);
    }
    if (!(h.factor(r, r) > 0)) return false;
    h.factor(r, r) = 1 / std::sqrt(h.factor(r, r));
  }
  return true;
}

/// Lines behind the own block become L^-1 times what they were, and so does the right hand side.
void divide_lines(const Lines& h, double* rhs) {
  const double l10 = h.factor(1, 0), l20 = h.factor(2, 0), l21 = h.factor(2, 1);
  const double r0 = h.factor(0, 0), r1 = h.factor(1, 1), r2 = h.factor(2, 2);
  double* __restrict y0 = h.line[0];
  double* __restrict y1 = h.line[1];
  double* __restrict y2 = h.line[2];
  for (std::size_t i = 3; i < h.length; ++i) {
    y0[i] *= r0;
    y1[i] = (y1[i] - l10 * y0[i]) * r1;
    y2[i] = (y2[i] - l20 * y0[i] - l21 * y1[i]) * r2;
  }
  rhs[0] *= r0;
  rhs[1] = (rhs[1] - l10 * rhs[0]) * r1;
  rhs[2] = (rhs[2] - l20 * rhs[0] - l21 * rhs[1]) * r2;
}

/// target_c[i] -= sum over the lines k of y_k[i] * y_k[own + c], for the three lines c of the target column.
void subtract_run(const Lines& y, std::size_t own, const BlockStructure::Run& run, double* target,
                  std::size_t stride) {
  const double* __restrict y0 = y.line[0] + run.source;
  const double* __restrict y1 = y.line[1] + run.source;
  const double* __restrict y2 = y.line[2] + run.source;
  for (std::size_t c = 0; c < 3; ++c) {
    const double a0 = y.line[0][own + c], a1 = y.line[1][own + c], a2 = y.line[2][own + c];
    double* __restrict t = target + c * stride + run.target;
    for (std::uint32_t i = 0; i < run.length; ++i) t[i] -= y0[i] * a0 + y1[i] * a1 + y2[i] * a2;
  }
}

}  // namespace

bool eliminate_landmarks(const BlockStructure& structure, NormalEquations& equations) {
  double* values = equations.values.data();
  double* rhs = equations.rhs.data();
  for (std::uint32_t landmark = 0; landmark < structure.landmarks(); ++landmark) {
    const Lines lines(structure.column(landmark), values);
    double* own_rhs = rhs + 3 * landmark;
    if (!is_determined(own_block(lines), equations.diagonal.segment<3>(3 * landmark))) return false;
    if (!factor_own_block(lines)) return false;
    divide_lines(lines, own_rhs);
    for (const BlockStructure::Update& update : structure.updates(landmark)) {
      const BlockStructure::Column& column = structure.column(update.column);
      for (const BlockStructure::Run& run : structure.runs(update)) {
        subtract_run(lines, update.source, run, values + column.values, column.stride);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t i = update.source + c;
        rhs[3 * update.column + c] -=
            lines.line[0][i] * own_rhs[0] + lines.line[1][i] * own_rhs[1] + lines.line[2][i] * own_rhs[2];
      }
    }
  }
  return true;
}

void substitute_landmarks(const BlockStructure& structure, NormalEquations& equations) {
  double* rhs = equations.rhs.data();
  for (std::uint32_t landmark = structure.landmarks(); landmark-- > 0;) {
    const Lines y(structure.column(landmark), equations.values.data());
    double* own = rhs + 3 * landmark;
    for (const BlockStructure::Update& update : structure.updates(landmark)) {
      const double* step = rhs + 3 * update.column;
      for (std::size_t k = 0; k < 3; ++k) {
        const double* line = y.line[k] + update.source;
        own[k] -= line[0] * step[0] + line[1] * step[1] + line[2] * step[2];
      }
    }
    own[2] *= y.factor(2, 2);
    own[1] = (own[1] - y.factor(2, 1) * own[2]) * y.factor(1, 1);
    own[0] = (own[0] - y.factor(1, 0) * own[1] - y.factor(2, 0) * own[2]) * y.factor(0, 0);
  }
}

}  // namespace lanefuse
