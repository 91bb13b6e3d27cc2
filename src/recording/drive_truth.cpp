// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/drive_truth.hpp"

#include "core/error.hpp"
#include "recording/topic_reader.hpp"
#include "recording/topics.hpp"
#include "recording/true_frame_codec.hpp"
#include "recording/true_road_codec.hpp"

namespace lanefuse {

DriveTruth read_truth(const std::filesystem::path& path) {
  TopicReader topics(path, RecordingHead::Kind::drive);
  topics.select(
      [](std::string_view topic) { return topic == topic::kTrueRoad || topic == topic::kTrueFrame; });
  DriveTruth truth;
  while (topics.next()) {
    try {
      if (topics.channel().topic == topic::kTrueRoad) {
        truth.road = decode_true_road(topics.message().data);
      } else {
        truth.frames.push_back(decode_true_frame(topics.message().data, topics.log_time()));
      }
    } catch (const Error& error) {
      topics.refuse(error.what());
    }
  }
  truth.report = topics.report();
  return truth;
}

}  // namespace lanefuse
