// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "camera/row_signal.hpp"

namespace lanefuse {

struct BarFinderConfig {
  double width_min = 0.10;       ///< [m] on the ground
  double width_max = 0.30;       ///< [m]
  double width_tolerance = 0.3;  ///< share of the width
  double contrast_min = 6;       ///< [grey levels]
  double contrast_to_noise = 4;  ///< of the steps at its edges, at the gradient's own scale
  double evidence_min = 5;       ///< of the whole bar: contrast over noise times the root of its width
  double most_uneven = 2.5;      ///< how much larger the contrast may be on one side than on the other
};

/// A bar in one row, brighter than the road on both of its sides.
struct RowBar {
  double left = 0;      ///< [px] column of its left edge; the middle of a pixel is an integer
  double right = 0;     ///< [px]
  double centre = 0;    ///< [px] of its paint
  double sigma = 0;     ///< [px] of the centre, from the noise around it
  double contrast = 0;  ///< [grey levels]
  double road = 0;      ///< [grey levels] of what lies beside it
  double area = 0;      ///< [grey levels px] of all its paint
  double noise = 0;  ///< [grey levels] of a pixel here, as far as it does not average out over a few of them
};

/// Finds bars of the width of paint in one row: pairs of edges, each the peak of a gradient over the row's
/// noise.
class BarFinder {
 public:
  BarFinder(int width, const BarFinderConfig& config);

  /// Bars from left to right. `slant` [px]: by how much the columns of straight paint may shift within the
  /// row.
  const std::vector<RowBar>& find(const RowSignal& signal, const PlannedRow& row, double slant);

 private:
  struct Edge {
    int at = 0;        ///< between the pixels `at - 1` and `at`
    int strength = 0;  ///< positive where it gets brighter to the right
  };
  struct Side {
    double level = 0;     ///< of a pixel
    double variance = 0;  ///< of a pixel
    int count = 0;
  };

  /// Where a bar may be, and what is around it.
  struct Place {
    int rising = 0;   ///< [px] its edges
    int falling = 0;  ///< [px]
    int margin = 0;   ///< [px] that blur and slant take outside of each edge
    Side left = {};   ///< the road beside it
    Side right = {};
    double contrast = 0;
    double noise = 0;
  };

  BarFinderConfig config_;
  int step_ = 1;  ///< [px] over which the gradient averages on each side
  double gradient_noise_ = 0;
  std::vector<std::int32_t> gradient_;
  std::array<std::int32_t, 1024> histogram_{};
  std::vector<Edge> edges_;
  std::vector<RowBar> bars_;

  void differentiate(const RowSignal& signal);
  void measure_noise(const RowSignal& signal, const PlannedRow& row);
  void find_edges(const RowSignal& signal);
  [[nodiscard]] const Edge* partner(std::size_t rising, double narrowest, double widest) const;
  [[nodiscard]] Side flank(const RowSignal& signal, int from, int to) const;
  [[nodiscard]] double noise_of(const Side& left, const Side& right) const;
  bool measure_whole(const RowSignal& signal, const Place& place, RowBar& bar) const;
  bool measure_edges(const RowSignal& signal, const Place& place, RowBar& bar) const;
  void measure(const RowSignal& signal, int rising, int falling);
};

}  // namespace lanefuse
