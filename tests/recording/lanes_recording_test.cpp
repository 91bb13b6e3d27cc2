// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/lane_description.hpp"
#include "fields.hpp"
#include "foxglove/scene.pb.h"
#include "osi3/osi_sensordata.pb.h"
#include "recording/lanes_reader.hpp"
#include "recording/lanes_writer.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/topics.hpp"
#include "small_drive.hpp"
#include "support/files.hpp"

namespace lanefuse {
namespace {

const RunInfo kRun{WitnessRule::radar_only, "graph", "feed1234"};

Boundary boundary(std::uint64_t id, double offset) {
  Boundary made;
  made.id = id;
  made.clothoid = {offset, 0.01, 1e-4, 0};
  made.covariance.setIdentity();
  made.range_end = 61;
  made.confidence = 0.9;
  made.marking = {MarkingType::dashed, MarkingColour::yellow};
  made.support = {1, 2, 3, 4, 5, 6};
  sample_points(made);
  return made;
}

LaneEstimate estimate(int cycle) {
  LaneEstimate made;
  made.time = testing::stamp_at(80 * cycle, 0).measured_at;
  made.status = cycle < 2 ? EstimateStatus::invalid : EstimateStatus::ok;
  made.reason = cycle < 2 ? StatusReason::warming_up : StatusReason::none;
  made.boundaries = {boundary(1, 1.8), boundary(2, -1.8)};
  made.lanes = {{.id = 1, .left_boundary = 1, .right_boundary = 2}};
  describe_lanes(made);
  return made;
}

DebugView debug_view(int cycle) {
  DebugView view;
  view.features = {{.feature = {.x = 1.0 * cycle, .source = Source::objects}}, {.outlier = true}};
  view.switches = {{.track_id = 4, .to = {5, 1}, .value = 0.1}, {.track_id = 5, .value = 0.9}};
  view.base_clothoid = Clothoid{0, 0, 1e-4, 0};
  view.graph = {1, 2, 3};
  return view;
}

std::filesystem::path write_lanes(const std::filesystem::path& path, int cycles) {
  LanesWriter writer(path, testing::kInfo, kRun);
  for (int i = 0; i < cycles; ++i) writer.write(estimate(i), debug_view(i));
  writer.close();
  return path;
}

template <class Message>
std::vector<Message> messages_on(const std::filesystem::path& path, const std::string& topic) {
  mcap::Reader reader(path);
  reader.select([&](const mcap::Channel& channel) { return channel.topic == topic; });
  std::vector<Message> messages;
  for (mcap::Message raw; reader.next(raw);) {
    EXPECT_TRUE(messages.emplace_back().ParseFromArray(raw.data.data(), static_cast<int>(raw.data.size())));
  }
  return messages;
}

TEST(LanesRecording, CyclesComeBackWhole) {
  const testing::TemporaryFolder folder;
  LanesReader reader(write_lanes(folder / "lanes.mcap", 50));
  EXPECT_EQ(reader.drive(), testing::kInfo);
  EXPECT_EQ(reader.run(), kRun);
  LaneRecord record;
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(reader.next(record)) << i;
    EXPECT_EQ(fields(record.estimate), fields(estimate(i)));
    EXPECT_EQ(fields(record.debug), fields(debug_view(i)));
  }
  EXPECT_FALSE(reader.next(record));
  EXPECT_TRUE(reader.report().complete());
}

TEST(LanesRecording, SameCyclesGiveTheSameBytes) {
  const testing::TemporaryFolder folder;
  EXPECT_EQ(testing::read_file(write_lanes(folder / "one.mcap", 20)),
            testing::read_file(write_lanes(folder / "two.mcap", 20)));
}

TEST(LanesRecording, InsideViewOfACycleThatLostItsLanesIsNotLentToTheNext) {
  const testing::TemporaryFolder folder;
  write_lanes(folder / "lanes.mcap", 3);
  const auto lose_second_lanes_and_third_view = [](mcap::Message& message, const std::string& topic) {
    const bool lost = (topic == topic::kLanes && message.sequence == 1) ||
                      (topic == topic::kFusedFeatures && message.sequence == 2);
    if (lost) message.data = mcap::Bytes(5, std::byte{0xff});
  };
  testing::rewrite(folder / "lanes.mcap", folder / "torn.mcap",
                   {.message = lose_second_lanes_and_third_view});
  LanesReader reader(folder / "torn.mcap");
  LaneRecord record;
  ASSERT_TRUE(reader.next(record));
  ASSERT_TRUE(reader.next(record));
  EXPECT_EQ(record.estimate.time, estimate(2).time);
  EXPECT_TRUE(record.debug.features.empty());
  EXPECT_EQ(record.debug.switches.size(), 2u);
  EXPECT_FALSE(reader.next(record));
  EXPECT_EQ(reader.report().messages_refused, 2u);
}

TEST(LanesRecording, OtherToolsFindBoundariesAtMostTwoMetresApart) {
  const testing::TemporaryFolder folder;
  const auto messages =
      messages_on<osi3::SensorData>(write_lanes(folder / "lanes.mcap", 1), topic::kLaneBoundaries);
  ASSERT_EQ(messages.size(), 1u);
  ASSERT_EQ(messages[0].lane_boundary_size(), 2);
  const osi3::DetectedLaneBoundary& left = messages[0].lane_boundary(0);
  ASSERT_EQ(left.boundary_line_size(), 31);
  ASSERT_EQ(left.boundary_line_rmse_size(), 31);
  EXPECT_EQ(left.candidate(0).classification().type(), osi3::LaneBoundary::Classification::TYPE_DASHED_LINE);
  for (int i = 1; i < left.boundary_line_size(); ++i) {
    EXPECT_LE(left.boundary_line(i).position().x() - left.boundary_line(i - 1).position().x(), 2.0);
  }
}

TEST(LanesRecording, OtherToolsFindLanesWithTheirMiddles) {
  const testing::TemporaryFolder folder;
  const auto messages =
      messages_on<osi3::SensorData>(write_lanes(folder / "lanes.mcap", 1), topic::kLaneBoundaries);
  ASSERT_EQ(messages.at(0).lane_size(), 1);
  const auto& lane = messages[0].lane(0).candidate(0).classification();
  EXPECT_TRUE(lane.is_host_vehicle_lane());
  EXPECT_EQ(lane.left_lane_boundary_id(0).value(), 1u);
  EXPECT_EQ(lane.right_lane_boundary_id(0).value(), 2u);
  ASSERT_EQ(lane.centerline_size(), 7);
  EXPECT_EQ(lane.centerline(6).x(), 60);
  EXPECT_NEAR(lane.centerline(6).y(), 0.01 * 60 + 1e-4 * 60 * 60 / 2, 1e-9);
}

TEST(LanesRecording, ViewersSeeBoundariesFeaturesAndSwitchedOffEdges) {
  const testing::TemporaryFolder folder;
  const auto scenes =
      messages_on<foxglove::SceneUpdate>(write_lanes(folder / "lanes.mcap", 1), topic::kScene);
  ASSERT_EQ(scenes.size(), 1u);
  ASSERT_EQ(scenes[0].entities_size(), 4);
  EXPECT_EQ(scenes[0].entities(0).frame_id(), "vehicle");
  EXPECT_EQ(scenes[0].entities(0).lines_size(), 2) << "two boundaries";
  int dashes = 0;
  for (const auto& line : scenes[0].entities(1).lines()) dashes += line.points_size() / 2;
  EXPECT_EQ(dashes, 2) << "two fused features";
  EXPECT_EQ(scenes[0].entities(2).lines_size(), 1) << "the road course";
  EXPECT_EQ(scenes[0].entities(3).lines_size(), 1) << "one of two switches is off";
}

TEST(LanesRecording, StatusIsLoggedWhenItChanges) {
  const testing::TemporaryFolder folder;
  const auto path = write_lanes(folder / "lanes.mcap", 10);
  mcap::Reader reader(path);
  reader.select([](const mcap::Channel& channel) { return channel.topic == topic::kStatus; });
  int count = 0;
  while (reader.next()) ++count;
  EXPECT_EQ(count, 2) << "invalid at first, then ok";
}

TEST(LanesRecording, FeaturesMayWaitUntilTheyAreWanted) {
  const testing::TemporaryFolder folder;
  const auto path = write_lanes(folder / "lanes.mcap", 3);
  LanesReader at_once(path), later(path);
  LaneRecord whole, lean;
  for (int cycle = 0; cycle < 3; ++cycle) {
    ASSERT_TRUE(at_once.next(whole));
    ASSERT_TRUE(later.next_without_features(lean));
    EXPECT_TRUE(lean.debug.features.empty());
    EXPECT_EQ(lean.debug.switches.size(), 2U);
    later.complete(lean);
    ASSERT_EQ(lean.debug.features.size(), whole.debug.features.size());
    EXPECT_EQ(lean.debug.features[0].feature.x, whole.debug.features[0].feature.x);
    EXPECT_EQ(lean.estimate.time, whole.estimate.time);
  }
  EXPECT_FALSE(later.next_without_features(lean));
}

}  // namespace
}  // namespace lanefuse
