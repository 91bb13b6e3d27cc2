// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/rig.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "sensors/drive.hpp"

namespace lanefuse {
namespace {

TEST(Rig, FindsSensorsByTheirId) {
  const Rig rig{
      {{3, SensorKind::odometry, "bus"}, {7, SensorKind::long_range_radar, "front", {3.5, 0, 0.5}}}};
  ASSERT_NE(rig.find(7), nullptr);
  EXPECT_EQ(rig.find(7)->name, "front");
  EXPECT_EQ(rig.find(7)->mounting.x, 3.5);
  EXPECT_EQ(rig.find(4), nullptr);
  EXPECT_EQ(Rig{}.find(0), nullptr);
}

TEST(Rig, KnowsWhetherItCanSeePaint) {
  for (int kind = 0; kind <= 6; ++kind) {
    const auto sensor = static_cast<SensorKind>(kind);
    const bool camera = sensor == SensorKind::serial_camera || sensor == SensorKind::high_resolution_camera;
    EXPECT_EQ((Rig{{{0, SensorKind::odometry, ""}, {1, sensor, ""}}}.has_camera()), camera)
        << to_string(sensor);
  }
}

TEST(Names, EverySensorKindAndRuleHasItsOwn) {
  std::set<std::string> names;
  for (int kind = 0; kind <= 6; ++kind) names.insert(to_string(static_cast<SensorKind>(kind)));
  EXPECT_EQ(names.size(), 7U);
  EXPECT_FALSE(names.contains("unknown"));
  EXPECT_STREQ(to_string(WitnessRule::radar_and_camera), "radar_and_camera");
  EXPECT_STREQ(to_string(WitnessRule::radar_only), "radar_only");
}

}  // namespace
}  // namespace lanefuse
