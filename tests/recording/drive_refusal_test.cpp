// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "recording/lanes_reader.hpp"
#include "recording/topics.hpp"
#include "small_drive.hpp"
#include "support/files.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

/// A sound drive and a copy with one change.
class DriveRefusal : public ::testing::Test {
 protected:
  DriveRefusal() { testing::write_drive(folder_ / "sound.mcap", 12); }

  std::filesystem::path changed(const testing::Changes& changes) const {
    testing::rewrite(folder_ / "sound.mcap", folder_ / "changed.mcap", changes);
    return folder_ / "changed.mcap";
  }

  std::string refusal(const testing::Changes& changes) const {
    try {
      const DriveReader reader(changed(changes));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input);
      EXPECT_THAT(error.what(), HasSubstr("changed.mcap"));
      return error.what();
    }
    return "taken";
  }

  /// With another value in the metadata record "lanefuse".
  std::string refusal_of(const std::string& key, const std::string& value) const {
    return refusal({.metadata = [&](mcap::Metadata& record) {
      if (record.name == "lanefuse") record.metadata[key] = value;
    }});
  }

  testing::TemporaryFolder folder_;
};

TEST_F(DriveRefusal, UnknownVersion) {
  EXPECT_THAT(refusal_of("schema_version", "2.0"), HasSubstr("version 2.0"));
  EXPECT_THAT(refusal_of("schema_version", "new"), HasSubstr("schema_version"));
}

TEST_F(DriveRefusal, LaterMinorVersionIsTaken) { EXPECT_EQ(refusal_of("schema_version", "1.9"), "taken"); }

TEST_F(DriveRefusal, AnotherFrame) {
  EXPECT_THAT(refusal_of("frame", "rear axle"), HasSubstr("frame"));
  EXPECT_THAT(refusal_of("marking_reference", "inner edge"), HasSubstr("marking_reference"));
}

TEST_F(DriveRefusal, UnknownWitnessRule) {
  EXPECT_THAT(refusal_of("witness", "lidar"), HasSubstr("witness"));
}

TEST_F(DriveRefusal, AnotherKindOfRecording) {
  EXPECT_THAT(refusal_of("kind", "lanes"), HasSubstr("kind"));
  EXPECT_THROW(LanesReader(folder_ / "sound.mcap"), Error);
}

TEST_F(DriveRefusal, FileOfAnotherProgram) {
  EXPECT_THAT(refusal({.metadata = [](mcap::Metadata& record) { record.name += "?"; }}),
              HasSubstr("lanefuse"));
}

TEST_F(DriveRefusal, MissingChannel) {
  for (const std::string missing : {topic::kCalibration, topic::kVehicleMotion}) {
    EXPECT_THAT(refusal({.keep = [&](const mcap::Channel& channel) { return channel.topic != missing; }}),
                HasSubstr(missing));
  }
}

TEST_F(DriveRefusal, SensorThatIsNotInTheRig) {
  const auto change = [](mcap::Channel& channel) {
    if (channel.topic == topic::kRadar) channel.metadata["sensor_id"] = "88";
  };
  EXPECT_THAT(refusal({.channel = change}), HasSubstr("/in/radar"));
}

TEST_F(DriveRefusal, ChannelWithAnotherSchema) {
  const auto change = [](mcap::Channel& channel) {
    if (channel.topic == topic::kRadar) channel.topic = topic::kObjects;
  };
  EXPECT_THAT(refusal({.channel = change}), HasSubstr("osi3.SensorData"));
}

TEST_F(DriveRefusal, UnknownTopicsArePassedOver) {
  const auto change = [](mcap::Channel& channel) {
    if (channel.topic == topic::kRadar) channel.topic = "/in/lidar";
  };
  EXPECT_EQ(testing::read_drive(changed({.channel = change})).size(), 12u * 5u);
}

TEST_F(DriveRefusal, MessageThatIsNoneIsLeftOutAndCounted) {
  const auto spoil = [](mcap::Message& message, const std::string& topic) {
    if (topic == topic::kObjects && message.sequence == 3) message.data = mcap::Bytes(9, std::byte{0xff});
  };
  DriveReader reader(changed({.message = spoil}));
  int count = 0;
  for (Measurement measurement; reader.next(measurement);) ++count;
  EXPECT_EQ(count, 12 * 7 - 1);
  EXPECT_EQ(reader.report().messages_refused, 1u);
  EXPECT_THAT(reader.report().first_problem, HasSubstr("/in/objects"));
}

TEST_F(DriveRefusal, CutFileIsRefusedOrGivesWhatCameBeforeTheCut) {
  const auto bytes = testing::read_file(folder_ / "sound.mcap");
  const auto whole = testing::read_drive(folder_ / "sound.mcap");
  int salvaged = 0;
  for (std::size_t size = 1; size < bytes.size(); size += 97) {
    testing::write_file(folder_ / "cut.mcap", std::span(bytes).first(size));
    try {
      DriveReader reader(folder_ / "cut.mcap");
      std::size_t count = 0;
      for (Measurement measurement; reader.next(measurement); ++count) {
        ASSERT_LT(count, whole.size());
        EXPECT_EQ(stamp_of(measurement), stamp_of(whole[count]));
      }
      EXPECT_FALSE(reader.report().complete()) << "cut at byte " << size;
      salvaged += count > 0;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input);
    }
  }
  EXPECT_GT(salvaged, 0);
}

}  // namespace
}  // namespace lanefuse
