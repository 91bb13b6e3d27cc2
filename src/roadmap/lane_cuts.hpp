// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <vector>

#include "roadmap/measured_line.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {

/// A piece of a boundary, by arc length.
struct BoundaryPiece {
  std::uint64_t boundary = 0;
  double from = 0;  ///< [m]
  double to = 0;    ///< [m]
  friend auto operator<=>(const BoundaryPiece&, const BoundaryPiece&) = default;
};

/// A lane's pieces, each between one piece of its left and one of its right boundary.
struct LanePiece {
  BoundaryPiece left;
  BoundaryPiece right;
};

/// Cuts a map's lanes across the whole carriageway wherever a lane begins or ends or a boundary's paint
/// changes, as formats need it whose lanes are short. Changes of paint less than a metre from another cut
/// move there.
class LaneCuts {
 public:
  /// Throws, naming `place`, where a lane's boundaries do not run side by side.
  LaneCuts(const RoadMap& map, const std::string& place);

  /// In driving direction.
  [[nodiscard]] std::vector<LanePiece> pieces(const MapLane& lane) const;
  [[nodiscard]] const MeasuredLine& line(std::uint64_t boundary) const { return lines_.at(boundary); }

 private:
  void cut_at_lane_ends(const MapLane& lane);
  void cut_across(std::uint64_t boundary, double arc);
  [[nodiscard]] bool is_near_cut(std::uint64_t boundary, double arc) const;
  [[nodiscard]] bool is_near_end(std::uint64_t boundary, double arc) const;
  [[nodiscard]] double snapped(std::uint64_t boundary, double arc) const;
  [[nodiscard]] std::vector<BoundaryPiece> side(std::uint64_t boundary, std::uint64_t other) const;

  const std::string& place_;
  std::map<std::uint64_t, MeasuredLine> lines_;
  std::map<std::uint64_t, std::set<double>> cuts_;  ///< by boundary, with both ends
  std::multimap<std::uint64_t, const MapLane*> lanes_at_;
};

}  // namespace lanefuse
