// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/lane_estimate.hpp"
#include "evaluation/line_ahead.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// What a boundary is to the car: an edge of its own lane, or the outer edge of a neighbour lane.
enum LaneRole : std::size_t { kEgoLeft, kEgoRight, kAdjacentLeft, kAdjacentRight, kRoleCount };
constexpr bool is_ego(std::size_t role) { return role <= kEgoRight; }

/// The true line of one role ahead: in pieces, because a neighbour lane may begin and end, and the line may
/// pass from one boundary of the road to the next.
class RoleLine {
 public:
  /// Pieces come in the order in which they lie ahead.
  void add(LineAhead piece);
  [[nodiscard]] const std::vector<LineAhead>& pieces() const { return pieces_; }
  [[nodiscard]] bool empty() const { return pieces_.empty(); }

  /// Where the line crosses x, or nothing where there is none.
  [[nodiscard]] std::optional<double> y(double x) const;
  /// How far left of the line the point lies, across it; nothing where there is no line at the point's x.
  [[nodiscard]] std::optional<double> deviation(const Eigen::Vector2d& point) const;

 private:
  std::vector<LineAhead> pieces_;
};

using TrueRoles = std::array<RoleLine, kRoleCount>;

/// Which boundaries the estimate itself takes for these; null where it has no such lane.
using EstimatedRoles = std::array<const Boundary*, kRoleCount>;

/// While the car crosses a line, centimetres decide which lane its origin is in: this near to the line [m]
/// the estimate's lanes on both of its sides may answer for the ego lane.
inline constexpr double kOnTheLine = 0.3;

/// The estimate's own ego lane and neighbours; on the line (kOnTheLine), those of the lane that the car truly
/// is in. Without a true ego lane beside the car, the estimate's word holds.
EstimatedRoles estimated_roles(const LaneEstimate& estimate, const TrueRoles& truth);

/// The lanes of a road, and which of them are what to the car.
///
/// The ego lane is the one that the car's origin is in, as far ahead as it goes; where its boundaries end and
/// those of another lane begin in the same place, it goes on as that one. A neighbour lane is one that is
/// linked to it or shares the boundary between, where it is at least kNarrowest wide: a lane that is only
/// just beginning or has all but ended is none that anyone could drive in. Lines that bound no lane (old
/// paint, edges of the road) play no role.
class TrueLanes {
 public:
  static constexpr double kNarrowest = 2;  ///< [m]

  /// The edges of one lane, as indices of the road's boundaries.
  struct Edges {
    std::size_t left = 0;
    std::size_t right = 0;
  };

  /// Lanes whose boundaries the road does not have are left out.
  explicit TrueLanes(const TrueRoad& road);

  /// `lines` are the road's boundaries around the car, in their order: see TrueRoadView. All are empty where
  /// the car is in no lane.
  [[nodiscard]] TrueRoles roles(const std::vector<LineAhead>& lines) const;
  [[nodiscard]] const std::vector<Edges>& lanes() const { return edges_; }
  /// Whether that boundary of the road bounds a lane.
  [[nodiscard]] bool bounds_a_lane(std::size_t boundary) const { return bounding_[boundary]; }

 private:
  [[nodiscard]] std::optional<std::size_t> ego_lane(const std::vector<LineAhead>& lines) const;
  [[nodiscard]] std::vector<std::size_t> ahead_of(std::size_t lane,
                                                  const std::vector<LineAhead>& lines) const;
  [[nodiscard]] bool continues(std::size_t lane, std::size_t next, const std::vector<LineAhead>& lines) const;

  std::vector<Edges> edges_;
  std::vector<std::vector<std::size_t>> left_of_;   // lanes that lie left of each lane somewhere
  std::vector<std::vector<std::size_t>> right_of_;  // and right of it
  std::vector<bool> bounding_;
};

}  // namespace lanefuse
