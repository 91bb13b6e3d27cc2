// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/overlay_input.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

/// An image comes into a cycle so much later at most, and cycles so far from an image are forgotten.
constexpr Duration kPatience = std::chrono::seconds(1);

SensorDescription choose(const Rig& rig, const std::optional<std::string>& name, const std::string& place) {
  std::string names;
  for (const SensorDescription& sensor : rig.sensors) {
    if (!sensor.camera) continue;
    if (!name || sensor.name == *name) return sensor;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", sensor.name);
  }
  if (names.empty()) throw input_error(place, "has no camera that hands over images");
  throw configuration_error(fmt::format("--camera {}", *name), "no camera of the drive has this name",
                            fmt::format("there are {}", names));
}

bool next_image(DriveReader& drive, std::uint32_t sensor, CameraImage& image) {
  for (Measurement measurement; drive.next(measurement);) {
    CameraImage* const found = std::get_if<CameraImage>(&measurement);
    if (!found || found->stamp.sensor_id != sensor) continue;
    image = std::move(*found);
    return true;
  }
  return false;
}

/// By the median gap between the first images, as single ones may be missing.
double frame_rate(const std::filesystem::path& path, std::uint32_t sensor) {
  constexpr std::size_t kImages = 16;
  DriveReader drive(path);
  std::vector<double> gaps;
  std::optional<Time> last;
  for (CameraImage image; gaps.size() < kImages && next_image(drive, sensor, image);) {
    if (last) gaps.push_back(to_seconds(image.stamp.measured_at - *last));
    last = image.stamp.measured_at;
  }
  if (!last) throw input_error(path.string(), "holds no image of this camera");
  if (gaps.empty()) return 1;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return std::clamp(1 / std::max(gaps[gaps.size() / 2], 1e-6), 1.0, 120.0);
}

}  // namespace

OverlayInput::OverlayInput(const std::filesystem::path& lanes, const std::filesystem::path& drive,
                           const std::optional<std::string>& camera)
    : drive_(drive),
      lanes_(lanes),
      camera_(choose(drive_.rig(), camera, drive.string())),
      frames_per_second_(frame_rate(drive, camera_.id)) {
  if (!read_cycle()) throw input_error(lanes.string(), "holds no cycle");
  first_cycle_ = window_.front()->estimate.time;
}

bool OverlayInput::read_cycle() {
  const auto record = std::make_shared<LaneRecord>();
  if (!lanes_.next(*record)) return false;
  window_.push_back(record);
  return true;
}

bool OverlayInput::find_view(OverlayFrame& frame) const {
  for (const auto& record : window_) {
    for (const CameraView& view : record->cameras) {
      if (view.sensor_id != camera_.id || view.measured_at != frame.image.stamp.measured_at) continue;
      frame.view = view;
      frame.record = record;
      return true;
    }
  }
  return false;
}

void OverlayInput::find_nearest(OverlayFrame& frame) const {
  Duration nearest = kPatience;
  for (const auto& record : window_) {
    const Duration away = std::chrono::abs(record->estimate.time - frame.image.stamp.measured_at);
    if (away > nearest) continue;
    nearest = away;
    frame.record = record;
  }
}

bool OverlayInput::next(OverlayFrame& frame) {
  frame = {};
  if (!next_image(drive_, camera_.id, frame.image)) return false;
  const Time at = frame.image.stamp.measured_at;
  frame.seconds = to_seconds(at - first_cycle_);
  while (!window_.empty() && window_.front()->estimate.time < at - kPatience) window_.pop_front();
  while (!find_view(frame)) {
    if (!window_.empty() && window_.back()->estimate.time > at + kPatience) break;
    if (!read_cycle()) break;
  }
  if (!frame.record) find_nearest(frame);
  return true;
}

}  // namespace lanefuse
