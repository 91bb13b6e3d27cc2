// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/fusion_drive.hpp"

/// The window's memory is bounded: of what does not fit, the least informative goes first, and is counted.
namespace lanefuse {
namespace {

using Id = SlidingWindow::Id;

Time at(double seconds) { return from_nanoseconds(0) + from_seconds(seconds); }

/// A window of at most 64 features, 320 measurements and 32 ties; a sixteenth of each is kept free.
class Bounds : public ::testing::Test {
 protected:
  Bounds() {
    config_.max_features = 64;
    config_.max_measurements = 320;
    config_.max_ties = 32;
    window_.advance(at(0), {});
  }

  /// A feature that `looks` sensors have measured, each with this information across.
  Id seen(double across, std::uint32_t looks = 1, double seconds = 0) {
    const double x = 10 + static_cast<double>(window_.feature_count());
    const Id id = window_.add_feature({x, 0, 0}, at(seconds)).value();
    for (std::uint32_t sensor = 0; sensor < looks; ++sensor)
      window_.add_measurement(window_.graph().chain()[0], id, {x, 0, 0}, {1, 0, across, 1},
                              {Source::serial_camera, sensor});
    return id;
  }
  void tie(Id from, Id to) { window_.add_tie(TieKind::smoothing, {from, to, {}}, {}); }
  void expect_alive(const std::vector<Id>& ids, bool alive) const {
    for (const Id id : ids) EXPECT_EQ(window_.graph().is_alive(id), alive) << id;
  }

  FusionConfig config_;
  SlidingWindow window_{config_};
};

TEST_F(Bounds, ForgetTheLeastInformativeFeaturesFirst) {
  std::vector<Id> little, much;
  for (int i = 0; i < 60; ++i) (i % 15 == 7 ? little : much).push_back(seen(i % 15 == 7 ? 5 : 50 + i));
  window_.prune(at(1), {});
  EXPECT_EQ(window_.crowded_out(), 0U) << "60 leave a sixteenth free";
  for (int i = 0; i < 4; ++i) much.push_back(seen(1000));
  EXPECT_FALSE(window_.add_feature({10, 0, 0}, at(0)));
  window_.prune(at(1), {});
  EXPECT_EQ(window_.crowded_out(), 4U);
  expect_alive(little, false);
  expect_alive(much, true);
  window_.prune(at(2), {});
  EXPECT_EQ(window_.crowded_out(), 4U) << "no more than it has to";
  EXPECT_TRUE(window_.add_feature({10, 0, 0}, at(2)));
}

TEST_F(Bounds, SpareWhatHasJustBeenSeen) {
  std::vector<Id> old, fresh;
  for (int i = 0; i < 32; ++i) old.push_back(seen(100 + i));
  for (int i = 0; i < 32; ++i) fresh.push_back(seen(1, 1, 1));
  window_.prune(at(1), {});
  expect_alive(fresh, true);
  expect_alive({old.begin(), old.begin() + 4}, false);
  expect_alive({old.begin() + 4, old.end()}, true);
}

TEST_F(Bounds, AreThoseOfMeasurementsToo) {
  std::vector<Id> little, much;
  for (int i = 0; i < 16; ++i) much.push_back(seen(100, 19));
  for (int i = 0; i < 4; ++i) little.push_back(seen(100, 4));
  ASSERT_EQ(window_.graph().observation_count(), 320U);
  EXPECT_TRUE(window_.is_full_of_measurements());
  EXPECT_FALSE(window_.add_feature({10, 0, 0}, at(0)));
  window_.prune(at(1), {});
  EXPECT_FALSE(window_.is_full_of_measurements());
  EXPECT_EQ(window_.crowded_out(), 5U) << "four of four looks and one of nineteen make room for 20";
  EXPECT_EQ(window_.graph().observation_count(), 320U - 4 * 4 - 19);
  expect_alive(little, false);
}

TEST_F(Bounds, AreThoseOfTiesTooAndOnlyTiedFeaturesMakeRoomForTies) {
  std::vector<Id> tied, untied;
  for (int i = 0; i < 33; ++i) tied.push_back(seen(100 + i));
  for (int i = 0; i < 10; ++i) untied.push_back(seen(1));
  for (std::size_t i = 0; i + 1 < tied.size(); ++i) tie(tied[i], tied[i + 1]);
  EXPECT_EQ(window_.graph().tie_count(), 32U);
  tie(tied[0], tied[9]);
  EXPECT_EQ(window_.graph().tie_count(), 32U) << "no more than may be";
  window_.prune(at(1), {});
  EXPECT_EQ(window_.graph().tie_count(), 30U);
  EXPECT_EQ(window_.crowded_out(), 2U);
  expect_alive({tied[0], tied[1]}, false);
  expect_alive(untied, true);
}

/// Features all about the road, more than the window holds, of which some are of two witnesses.
std::vector<FeatureSet> flood(const testing::FusionDrive& drive, int cycle) {
  std::vector<Feature> markings, vehicles;
  for (int i = 0; i < 60; ++i) {
    const double y = -9 + 0.3 * ((i * 7 + cycle) % 60);
    markings.push_back(testing::feature_at({3 + 1.1 * i, y, 0}, 0.05 + 0.01 * (i % 9)));
  }
  for (std::int64_t track = 0; track < 6; ++track) {
    const double x = 10 + 9 * static_cast<double>(track) + 0.3 * (cycle % 20);
    vehicles.push_back(testing::witnessed(track, Side::left, {x, 1.75, 0}));
    vehicles.push_back(testing::witnessed(track, Side::right, {x, -1.75, 0}));
  }
  FeatureSet witnesses = drive.set(Source::objects, vehicles, 2);
  witnesses.lane_width = LaneWidth{3.5, 0.1};
  return {drive.set(Source::serial_camera, markings, 1), witnesses};
}

TEST(BoundedWindow, StaysWithinItsMemoryForThousandsOfCycles) {
  FusionConfig config;
  config.max_features = 256;
  config.max_measurements = 1024;
  config.max_ties = 64;
  testing::FusionDrive drive(config);
  std::uint64_t used = 0;
  std::uint64_t before = 0;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    const FusionResult result = drive.step({0.9 * cycle, 0, 0}, flood(drive, cycle));
    ASSERT_TRUE(result.solve.ok()) << cycle;
    const WindowGraph& graph = drive.window().graph();
    ASSERT_LE(graph.landmark_slots(), config.max_features) << cycle;
    ASSERT_LE(graph.observation_count(), config.max_measurements) << cycle;
    ASSERT_LE(graph.tie_slots(), config.max_ties) << cycle;
    ASSERT_LE(graph.pose_slots(), 128U) << cycle;
    ASSERT_EQ(result.features.used + result.features.dropped, 72U) << cycle;
    used += result.features.used;
    if (cycle == 1500) before = drive.window().crowded_out();
  }
  EXPECT_GT(before, 0U);
  EXPECT_GT(drive.window().crowded_out(), before) << "it never comes to rest";
  EXPECT_GT(used, 3000U * 36) << "most still finds room";
}

}  // namespace
}  // namespace lanefuse
