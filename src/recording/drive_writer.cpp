// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/drive_writer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/image_codec.hpp"
#include "recording/measurement_codec.hpp"
#include "recording/rig_codec.hpp"
#include "recording/topic_writer.hpp"
#include "recording/topics.hpp"
#include "recording/true_frame_codec.hpp"
#include "recording/true_road_codec.hpp"

namespace lanefuse {

namespace {

DriveInfo with_images(DriveInfo info, const Rig& rig) {
  info.images = std::any_of(rig.sensors.begin(), rig.sensors.end(),
                            [](const SensorDescription& sensor) { return sensor.camera.has_value(); });
  return info;
}

}  // namespace

class DriveWriter::Session {
 public:
  Session(const std::filesystem::path& path, const DriveInfo& info, Rig rig)
      : file_(path.string()),
        topics_(path, {RecordingHead::Kind::drive, with_images(info, rig), {}}),
        rig_(std::move(rig)) {}

  void write(const Measurement& measurement) {
    const Stamp& stamp = stamp_of(measurement);
    if (!rig_.find(stamp.sensor_id)) {
      throw input_error(file_,
                        fmt::format("a measurement of sensor {}, which is not in the rig", stamp.sensor_id));
    }
    introduce_rig(stamp.received_at);
    for (const EncodedMeasurement& message : encode(measurement)) {
      topics_.write({message.topic, stamp.sensor_id}, stamp.measured_at, stamp.received_at, message.bytes);
    }
  }

  void write(const TrueRoad& road, Time time) {
    introduce_rig(time);
    topics_.write({topic::kTrueRoad}, time, encode_true_road(road, time));
  }

  void write(const TrueFrame& frame) {
    introduce_rig(frame.time);
    topics_.write({topic::kTrueFrame}, frame.time, encode_true_frame(frame));
  }

  void close() {
    introduce_rig(Time{});
    topics_.close();
  }

 private:
  // The rig has no time of its own: it takes that of the first thing recorded, so as not to stretch the
  // drive.
  void introduce_rig(Time time) {
    if (rig_written_) return;
    topics_.write({topic::kCalibration}, time, encode_rig(rig_));
    topics_.write({topic::kTransforms}, time, encode_transforms(rig_, time));
    for (const SensorDescription& sensor : rig_.sensors) {
      if (!sensor.camera) continue;
      topics_.write({topic::kCameraCalibration, sensor.id}, time, encode_camera_calibration(sensor, time));
    }
    rig_written_ = true;
  }

  std::string file_;
  TopicWriter topics_;
  Rig rig_;
  bool rig_written_ = false;
};

DriveWriter::DriveWriter(const std::filesystem::path& path, const DriveInfo& info, const Rig& rig)
    : session_(std::make_unique<Session>(path, info, rig)) {}
DriveWriter::~DriveWriter() = default;
DriveWriter::DriveWriter(DriveWriter&&) noexcept = default;
DriveWriter& DriveWriter::operator=(DriveWriter&&) noexcept = default;

void DriveWriter::write(const Measurement& measurement) { session_->write(measurement); }
void DriveWriter::write(const TrueRoad& road, Time time) { session_->write(road, time); }
void DriveWriter::write(const TrueFrame& frame) { session_->write(frame); }
void DriveWriter::close() { session_->close(); }

}  // namespace lanefuse
