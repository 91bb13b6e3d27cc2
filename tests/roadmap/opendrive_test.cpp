// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "roadmap/lane_strips.hpp"
#include "support/map_files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

TEST(OpenDrive, ReadsTheE6) {
  const auto path = testing::real_data("opendrive/e6mini.xodr");
  LANEFUSE_NEEDS_DATA(path);
  const RoadMap map = read_opendrive(path);
    for (const MapLane& lane : map.lanes)
      std::printf(" lane %lu %s b %lu %lu  left %lu right %lu len %.1f %.1f styles %zu %zu succ %zu  %zu\n", lane.id, to_string(lane.kind), lane.left_boundary,
                  lane.right_boundary, lane.left_lane.value_or(0), lane.right_lane.value_or(0),
                  arc_length(find_boundary(map, lane.left_boundary)->points),
                  arc_length(find_boundary(map, lane.right_boundary)->points),
                  find_boundary(map, lane.left_boundary)->styles.size(), find_boundary(map, lane.right_boundary)->styles.size(), lane.successors.size(),find_boundary(map, lane.right_boundary)->points.size());
 for (auto& b : map.boundaries) printf("%lu %s %s %g\n", b.id, to_string(b.styles[0].marking.type), to_string(b.styles[0].marking.colour), b.styles[0].width);
}

}  // namespace
}  // namespace lanefuse
