// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/preset.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kFile = std::filesystem::path(LANEFUSE_SOURCE_DIR) / "config/nominal-preset.yaml";

/// The nominal preset's text with `from` replaced by `to`.
std::string changed(const std::string& from, const std::string& to) {
  std::string text(nominal_preset_text());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    parse_preset(text, "test.yaml");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    return error.what();
  }
  return "accepted";
}

TEST(Preset, TravelsInTheProgramByteForByte) {
  std::ifstream file(kFile, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(nominal_preset_text(), text);
  EXPECT_EQ(load_preset(kFile).hash, nominal_preset().hash);
}

TEST(Preset, HasTheHashOfTheFrozenFile) { EXPECT_EQ(nominal_preset().hash, "f6c14cdb5a9c6637"); }

TEST(Preset, IsReadInRadiansAndSeconds) {
  const double degree = std::numbers::pi / 180;
  const SensorPreset preset = nominal_preset();
  EXPECT_DOUBLE_EQ(preset.traffic.vehicles_per_metre_lane, 0.008);
  EXPECT_DOUBLE_EQ(preset.odometry.latency, 0.010);
  EXPECT_DOUBLE_EQ(preset.odometry.yaw_rate_white, 0.1 * degree);
  EXPECT_DOUBLE_EQ(preset.camera_pose.residual_pitch, 0.12 * degree);
  EXPECT_DOUBLE_EQ(preset.serial_camera.pixel, 0.79e-3);
  EXPECT_DOUBLE_EQ(preset.high_resolution_camera.heading.at(0), 0.5 * degree);
  EXPECT_DOUBLE_EQ(preset.high_resolution_camera.heading.at(50), 1.0 * degree);
  EXPECT_DOUBLE_EQ(preset.object_list.sigma_y.at(100), 0.3);
  EXPECT_DOUBLE_EQ(preset.object_list.heading.high, 0.9 * degree);
  EXPECT_DOUBLE_EQ(preset.road.curved_radius.low, 600);
}

TEST(Preset, SaysHowRadarsAndTheObjectCameraSee) {
  const double degree = std::numbers::pi / 180;
  const SensorPreset preset = nominal_preset();
  EXPECT_DOUBLE_EQ(preset.long_range_radar.hz, 15);
  EXPECT_DOUBLE_EQ(preset.long_range_radar.field, 17 * degree);
  EXPECT_DOUBLE_EQ(preset.long_range_radar.near_range, 60);
  EXPECT_DOUBLE_EQ(preset.long_range_radar.near_field, 56 * degree);
  EXPECT_DOUBLE_EQ(preset.long_range_radar.sigma_azimuth, 0.15 * degree);
  EXPECT_DOUBLE_EQ(preset.long_range_radar.reflections.high, 3);
  EXPECT_EQ(preset.short_range_radar.count, 4);
  EXPECT_DOUBLE_EQ(preset.short_range_radar.clutter, 3);
  EXPECT_DOUBLE_EQ(preset.short_range_radar.near_range, 0);
  EXPECT_DOUBLE_EQ(preset.short_range_radar.misalignment, preset.long_range_radar.misalignment);
  EXPECT_DOUBLE_EQ(preset.camera_boxes.latency, 0.06);
  EXPECT_DOUBLE_EQ(preset.camera_boxes.sigma_base_px, 1.5);
  EXPECT_DOUBLE_EQ(preset.camera_boxes.false_boxes, 0.02);
  EXPECT_DOUBLE_EQ(preset.ghosts.guard_rail_mirrors.low, 0);
  EXPECT_DOUBLE_EQ(preset.ghosts.guard_rail_mirrors.high, 2);
}

TEST(Preset, RefusesWhatItDoesNotKnowByName) {
  EXPECT_THAT(refusal(changed("reflections_per_vehicle: [1, 3]", "reflections_per_vehicle: [1, 2.5]")),
              HasSubstr("long_range_radar.reflections_per_vehicle"));
  EXPECT_THAT(refusal(changed("count: 4", "count: 4.5")), HasSubstr("short_range_radar.count"));
  EXPECT_THAT(refusal(changed("false_per_frame", "false_boxes")), HasSubstr("camera_boxes.false_per_frame"));
  EXPECT_THAT(refusal(changed("mirrors_per_scan: [0, 2]", "mirrors_per_scan: [2, 0]")),
              HasSubstr("ghosts.guard_rail_mirrors_per_scan"));
  EXPECT_THAT(refusal(changed("shoulder_m", "sholder_m")), HasSubstr("road.shoulder_m: is missing"));
  EXPECT_THAT(refusal(changed("fusion_hz", "colour: blue\nfusion_hz")),
              HasSubstr("colour: is an unknown key"));
  EXPECT_THAT(refusal(changed("height_m: 1.25", "height_m: 1.25, roll: 1")), HasSubstr("camera_pose.roll"));
  EXPECT_THAT(refusal(changed("mark: 6", "mark: -6")), HasSubstr("road.dash_m.mark"));
  EXPECT_THAT(refusal(changed("dropout: 0.02", "dropout: 1.2")), HasSubstr("serial_camera.dropout"));
  EXPECT_THAT(refusal(changed("[1800, 8000]", "[8000, 1800]")), HasSubstr("road.gentle.radius_m"));
  EXPECT_THAT(refusal(changed("fusion_hz: 12.5", "fusion_hz: .nan")), HasSubstr("fusion_hz"));
  EXPECT_THAT(refusal(changed("version: 1", "version: 2")), HasSubstr("version"));
  EXPECT_THAT(refusal("{a: [b"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("just words"), HasSubstr("not a map"));
}

TEST(Preset, NamesAFileThatIsNotThere) { EXPECT_THROW(load_preset("no/such/preset.yaml"), Error); }

TEST(Preset, HoldsTheErrorsOfThePapersOwnMap) {
  const SurveyedTruthPreset truth = nominal_preset().surveyed_truth;
  EXPECT_DOUBLE_EQ(truth.ego, 0.09);
  EXPECT_DOUBLE_EQ(truth.adjacent, 0.19);
  EXPECT_DOUBLE_EQ(truth.heading, 0.12 * std::numbers::pi / 180);
  EXPECT_THAT(refusal(changed("adjacent_m: 0.19", "adjacent_m: wide")),
              HasSubstr("truth.surveyed.adjacent_m"));
}

}  // namespace
}  // namespace lanefuse
