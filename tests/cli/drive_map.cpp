// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "recording/drive_truth.hpp"
#include "roadmap/map_files.hpp"

namespace {

using namespace lanefuse;

/// The true road of a drive as a map, in the same frame; moved by so many metres along y.
RoadMap map_of(const TrueRoad& road, double moved) {
  RoadMap map;
  map.name = "true road";
  map.origin = GeoOrigin{48.2, 11.6, 0};
  for (const TrueBoundary& boundary : road.boundaries) {
    MapBoundary line{boundary.id, {}, {{0, boundary.marking, boundary.marking_width}}};
    for (const auto& point : boundary.points) line.points.emplace_back(point.x(), point.y() + moved, 0);
    map.boundaries.push_back(std::move(line));
  }
  for (const TrueLane& lane : road.lanes) {
    map.lanes.push_back({lane.id,
                         LaneKind::driving,
                         lane.left_boundary,
                         lane.right_boundary,
                         lane.left_lane,
                         lane.right_lane,
                         {}});
  }
  return map;
}

}  // namespace

/// drive_map DRIVE METRES MAP writes the drive's true road as a map file, moved along y.
int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto truth = read_truth(argv[1]);
  if (!truth.road) return 3;
  write_map(map_of(*truth.road, std::stod(argv[2])), argv[3]);
}
