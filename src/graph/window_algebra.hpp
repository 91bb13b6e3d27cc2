// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "graph/edge_terms.hpp"
#include "graph/quad.hpp"

namespace lanefuse {

/// One constraint between two poses, at one point, in the window's frame: as LinearBlock, but with whatever
/// information.
struct PlanarTerm {
  Eigen::Matrix3d information;
  Eigen::Vector3d force;  ///< Omega e
  double cost = 0;        ///< e' Omega e
  double ux = 0, uy = 0;  ///< from `from` to `to`
};

/// What it adds to the normal equations; `to` gets Omega and -Omega e.
struct PlanarBlocks {
  Eigen::Matrix3d from_from;  ///< T' Omega T
  Eigen::Matrix3d from_to;    ///< -T' Omega
  Eigen::Vector3d from_rhs;   ///< T' Omega e
};

inline Eigen::Vector3d vector(const Quad& q) { return {q[0], q[1], q[2]}; }

inline void add(Quad& q, const Eigen::Vector3d& v) { q += Quad{v[0], v[1], v[2], 0}; }

/// The term of `measurement`, whose information is in the frame of `from`; places are x, y, heading.
inline PlanarTerm planar_term(const Pose2& measurement, const Symmetric3& information, const Quad& from,
                              const Quad& to) {
  const double c = std::cos(from[2]);
  const double s = std::sin(from[2]);
  const Symmetric3 m = turned(information, c, s);
  PlanarTerm term;
  term.ux = to[0] - from[0];
  term.uy = to[1] - from[1];
  const Eigen::Vector3d e(term.ux - (c * measurement.x - s * measurement.y),
                          term.uy - (s * measurement.x + c * measurement.y),
                          wrap_angle(to[2] - from[2] - measurement.heading));
  term.information << m.xx, m.xy, m.xh, m.xy, m.yy, m.yh, m.xh, m.yh, m.hh;
  term.force = m * e;
  term.cost = e.dot(term.force);
  return term;
}

inline PlanarBlocks planar_blocks(const PlanarTerm& term) {
  const auto swung = [&](auto rows) { return term.ux * rows.row(1) - term.uy * rows.row(0); };
  PlanarBlocks blocks;
  blocks.from_to = -term.information;
  blocks.from_to.row(2) -= swung(term.information);
  blocks.from_from = -blocks.from_to;
  blocks.from_from.col(2) += term.ux * blocks.from_from.col(1) - term.uy * blocks.from_from.col(0);
  blocks.from_rhs = term.force;
  blocks.from_rhs[2] += term.ux * term.force[1] - term.uy * term.force[0];
  return blocks;
}

/// Inverts a block that holds position and heading apart, as xx, xy, yy, heading; false if it is
/// undetermined. That does not depend on the axes, of which one may by chance stand along what is told: hence
/// beside the larger of the two.
inline bool invert_block(const Quad& m, Quad& inverse) {
  constexpr double kLeastDeterminantShare = 1e-13;
  const double determinant = m[0] * m[2] - m[1] * m[1];
  const double larger = std::max(m[0], m[2]);
  if (!(determinant > kLeastDeterminantShare * larger * larger && larger > 0 && m[3] > 0)) return false;
  inverse = Quad{m[2] / determinant, -m[1] / determinant, m[0] / determinant, 1 / m[3]};
  return true;
}

/// Such a block times x, y, heading.
inline void multiply_block(const Quad& m, const Quad& v, Quad& product) {
  product = Quad{m[0] * v[0] + m[1] * v[1], m[1] * v[0] + m[2] * v[1], m[3] * v[2], 0};
}

}  // namespace lanefuse
