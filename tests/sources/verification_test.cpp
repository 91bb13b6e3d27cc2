// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sources/witness.hpp"
#include "support/tracked_traffic.hpp"

/// What makes a track a vehicle that may bear witness: both kinds of sensor.
namespace lanefuse {
namespace {

using testing::fused;
using testing::kLook;
using testing::radar_only;
using testing::TrackedTraffic;
using testing::TrafficScene;

TEST(Verification, IsTheCamerasOwn) {
  const TrafficScene scene{{30, 0}, {{{45, 0}, {30, 0}}}};
  TrackedTraffic traffic;
  const auto by_radar = radar_only(traffic, scene, 0, 4);
  ASSERT_EQ(by_radar.size(), 1U);
  EXPECT_TRUE(by_radar[0].seen_by_radar);
  EXPECT_FALSE(by_radar[0].seen_by_camera);
  EXPECT_FALSE(is_witness(by_radar[0], {}));
  const auto by_both = fused(traffic, scene, 4, 5);
  ASSERT_EQ(by_both.size(), 1U);
  EXPECT_TRUE(by_both[0].seen_by_camera);
  EXPECT_TRUE(is_witness(by_both[0], {}));
}

TEST(Verification, TakesMoreThanAFewFalseBoxes) {
  const TrafficScene ghost{{30, 0}, {{{45, 3}, {30, 0}}}};
  const TrafficScene empty{{30, 0}, {}};
  TrackedTraffic traffic;
  for (int i = 0; i < 60; ++i) {
    const double t = i * kLook;
    traffic.radar(ghost.at(t));
    const auto objects = traffic.camera((i % 20 == 0 ? ghost : empty).at(t));
    for (const TrackedObject& object : objects) EXPECT_FALSE(object.seen_by_camera) << i;
  }
}

TEST(Verification, RefusesAGhostWhereTheCameraShouldSeeAVehicle) {
  const TrafficScene ghost{{30, 0}, {{{30, 0.5}, {30, 0}}}};
  const TrafficScene empty{{30, 0}, {}};
  TrackedTraffic traffic;
  std::vector<TrackedObject> objects;
  for (int i = 0; i < 60; ++i) {
    traffic.radar(ghost.at(i * kLook));
    objects = traffic.camera(empty.at(i * kLook));
  }
  EXPECT_TRUE(objects.empty());
}

}  // namespace
}  // namespace lanefuse
