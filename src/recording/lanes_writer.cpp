// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/lanes_writer.hpp"

#include "recording/camera_view_codec.hpp"
#include "recording/debug_view_codec.hpp"
#include "recording/lane_estimate_codec.hpp"
#include "recording/object_codec.hpp"
#include "recording/topic_writer.hpp"
#include "recording/topics.hpp"
#include "recording/viewer_codec.hpp"

namespace lanefuse {

class LanesWriter::Session {
 public:
  Session(const std::filesystem::path& path, const DriveInfo& drive, const RunInfo& run)
      : topics_(path, {RecordingHead::Kind::lanes, drive, run}) {}

  void write(const LaneEstimate& estimate, const DebugView& debug, std::span<const CameraView> cameras,
             std::span<const TrackedObject> objects) {
    const Time time = estimate.time;
    for (const CameraView& view : cameras) {
      topics_.write({topic::kCameraView, view.sensor_id}, view.measured_at, time, encode_camera_view(view));
    }
    if (!objects.empty()) {
      const ObjectList list{{time, time, 0}, {objects.begin(), objects.end()}};
      topics_.write({topic::kTrackedObjects}, time, encode_objects(list));
    }
    topics_.write({topic::kFusedFeatures}, time, encode_fused_features(debug));
    topics_.write({topic::kSwitches}, time, encode_switches(debug));
    topics_.write({topic::kRoadCourse}, time, encode_road_course(debug));
    topics_.write({topic::kLaneBoundaries}, time, encode_detected_boundaries(estimate));
    topics_.write({topic::kScene}, time, encode_scene(estimate, debug));
    write_status(estimate);
    // Last of its cycle: a reader that has come to it has seen the rest.
    topics_.write({topic::kLanes}, time, encode_lane_estimate(estimate));
  }

  void close() { topics_.close(); }

 private:
  void write_status(const LaneEstimate& estimate) {
    const auto status = std::make_pair(estimate.status, estimate.reason);
    if (last_status_ == status) return;
    last_status_ = status;
    topics_.write({topic::kStatus}, estimate.time, encode_status(estimate));
  }

  TopicWriter topics_;
  std::optional<std::pair<EstimateStatus, StatusReason>> last_status_;
};

LanesWriter::LanesWriter(const std::filesystem::path& path, const DriveInfo& drive, const RunInfo& run)
    : session_(std::make_unique<Session>(path, drive, run)) {}
LanesWriter::~LanesWriter() = default;
LanesWriter::LanesWriter(LanesWriter&&) noexcept = default;
LanesWriter& LanesWriter::operator=(LanesWriter&&) noexcept = default;

void LanesWriter::write(const LaneEstimate& estimate, const DebugView& debug,
                        std::span<const CameraView> cameras, std::span<const TrackedObject> objects) {
  session_->write(estimate, debug, cameras, objects);
}
void LanesWriter::close() { session_->close(); }

}  // namespace lanefuse
