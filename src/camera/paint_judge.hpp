// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "camera/bar_chains.hpp"
#include "camera/parallel_lines.hpp"

namespace lanefuse {

struct PaintJudgeConfig {
  ParallelLinesConfig lines;
  double piece_length = 5;           ///< [m] of chain that is taken as straight
  double place_gate = 0.30;          ///< [m] to the line that a bar belongs to, at the car
  double place_gate_growth = 0.004;  ///< [m] of that for each metre of distance
  double heading_gate = 0.02;        ///< [rad] to the line's direction, beside the bar's own sigma
  double line_length_min = 2.5;      ///< [m] of paint that make a line
  double far = 60;                   ///< [m] from here on a line must be known from elsewhere, too
  double brightness_min = 0.15;      ///< against the road, of that of the image's other paint
  int far_count = 5;                 ///< bars of a far chain that is believed by itself
  double near = 45;                  ///< [m] up to here dashes are long enough to be believed by themselves
  double near_lateral = 8;           ///< [m] to either side, of such dashes
  double near_length = 2;            ///< [m] of such dashes
  double near_heading_gate = 0.06;   ///< [rad] of such dashes to the road
  double sure_length = 8;  ///< [m] of chain that is believed though it runs by itself, as at an exit
  int sure_count = 8;      ///< bars of such a chain
};

/// Decides which bars are paint: those that run with the road and with each other. Sees the whole image's
/// chains at once, as a person does who knows at a glance which of many bright spots far away are the lane's.
class PaintJudge {
 public:
  explicit PaintJudge(const PaintJudgeConfig& config) : config_(config), lines_(config.lines) {}

  /// Finds the lines that the chains make. `stretch_sigma` [1/m]: the pose's pitch sigma over the camera's
  /// height.
  void find_lines(const std::vector<RoadBar>& bars, std::span<const BarChain> chains, double stretch_sigma);

  /// Marks bars as believed. A far bar without a chain takes its heading from its line.
  void judge(std::vector<RoadBar>& bars, std::span<const BarChain> chains);

  [[nodiscard]] const ParallelLines& lines() const { return lines_; }
  /// Solid or dashed, as far as the believed chains of the line through a bar tell.
  [[nodiscard]] MarkingType type_of(const RoadBar& bar) const;

 private:
  struct LineShape {
    double longest = 0;  ///< [m] of its chains
    double painted = 0;  ///< [m]
    double begin = 0;    ///< [m]
    double end = 0;      ///< [m]
    int chains = 0;
  };
  PaintJudgeConfig config_;
  ParallelLines lines_;
  std::vector<LinePiece> pieces_;
  std::vector<LineShape> shapes_;
  std::vector<double> brightness_;  ///< of bars in chains, against the road
  double usual_brightness_ = 0;

  void cut_into_pieces(const std::vector<RoadBar>& bars, const BarChain& chain);
  [[nodiscard]] bool stands_upright(const std::vector<RoadBar>& bars, const BarChain& chain) const;
  void measure_brightness(const std::vector<RoadBar>& bars, std::span<const BarChain> chains);
  [[nodiscard]] bool is_dull(const std::vector<RoadBar>& bars, const BarChain& chain) const;
  [[nodiscard]] bool runs_alone(const std::vector<RoadBar>& bars, const BarChain& chain) const;
  [[nodiscard]] bool fits_a_line(const RoadBar& bar, const BarChain& chain) const;
  void judge_chain(std::vector<RoadBar>& bars, const BarChain& chain);
  void measure_lines(const std::vector<RoadBar>& bars, std::span<const BarChain> chains);
};

}  // namespace lanefuse
