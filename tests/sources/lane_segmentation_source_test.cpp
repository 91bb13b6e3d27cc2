// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/lane_segmentation_source.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "camera/ground_projection.hpp"
#include "camera/image_codec.hpp"
#include "core/error.hpp"
#include "support/files.hpp"
#include "support/onnx_model.hpp"

namespace lanefuse {
namespace {

constexpr CameraIntrinsics kLens{640, 360, 550, 550, 319.5, 179.5, {}};
constexpr std::uint32_t kCamera = 3;

/// A network that finds what is bright, and a rig with one camera for it.
class LaneSegmentationSourceTest : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  LaneSegmentationSourceConfig config_;
  Rig rig_;

  void SetUp() override {
    testing::write_file(folder_ / "model.onnx",
                        testing::pixel_network(640, 360, {{20.0F / 3, 20.0F / 3, 20.0F / 3, -10}}, true));
    config_.network.model = folder_ / "model.onnx";
    rig_.sensors.push_back({kCamera, SensorKind::camera, "front", {0, 0, 1.3, 0, 0.02, 0}, kLens});
    rig_.sensors.push_back({4, SensorKind::long_range_radar, "radar"});
  }

  /// Grey asphalt with two bright lines, 1.8 m to either side.
  [[nodiscard]] CameraImage picture(std::uint32_t sensor = kCamera) const {
    const CameraModel camera(kLens);
    CameraPose pose;
    pose.mounting = rig_.sensors[0].mounting;
    const GroundProjection projection(camera, pose);
    Image image(kLens.width, kLens.height, 3);
    for (int v = 0; v < kLens.height; ++v) {
      for (int u = 0; u < kLens.width; ++u) {
        const auto ground = projection.ground({u, v});
        const bool paint = ground && std::abs(std::abs(ground->y()) - 1.8) < 0.08;
        std::fill_n(image.row(v) + 3 * u, 3, static_cast<std::uint8_t>(paint ? 230 : 60 + (u + v) % 7));
      }
    }
    return {{Time{std::chrono::seconds(5)}, Time{std::chrono::seconds(5)}, sensor},
            "jpeg",
            encode_jpeg(image.view(), 95)};
  }

  [[nodiscard]] SourceContext context() const { return {rig_, {}, {}}; }
};

TEST_F(LaneSegmentationSourceTest, GivesTheMarkingsOfAnImage) {
  LaneSegmentationSource source(config_);
  EXPECT_EQ(source.add(picture(), context()), (InputAccounting{.used = 1}));
  std::vector<FeatureSet> sets;
  source.collect({}, context(), sets);
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].source, Source::user);
  EXPECT_EQ(sets[0].sensor_id, kCamera);
  EXPECT_EQ(sets[0].measured_at, Time{std::chrono::seconds(5)});
  EXPECT_GT(sets[0].features.size(), 20U);
  for (const Feature& feature : sets[0].features) {
    EXPECT_NEAR(std::abs(feature.y), 1.8, 0.12) << feature.x;
    EXPECT_NEAR(feature.heading, 0, 0.1) << feature.x;
  }
  source.collect({}, context(), sets);
  EXPECT_EQ(sets.size(), 1U) << "what was collected is gone";
}

TEST_F(LaneSegmentationSourceTest, LeavesToOthersWhatIsTheirs) {
  LaneSegmentationSource source(config_);
  EXPECT_EQ(source.add(VehicleMotion{}, context()), InputAccounting{});
  EXPECT_EQ(source.add(MarkingFeatures{}, context()), InputAccounting{});
}

TEST_F(LaneSegmentationSourceTest, RejectsImagesThatCannotBeBelieved) {
  LaneSegmentationSource source(config_);
  const InputAccounting rejected{.rejected = 1};
  EXPECT_EQ(source.add(picture(99), context()), rejected);
  EXPECT_EQ(source.add(picture(4), context()), rejected) << "a radar has no lens";
  CameraImage cut = picture();
  cut.bytes.resize(cut.bytes.size() / 2);
  EXPECT_EQ(source.add(cut, context()), rejected);
  CameraImage empty = picture();
  empty.bytes.clear();
  EXPECT_EQ(source.add(empty, context()), rejected);
  std::vector<FeatureSet> sets;
  source.collect({}, context(), sets);
  EXPECT_TRUE(sets.empty());
}

TEST_F(LaneSegmentationSourceTest, ResetForgets) {
  LaneSegmentationSource source(config_);
  source.add(picture(), context());
  source.reset();
  std::vector<FeatureSet> sets;
  source.collect({}, context(), sets);
  EXPECT_TRUE(sets.empty());
}

TEST_F(LaneSegmentationSourceTest, AMissingModelIsRefusedAtTheStart) {
  config_.network.model = folder_ / "none.onnx";
  EXPECT_THROW(LaneSegmentationSource{config_}, Error);
}

}  // namespace
}  // namespace lanefuse
