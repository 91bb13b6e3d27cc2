// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "camera/bar_finder.hpp"
#include "core/feature.hpp"

namespace lanefuse {

/// A bar of one row and where it lies on the road.
struct RoadBar {
  RowBar bar;
  int plan = 0;                                         ///< its row in the plan
  double row = 0;                                       ///< [px]
  int row_height = 1;                                   ///< [px]
  double x = 0;                                         ///< [m]
  double y = 0;                                         ///< [m]
  double width = 0;                                     ///< [m]
  double row_sigma = 0;                                 ///< [px] of `row`, as the paint may end within it
  double y_sigma = 0;                                   ///< [m] of y by the bar's own noise
  Eigen::Matrix2d per_pixel = Eigen::Matrix2d::Zero();  ///< d (x, y) / d (u, v) [m/px]
  MarkingColour colour = MarkingColour::unknown;
  int previous = -1;  ///< the bar of the same paint in a nearer row
  int next = -1;      ///< in a farther row
  int chain = -1;
  double heading = 0;        ///< [rad] of the paint here, from the chain
  double heading_sigma = 0;  ///< [rad] by the bars' own noise
  bool faint = false;        ///< hardly any of the row is paint
  bool believed = false;
};

/// Bars of one piece of paint, row by row: what a single row cannot know.
struct BarChain {
  int first = 0;      ///< the nearest bar
  int last = 0;       ///< the farthest
  int count = 0;      ///< of bars
  double length = 0;  ///< [m]
};

struct BarChainsConfig {
  double heading_max = 0.10;          ///< [rad] to the car's direction, at the car
  double radius_min = 400;            ///< [m] of bends, which turn what is far
  double reach = 1.6;                 ///< [m] of road without a bar within a chain
  int rows_skipped = 1;               ///< rows without a bar within a chain, where rows are far apart
  double heading_base = 4;            ///< [m] of chain to either side that a bar's heading is taken from
  double heading_base_growth = 0.06;  ///< [m] of that for each metre of distance
};

/// Ties bars across rows into chains, each bar to at most one before and one behind it: those that lie where
/// the chain so far leads, of about the same width and brightness.
class BarChains {
 public:
  explicit BarChains(const BarChainsConfig& config) : config_(config) {}

  /// `bars` are sorted by row, near to far. Fills in what a bar knows of its chain.
  const std::vector<BarChain>& link(std::vector<RoadBar>& bars, int plans);

  /// Gives each bar the heading of its chain around it.
  void measure_headings(std::vector<RoadBar>& bars) const;

 private:
  struct Candidate {
    int nearer = -1;
    double cost = 0;
  };
  BarChainsConfig config_;
  std::vector<int> row_begin_;  ///< of each planned row, its first bar
  std::vector<double> slopes_;  ///< of the chain up to each bar
  std::vector<int> lengths_;    ///< [bars] of the chain up to each bar
  std::vector<Candidate> wanted_;
  std::vector<BarChain> chains_;

  void index_rows(const std::vector<RoadBar>& bars, int plans);
  [[nodiscard]] double cost(const RoadBar& nearer, const RoadBar& farther, int nearer_index) const;
  [[nodiscard]] Candidate best_nearer(const std::vector<RoadBar>& bars, int index) const;
  void join_row(std::vector<RoadBar>& bars, int begin, int end);
  void join(std::vector<RoadBar>& bars, int nearer, int farther);
  void collect(std::vector<RoadBar>& bars);
  void head(std::vector<RoadBar>& bars, const BarChain& chain) const;
};

}  // namespace lanefuse
