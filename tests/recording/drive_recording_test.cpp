// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "recording/drive_truth.hpp"
#include "recording/mcap_survey.hpp"
#include "recording/topics.hpp"
#include "small_drive.hpp"
#include "support/files.hpp"

namespace lanefuse {
namespace {

using testing::TemporaryFolder;

void expect_same(const std::vector<Measurement>& actual, const std::vector<Measurement>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].index(), expected[i].index()) << "measurement " << i;
    std::visit(
        [&](const auto& measurement) {
          using Kind = std::decay_t<decltype(measurement)>;
          EXPECT_EQ(fields(measurement), fields(std::get<Kind>(expected[i]))) << "measurement " << i;
        },
        actual[i]);
  }
}

TEST(DriveRecording, ReplaysWhatWasRecorded) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 40);
  DriveReader reader(folder / "drive.mcap");
  EXPECT_EQ(reader.info(), testing::kInfo);
  EXPECT_EQ(reader.rig(), testing::small_rig());
  std::vector<Measurement> expected;
  for (int i = 0; i < 40; ++i) {
    for (const Measurement& measurement : testing::tick(100 * i)) expected.push_back(measurement);
  }
  expect_same(testing::read_drive(folder / "drive.mcap"), expected);
}

TEST(DriveRecording, ReplaysInOrderOfArrival) {
  const TemporaryFolder folder;
  DriveWriter writer(folder / "drive.mcap", testing::kInfo, testing::small_rig());
  const auto measurements = testing::tick(0);
  for (auto it = measurements.rbegin(); it != measurements.rend(); ++it) writer.write(*it);
  writer.close();
  Time last{};
  for (const Measurement& measurement : testing::read_drive(folder / "drive.mcap")) {
    EXPECT_GE(stamp_of(measurement).received_at, last);
    last = stamp_of(measurement).received_at;
  }
}

TEST(DriveRecording, SameWritesGiveTheSameBytes) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "one.mcap", 40);
  testing::write_drive(folder / "two.mcap", 40);
  EXPECT_EQ(testing::read_file(folder / "one.mcap"), testing::read_file(folder / "two.mcap"));
}

TEST(DriveRecording, CarriesNoLabels) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "plain.mcap", 1, false);
  DriveWriter writer(folder / "labelled.mcap", testing::kInfo, testing::small_rig());
  for (Measurement& measurement : testing::tick(0)) {
    if (auto* lane = std::get_if<SerialLane>(&measurement)) lane->left->label = 1;
    if (auto* markings = std::get_if<MarkingFeatures>(&measurement)) markings->features[0].label = kNoLine;
    if (auto* list = std::get_if<ObjectList>(&measurement)) list->objects[0].left_label = 2;
    writer.write(measurement);
  }
  writer.close();
  EXPECT_EQ(testing::read_file(folder / "labelled.mcap"), testing::read_file(folder / "plain.mcap"));
}

TEST(DriveRecording, TruthIsReadBackOnRequest) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 25);
  const DriveTruth truth = read_truth(folder / "drive.mcap");
  EXPECT_TRUE(truth.report.complete());
  ASSERT_TRUE(truth.road);
  EXPECT_EQ(fields(*truth.road), fields(testing::true_road()));
  ASSERT_EQ(truth.frames.size(), 25u);
  EXPECT_EQ(truth.frames[24].time, testing::true_frame(2400).time);
  EXPECT_NEAR(truth.frames[24].world_from_vehicle.x, 48, 1e-9);
}

TEST(DriveRecording, DriveWithoutTruthHasNone) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 3, false);
  const DriveTruth truth = read_truth(folder / "drive.mcap");
  EXPECT_FALSE(truth.road);
  EXPECT_TRUE(truth.frames.empty());
}

TEST(DriveRecording, StrippedOfItsTruthItReplaysTheSame) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 40);
  strip_truth(folder / "drive.mcap", folder / "stripped.mcap");
  const mcap::Reader stripped(folder / "stripped.mcap");
  for (const auto& [id, channel] : stripped.channels())
    EXPECT_FALSE(topic::is_truth(channel.topic)) << channel.topic;
  for (const auto& [id, schema] : stripped.schemas()) EXPECT_NE(schema.name, "osi3.GroundTruth");
  EXPECT_TRUE(read_truth(folder / "stripped.mcap").frames.empty());
  expect_same(testing::read_drive(folder / "stripped.mcap"), testing::read_drive(folder / "drive.mcap"));
}

/// The chunks of a file that hold truth. Fails where one holds other messages beside it.
std::vector<mcap::Block> truth_chunks(const std::filesystem::path& path) {
  const mcap::Survey survey = mcap::survey(mcap::InputFile(path));
  std::vector<mcap::Block> chunks;
  for (const mcap::Block& block : survey.blocks) {
    const auto holds_truth = [&](std::uint16_t id) { return topic::is_truth(survey.channels.at(id).topic); };
    const auto count = std::count_if(block.channels.begin(), block.channels.end(), holds_truth);
    if (count == 0) continue;
    EXPECT_EQ(count, static_cast<std::ptrdiff_t>(block.channels.size())) << "chunk at byte " << block.offset;
    chunks.push_back(block);
  }
  return chunks;
}

TEST(DriveRecording, TruthLiesInChunksThatReplayNeverOpens) {
  const TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 40);
  const auto chunks = truth_chunks(folder / "drive.mcap");
  EXPECT_GE(chunks.size(), 4u) << "one a second";
  auto bytes = testing::read_file(folder / "drive.mcap");
  for (const mcap::Block& chunk : chunks) bytes[chunk.offset + chunk.length / 2] ^= std::byte{0xff};
  testing::write_file(folder / "spoilt.mcap", bytes);
  EXPECT_GE(read_truth(folder / "spoilt.mcap").report.chunks_lost, 4u);
  DriveReader reader(folder / "spoilt.mcap");
  std::vector<Measurement> measurements;
  for (Measurement measurement; reader.next(measurement);) measurements.push_back(measurement);
  expect_same(measurements, testing::read_drive(folder / "drive.mcap"));
  EXPECT_EQ(reader.report().chunks_lost, 0u);
}

TEST(DriveWriter, RefusesWhatNoReaderWouldTake) {
  const TemporaryFolder folder;
  DriveWriter writer(folder / "drive.mcap", testing::kInfo, testing::small_rig());
  EXPECT_THROW(writer.write(VehicleMotion{testing::stamp_at(0, 77), 20.0, {}, {}}), Error);
  VehicleMotion before_the_epoch{{from_nanoseconds(-1), from_nanoseconds(1), 1}, 20.0, {}, {}};
  EXPECT_THROW(writer.write(before_the_epoch), Error);
}

TEST(DriveWriter, LeavesNothingBehindWithoutClose) {
  const TemporaryFolder folder;
  {
    DriveWriter writer(folder / "drive.mcap", testing::kInfo, testing::small_rig());
    writer.write(testing::tick(0)[0]);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace lanefuse
