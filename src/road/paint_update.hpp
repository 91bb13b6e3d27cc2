// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/feature.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// A point of paint that is of no line that is known.
struct StrayPaint {
  double station = 0;
  double lateral = 0;  ///< [m] left of the axis
  MarkingEvidence marking;
  LineLabel label = kNoLabel;
};

/// Takes a frame's marking features into the state, from near to far: what the near ones tell of heading,
/// pitch and yaw is known when the far ones are given to lines. In each band of distance a line's features
/// count as one measurement of their robust mean.
class PaintUpdate {
 public:
  explicit PaintUpdate(const RoadConfig& config) : config_(config) {}

  /// Gives how many features were given to lines; the others are in strays().
  /// `moved` [m] by the car since the last frame: what is seen again from the same place says little new.
  std::size_t take(const FeatureSet& set, const Pose2& now_from_measured, double moved, RoadState& state);

  /// Before any line is known: what the features' headings say of the road's course, which lets them be
  /// sorted into lines even in a bend.
  void take_headings(const FeatureSet& set, const Pose2& now_from_measured, RoadState& state);

  /// Of the last frame, near the car: how much paint was seen, and how much of it told of lines.
  struct NearPaint {
    std::size_t seen = 0;
    std::size_t used = 0;
  };
  [[nodiscard]] const NearPaint& near() const { return near_paint_; }

  [[nodiscard]] std::span<const StrayPaint> strays() const { return strays_; }
  /// The id of the line that each of the last frame's features was taken for, 0 where for none.
  [[nodiscard]] std::span<const std::uint64_t> given_to() const { return given_to_; }

 private:
  /// A feature that was given to a line.
  struct Given {
    double residual = 0;  ///< [m] how far it is left of the line
    double variance = 0;  ///< of its own
    const Feature* feature = nullptr;
  };

  bool take_band(double begin, double end, const Pose2& now_from_measured, RoadState& state);
  void give(const Feature& feature, const Pose2& now_from_measured, const RoadState& state);
  void look_again(const Pose2& now_from_measured, const RoadState& state);
  /// By what lines are told apart: the state as it is, or as the frame found it.
  [[nodiscard]] const RoadState& known(const RoadState& state) const {
    return before_frame_ ? *before_frame_ : state;
  }
  std::size_t take_line(KnownLine& line, std::vector<Given>& given, const Pose2& now_from_measured,
                        RoadState& state);
  [[nodiscard]] SparseRow row_of(const KnownLine& line, const Eigen::Vector2d& seen,
                                 const Pose2& now_from_measured, const RoadState& state) const;

  RoadConfig config_;
  std::optional<RoadState> before_frame_;  ///< only where not from near to far
  std::vector<const Feature*> by_range_;
  std::size_t next_ = 0;
  std::size_t used_ = 0;
  int unexplained_ = 0;  ///< frames in a row with a band that the lines do not explain
  double repeats_ = 1;
  NearPaint near_paint_;
  /// What a line has in this band.
  struct Near {
    std::size_t on = 0;     ///< features of this frame on it
    std::size_t left = 0;   ///< features that are nearest to it, not near enough, and on its left
    std::size_t right = 0;  ///< and on its right
    double from = 1e9;      ///< [m] the first of them
  };
  [[nodiscard]] bool is_explained(std::size_t first_stray, const RoadState& state);
  void let_go(RoadState& state);
  void find_yellow(const Pose2& now_from_measured, const RoadState& state);
  [[nodiscard]] bool is_void(const Feature& feature) const;

  std::vector<std::vector<Given>> given_;  ///< a line
  std::vector<Near> near_;                 ///< a line
  double yellow_begin_ = 1e9;              ///< [m] between which, in this frame, yellow paint counts alone
  double yellow_end_ = -1e9;
  std::vector<double> gates_;  ///< [m] a line, of this band
  std::vector<StrayPaint> strays_;
  const Feature* first_ = nullptr;  ///< of the frame
  std::vector<std::uint64_t> given_to_;
};

}  // namespace lanefuse
