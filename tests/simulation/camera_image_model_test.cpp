// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_image_model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"
#include "simulation/drive_simulation.hpp"
#include "simulation/high_resolution_camera_model.hpp"
#include "simulation/rendered_scene.hpp"
#include "simulation/serial_camera_model.hpp"

namespace lanefuse {
namespace {

using testing::Moments;

constexpr double kDegree = std::numbers::pi / 180;

TEST(CameraImageModel, StandsInForTheModelsOfTheSameName) {
  const SensorPreset preset = nominal_preset();
  const auto body = std::make_shared<BodyMotion>(1);
  const CameraImageModel serial(serial_camera_setup(preset), preset.camera_pose, body, {});
  const CameraImageModel high(high_resolution_camera_setup(preset), preset.camera_pose, body, {});
  const auto same = [](const SensorModel& images, const SensorModel& features) {
    SensorDescription described = images.description();
    EXPECT_TRUE(described.camera);
    described.camera.reset();
    EXPECT_EQ(described, features.description());
    EXPECT_EQ(images.hz(), features.hz());
  };
  same(serial, SerialCameraModel(preset, 1));
  same(high, HighResolutionCameraModel(preset, 1));
}

TEST(CameraImageModel, HandsOverImagesOfItsSize) {
  const SensorPreset preset = nominal_preset();
  const testing::RenderedScene at(1);
  CameraImageModel model(serial_camera_setup(preset), preset.camera_pose, std::make_shared<BodyMotion>(1),
                         {});
  std::vector<Measurement> measurements;
  model.observe(at.scene(), measurements);
  ASSERT_EQ(measurements.size(), 1u);
  const auto& message = std::get<CameraImage>(measurements.front());
  EXPECT_EQ(message.format, "jpeg");
  EXPECT_EQ(message.stamp.received_at - message.stamp.measured_at, std::chrono::milliseconds(60));
  const auto image = decode_image(message.bytes);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width(), 1176);
  EXPECT_EQ(image->height(), 640);
}

TEST(BodyMotion, IsAFunctionOfTimeWhoeverAsks) {
  BodyMotion often(5), seldom(5);
  for (int tick = 0; tick <= 400; ++tick) {
    const Time now = kSimulationStart + tick * kTick;
    const BodyMotion::Attitude here = often.at(now);
    if (tick % 4 != 0) continue;
    EXPECT_EQ(here.pitch, seldom.at(now).pitch);
    EXPECT_EQ(here.roll, seldom.at(now).roll);
    EXPECT_EQ(here.heave, seldom.at(now).heave);
  }
}

TEST(BodyMotion, MovesAsMuchAsItSays) {
  BodyMotion body(1);
  Moments pitch, roll, heave;
  for (int tick = 0; tick < 100'000; ++tick) {
    const BodyMotion::Attitude now = body.at(kSimulationStart + tick * kTick);
    pitch.add(now.pitch);
    roll.add(now.roll);
    heave.add(now.heave);
  }
  EXPECT_NEAR(pitch.rms(), 0.25 * kDegree, 0.02 * kDegree);
  EXPECT_NEAR(roll.rms(), 0.15 * kDegree, 0.02 * kDegree);
  EXPECT_NEAR(heave.rms(), 0.01, 0.001);
}

TEST(MountingError, IsDrawnAsMuchAsItSays) {
  Random random(1, "mountings");
  Moments pitch, yaw;
  for (int i = 0; i < 20'000; ++i) {
    const MountingError error = draw_mounting_error(random);
    pitch.add(error.pitch);
    yaw.add(error.yaw);
  }
  EXPECT_NEAR(pitch.rms(), 0.3 * kDegree, 0.01 * kDegree);
  EXPECT_NEAR(yaw.rms(), 0.2 * kDegree, 0.01 * kDegree);
}

/// Counts a drive's images, and keeps one.
struct Images {
  int serial = 0;
  int high_resolution = 0;
  int features = 0;
  std::vector<std::byte> last;
};
Images drive(std::uint64_t seed, bool serial_too) {
  SimulationConfig config;
  config.seed = seed;
  config.km = 0.008;
  config.serial_camera = serial_too;
  config.images = ImageConditions::clear;
  DriveSimulation simulation(config, nominal_preset());
  Images images;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  while (simulation.step(measurements, truth)) {
    for (const Measurement& measurement : measurements) {
      images.features += std::holds_alternative<SerialLane>(measurement) ? 1 : 0;
      images.features += std::holds_alternative<MarkingFeatures>(measurement) ? 1 : 0;
      const auto* image = std::get_if<CameraImage>(&measurement);
      if (image == nullptr) continue;
      (image->stamp.sensor_id == 2 ? images.serial : images.high_resolution) += 1;
      if (image->stamp.sensor_id == 3) images.last = image->bytes;
    }
  }
  return images;
}

TEST(DriveSimulation, HandsOverImagesInsteadOfFeatures) {
  const Images images = drive(1, true);
  EXPECT_EQ(images.features, 0);
  EXPECT_GT(images.high_resolution, 3);
  EXPECT_NEAR(images.serial, 2 * images.high_resolution, 1);
}

TEST(DriveSimulation, OneCameraLooksTheSameWithoutTheOther) {
  EXPECT_EQ(drive(1, true).last, drive(1, false).last);
}

}  // namespace
}  // namespace lanefuse
