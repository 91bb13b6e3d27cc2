// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "graph/quad.hpp"
#include "graph/window_graph.hpp"

namespace lanefuse {

/// Four observations, linearised.
///
/// With everything expressed in the window's frame, the Jacobian by the landmark is the identity, and by the
/// pose it is -T with T = [1 0 -uy; 0 1 ux; 0 0 1], u being the way from the pose to the landmark. So an
/// observation's whole part of the Hessian (Omega, -T' Omega and T' Omega T) is in six numbers.
struct alignas(kQuadAlignment) LinearBlock {
  Quad xx, xy, yy, heading;  ///< Omega in the window's frame
  Quad ux, uy;               ///< [m]
  std::array<WindowGraph::Id, 4> pose;
};

/// A landmark with its observations.
struct LandmarkRun {
  WindowGraph::Id landmark = WindowGraph::kNone;
  std::uint32_t begin = 0, end = 0;  ///< of its LinearBlocks
};

/// The normal equations of a WindowGraph at one point, with the pose-to-landmark part kept as observations.
/// Vectors by pose are in the order of the graph's slots, [kNowhere] collects what empty places give:
/// nothing. Vectors by landmark are in the order of `runs`. A step is (x, y, heading, -).
struct WindowSystem {
  std::vector<LandmarkRun> runs;  ///< first those without ties, then the tied ones in order of elimination
  std::size_t untied = 0;         ///< runs[0, untied) have no ties
  std::vector<LinearBlock> linear;
  Quads scratch;  ///< for the run with the most blocks, three each

  Quads places;     ///< by pose: x, y, heading
  Quads turns;      ///< by pose: cos, sin, cos 2h, sin 2h
  Quads landmarks;  ///< x, y, heading

  Quads information;    ///< by landmark: xx, xy, yy, heading of its observations' Omega, summed
  Quads landmark_rhs;   ///< by landmark
  Quads pose_rhs;       ///< by pose
  Quads inverses;       ///< by landmark: xx, xy, yy, heading of D^-1, blocks of position and heading
  Quads reduced_first;  ///< by pose: xx, xy, yy, xh of the diagonal left by eliminating landmarks
  Quads reduced_rest;   ///< by pose: yh, hh
};

}  // namespace lanefuse
