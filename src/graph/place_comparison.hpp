// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "graph/g2o.hpp"

namespace lanefuse {

/// How far the places of one solution lie from another's, once it is turned and moved onto it as well as it
/// fits (least squares over positions): the absolute trajectory error.
struct PlaceComparison {
  std::size_t compared = 0;   ///< vertices that both have, by their ids
  std::size_t only_in_a = 0;  ///< vertices without a partner
  std::size_t only_in_b = 0;
  double rmse = 0;          ///< of positions [m], the ATE
  double farthest = 0;      ///< largest distance [m]
  double heading_rmse = 0;  ///< [rad]
};

/// `a` against `b`. Throws an input Error if they share no vertex.
PlaceComparison compare_places(const G2oGraph& a, const G2oGraph& b);

}  // namespace lanefuse
