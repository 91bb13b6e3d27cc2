// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/pose2.hpp"
#include "evaluation/line_ahead.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// The true road as it lies around the car, from kViewBehind behind it to kViewAhead ahead.
///
/// Remembers where along each boundary the car was, so that a look costs what the view holds and not what the
/// road is long, as long as the car moves on bit by bit; a jump costs a search along the whole road, and so,
/// from time to time, does a boundary that is far away.
class TrueRoadView {
 public:
  static constexpr double kViewBehind = 30;  ///< [m]
  static constexpr double kViewAhead = 160;  ///< [m]

  /// `road` must outlive this view.
  explicit TrueRoadView(const TrueRoad& road);
  explicit TrueRoadView(TrueRoad&&) = delete;

  /// One line for each of the road's boundaries, in their order and in the vehicle frame; empty where the
  /// boundary is out of view. Valid until the next look.
  const std::vector<LineAhead>& look_from(const Pose2& world_from_vehicle);
  /// What the last look saw.
  [[nodiscard]] const std::vector<LineAhead>& lines() const { return lines_; }

 private:
  void cut(std::size_t boundary, const Pose2& vehicle_from_world);
  [[nodiscard]] bool is_search_due(std::size_t boundary, const Eigen::Vector2d& position) const;

  const TrueRoad& road_;
  std::optional<Eigen::Vector2d> last_position_;
  std::vector<std::size_t> nearest_;          // point of each boundary to the car
  std::vector<Eigen::Vector2d> searched_at_;  // where the car was when it was searched whole
  std::vector<LineAhead> lines_;
};

}  // namespace lanefuse
