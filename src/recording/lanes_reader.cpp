// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/lanes_reader.hpp"

#include "core/error.hpp"
#include "recording/camera_view_codec.hpp"
#include "recording/debug_view_codec.hpp"
#include "recording/lane_estimate_codec.hpp"
#include "recording/object_codec.hpp"
#include "recording/topic_reader.hpp"
#include "recording/topics.hpp"

namespace lanefuse {
namespace {

bool is_read(std::string_view topic) {
  return topic == topic::kLanes || topic == topic::kFusedFeatures || topic == topic::kSwitches ||
         topic == topic::kRoadCourse || topic == topic::kCameraView || topic == topic::kTrackedObjects;
}

}  // namespace

class LanesReader::Session {
 public:
  explicit Session(const std::filesystem::path& path) : topics_(path, RecordingHead::Kind::lanes) {
    topics_.select(&is_read);
  }

  [[nodiscard]] const RecordingHead& head() const { return topics_.head(); }
  [[nodiscard]] ReadReport report() const { return topics_.report(); }

  bool next(LaneRecord& record) {
    record.debug = {};
    record.cameras.clear();
    record.objects.clear();
    features_.clear();
    Time debug_time{};
    while (topics_.next()) {
      // A cycle that lost its lanes leaves an inside view behind that belongs to nothing.
      if (topics_.log_time() != debug_time) {
        record.debug = {};
        record.cameras.clear();
        record.objects.clear();
        features_.clear();
      }
      debug_time = topics_.log_time();
      try {
        if (take(record)) return true;
      } catch (const Error& error) {
        topics_.refuse(error.what());
      }
    }
    return false;
  }

  void defer_features(bool defer) { defer_features_ = defer; }
  void complete(LaneRecord& record) const {
    if (!features_.empty()) decode_fused_features(features_, record.debug);
  }

 private:
  /// True once the record is whole: /out/lanes is the last message of its cycle.
  bool take(LaneRecord& record) {
    const std::string& topic = topics_.channel().topic;
    const mcap::Bytes& bytes = topics_.message().data;
    if (topic == topic::kFusedFeatures && defer_features_) features_ = bytes;
    if (topic == topic::kFusedFeatures && !defer_features_) decode_fused_features(bytes, record.debug);
    if (topic == topic::kCameraView) record.cameras.push_back(decode_camera_view(bytes));
    if (topic == topic::kTrackedObjects) record.objects = decode_objects(bytes, {}).objects;
    if (topic == topic::kSwitches) decode_switches(bytes, record.debug);
    if (topic == topic::kRoadCourse) decode_road_course(bytes, record.debug);
    if (topic != topic::kLanes) return false;
    record.estimate = decode_lane_estimate(bytes, topics_.log_time());
    return true;
  }

  TopicReader topics_;
  bool defer_features_ = false;
  mcap::Bytes features_;  // of this cycle, where they are deferred
};

LanesReader::LanesReader(const std::filesystem::path& path) : session_(std::make_unique<Session>(path)) {}
LanesReader::~LanesReader() = default;
LanesReader::LanesReader(LanesReader&&) noexcept = default;
LanesReader& LanesReader::operator=(LanesReader&&) noexcept = default;

const DriveInfo& LanesReader::drive() const { return session_->head().drive; }
const RunInfo& LanesReader::run() const { return session_->head().run; }
bool LanesReader::next(LaneRecord& record) {
  session_->defer_features(false);
  return session_->next(record);
}
bool LanesReader::next_without_features(LaneRecord& record) {
  session_->defer_features(true);
  return session_->next(record);
}
void LanesReader::complete(LaneRecord& record) const { session_->complete(record); }
ReadReport LanesReader::report() const { return session_->report(); }

}  // namespace lanefuse
