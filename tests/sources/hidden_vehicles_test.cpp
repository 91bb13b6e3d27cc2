// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/tracked_traffic.hpp"

namespace lanefuse {
namespace {

using testing::fused;
using testing::moments;
using testing::nearest;
using testing::TrackedTraffic;
using testing::TrafficScene;

/// A vehicle that drives in front of another, and hides it where the scene has it no more.
class HiddenVehicles : public ::testing::Test {
 protected:
  HiddenVehicles() { hidden_.users.pop_back(); }

  /// Of the hindmost track, or 0 where there is but one.
  static std::int64_t second(const std::vector<TrackedObject>& objects) {
    if (objects.size() != 2) return 0;
    return objects[objects[0].x > objects[1].x ? 0 : 1].id;
  }

  const TrafficScene scene_{{30, 0}, {{{25, 0}, {30, 0}}, {{45, 0.1}, {30, 0}}}};
  TrafficScene hidden_ = scene_;
  TrackedTraffic traffic_;
};

TEST_F(HiddenVehicles, KeepTheirNamesForFourSeconds) {
  const std::int64_t name = second(fused(traffic_, scene_, 0, 2));
  ASSERT_NE(name, 0);
  EXPECT_EQ(fused(traffic_, hidden_, 2, 6).size(), 1U) << "nobody is told of a vehicle unseen for so long";
  EXPECT_EQ(second(fused(traffic_, scene_, 6, 7)), name);
}

TEST_F(HiddenVehicles, AreForgottenInTheEnd) {
  const std::int64_t name = second(fused(traffic_, scene_, 0, 2));
  fused(traffic_, hidden_, 2, 9);
  const std::int64_t anew = second(fused(traffic_, scene_, 9, 10));
  ASSERT_NE(anew, 0);
  EXPECT_NE(anew, name);
}

TEST_F(HiddenVehicles, BearNoWitnessWithTheFirstLook) {
  const std::int64_t name = second(fused(traffic_, scene_, 0, 2));
  fused(traffic_, hidden_, 2, 3);
  const TrueFrame frame = scene_.at(3);
  const auto back = traffic_.radar(frame);
  const TrackedObject* object = nearest(back, frame, frame.objects[1]);
  ASSERT_NE(object, nullptr);
  EXPECT_EQ(object->id, name);
  EXPECT_FALSE(object->seen_by_radar) << "whoever it is";
  const auto later = fused(traffic_, scene_, 3.05, 4);
  for (const TrackedObject& seen : later) EXPECT_TRUE(seen.seen_by_radar && seen.seen_by_camera);
}

}  // namespace
}  // namespace lanefuse
