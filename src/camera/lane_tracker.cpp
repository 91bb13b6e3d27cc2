// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_tracker.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "camera/edge_search.hpp"
#include "camera/lane_acquisition.hpp"
#include "camera/lane_filter.hpp"
#include "camera/lane_report.hpp"
#include "camera/marking_sight.hpp"
#include "camera/paint_memory.hpp"

namespace lanefuse {
namespace {

constexpr std::array<Side, 2> kSides = {Side::left, Side::right};
constexpr std::size_t index_of(Side side) { return side == Side::left ? 0 : 1; }

EdgeSearchConfig search_config(const LaneTrackerConfig& config) {
  return {config.nearest,           config.farthest,          config.spacing,     config.gate,
          config.marking_width_min, config.marking_width_max, config.contrast_min};
}

LaneAcquisitionConfig acquisition_config(const LaneTrackerConfig& config) {
  LaneAcquisitionConfig acquisition;
  acquisition.lane_width_min = config.lane_width_min;
  acquisition.lane_width_max = config.lane_width_max;
  acquisition.contrast_min = config.contrast_min;
  return acquisition;
}

LaneFilterConfig filter_config(const LaneTrackerConfig& config) {
  LaneFilterConfig filter;
  filter.pixel_noise = config.pixel_noise;
  filter.paint_noise = config.paint_noise;
  filter.gate = config.gate;
  filter.pitch_sigma = config.pitch_sigma;
  filter.pitch_tau = config.pitch_tau;
  filter.vertical_curvature_sigma = config.vertical_curvature_sigma;
  filter.vertical_curvature_length = config.vertical_curvature_length;
  return filter;
}

constexpr double kUsualPaint = 0.12;  ///< [m]
constexpr int kProofs = 3;            ///< good images in a row that make a lane
constexpr double kDoubt = 0.25;       ///< [s] without a good image, and the lane is looked for anew
constexpr double kPatience = 0.7;     ///< [s] a side or a lane is believed without being seen

}  // namespace

const char* to_string(LaneTrackStatus status) {
  switch (status) {
    case LaneTrackStatus::lost:
      return "lost";
    case LaneTrackStatus::acquiring:
      return "acquiring";
    case LaneTrackStatus::tracking:
      return "tracking";
  }
  return "unknown";
}

struct LaneTracker::Parts {
  Parts(const CameraIntrinsics& intrinsics, const LaneTrackerConfig& its_config)
      : config(its_config),
        camera(intrinsics),
        filter(filter_config(its_config)),
        search(search_config(its_config)),
        acquisition(acquisition_config(its_config)) {
    track.windows.reserve(EdgeSearch::kMostWindows);
  }

  LaneTrackerConfig config;
  CameraModel camera;
  LaneFilter filter;
  EdgeSearch search;
  LaneAcquisition acquisition;
  NeighbourMarkings neighbours;
  LaneFilter::Fit fit;
  std::array<PaintMemory, 2> paint;
  std::array<MarkingSight, 2> sights{};
  std::array<double, 2> unseen{};  ///< [s] since each side was seen
  LaneTrack track;
  CameraPose last_pose;
  int proofs = 0;     ///< good images in a row
  double failed = 0;  ///< [s] since the last good image

  void run(const Input& input);
  void advance(const Input& input);
  void acquire(const EdgeScene& scene);
  bool measure(const EdgeScene& scene);
  void change_lane();
  void change_status(bool good, double seconds);
  [[nodiscard]] bool is_certain() const;
  void lose();
  void write(const EdgeScene& scene, const CameraPose& pose);
  [[nodiscard]] std::optional<ClothoidMeasurement> edge(Side side, const CameraPose& pose) const;
};

void LaneTracker::Parts::advance(const Input& input) {
  const double seconds = std::clamp(to_seconds(input.time - track.measured_at), 0.0, 1.0);
  // The pose is learned too: where it changes, the picture does not.
  const Mounting& was = last_pose.mounting;
  const Mounting& is = input.pose.mounting;
  filter.correct_pose(is.pitch - was.pitch, is.yaw - was.yaw, was.z > 0 ? is.z / was.z : 1);
  filter.predict(seconds, input.speed, input.yaw_rate);
  for (PaintMemory& memory : paint) memory.move(input.speed * seconds);
}

void LaneTracker::Parts::acquire(const EdgeScene& scene) {
  const auto found = acquisition.find(scene);
  if (!found) return;
  const double drift = filter.state().mean[LaneState::kDrift];
  filter.state() = *found;
  filter.state().mean[LaneState::kDrift] = drift;
  track.status = LaneTrackStatus::acquiring;
  proofs = 0;
  failed = 0;
}

bool LaneTracker::Parts::measure(const EdgeScene& scene) {
  search.search(scene, filter);
  filter.update(*scene.sight, search.edges(), fit);
  for (std::size_t s = 0; s < 2; ++s) sights[s] = judge_marking(search, fit, kSides[s]);
  const LaneState::Vector& mean = filter.state().mean;
  const double width = mean[LaneState::kWidth];
  if (width < config.lane_width_min || width > config.lane_width_max) return false;
  const int found = sights[0].found + sights[1].found;
  const int open = sights[0].open + sights[1].open;
  constexpr int kLeast = 8;
  return found >= kLeast && found > open;
}

/// The car's origin has crossed a marking: what was one side's marking is now the other's.
void LaneTracker::Parts::change_lane() {
  const LaneState::Vector& mean = filter.state().mean;
  constexpr double kHysteresis = 0.1;  // [m]
  if (std::abs(mean[LaneState::kOffset]) < mean[LaneState::kWidth] / 2 + kHysteresis) return;
  // The lane's middle is to the right of a car that has left it to the left.
  const Side side = mean[LaneState::kOffset] < 0 ? Side::left : Side::right;
  const std::size_t crossed = index_of(side);
  filter.cross_marking(side, paint[crossed].width().value_or(kUsualPaint));
  paint[1 - crossed] = paint[crossed];
  paint[crossed].forget();
  unseen[1 - crossed] = unseen[crossed];
  unseen[crossed] = kPatience;
  track.lane_changed = true;
}

void LaneTracker::Parts::lose() {
  track.status = LaneTrackStatus::lost;
  proofs = 0;
  failed = 0;
  unseen.fill(kPatience);
  for (PaintMemory& memory : paint) memory.forget();
}

/// Both markings were seen in so many rows, with so little that contradicts, that one image is proof enough.
bool LaneTracker::Parts::is_certain() const {
  constexpr int kMany = 12;
  constexpr int kContradicted = 4;
  return std::all_of(sights.begin(), sights.end(), [](const MarkingSight& sight) {
    return sight.found >= kMany && sight.found >= kContradicted * sight.open;
  });
}

void LaneTracker::Parts::change_status(bool good, double seconds) {
  failed = good ? 0 : failed + seconds;
  proofs = good ? proofs + (is_certain() ? kProofs : 1) : 0;
  for (std::size_t s = 0; s < 2; ++s) {
    unseen[s] = good && sights[s].found >= 3 ? 0 : unseen[s] + seconds;
  }
  if (track.status != LaneTrackStatus::tracking && proofs >= kProofs) {
    track.status = LaneTrackStatus::tracking;
  } else if (track.status == LaneTrackStatus::acquiring && !good) {
    lose();
  } else if (failed > kPatience) {
    lose();
  }
}

void LaneTracker::Parts::run(const Input& input) {
  assert(input.image.width == camera.intrinsics().width && input.image.height == camera.intrinsics().height);
  const RoadSight sight(camera, input.pose);
  EdgeScene scene;
  scene.image = input.image;
  scene.sight = &sight;
  scene.vehicles = input.vehicles;
  for (std::size_t s = 0; s < 2; ++s) {
    scene.marking_widths[s] = paint[s].width().value_or(kUsualPaint);
    scene.colours[s] = paint[s].evidence().colour;
  }
  track.lane_changed = false;
  const double seconds = std::max(0.0, to_seconds(input.time - track.measured_at));
  if (track.status != LaneTrackStatus::lost) advance(input);
  if (track.status == LaneTrackStatus::lost || failed > kDoubt) acquire(scene);
  track.measured_at = input.time;
  last_pose = input.pose;
  if (track.status != LaneTrackStatus::lost) {
    const bool good = measure(scene);
    if (good) remember_paint(search, fit, paint);
    change_status(good, seconds);
    if (track.status != LaneTrackStatus::lost) change_lane();
  }
  write(scene, input.pose);
}

std::optional<ClothoidMeasurement> LaneTracker::Parts::edge(Side side, const CameraPose& pose) const {
  const std::size_t s = index_of(side);
  constexpr int kLeast = 3;  // windows
  if (track.status != LaneTrackStatus::tracking || unseen[s] >= kPatience || sights[s].found < kLeast) {
    return {};
  }
  ClothoidMeasurement edge = measured_edge(filter, side, pose);
  edge.range_begin = sights[s].begin;
  edge.range_end = sights[s].end;
  edge.marking = paint[s].evidence();
  const double expected = edge.marking.type == MarkingType::solid ? 0.9 : 0.3;
  edge.confidence = std::clamp(sights[s].support / expected, 0.05, 1.0) * (1 - unseen[s] / kPatience);
  return edge;
}

void LaneTracker::Parts::write(const EdgeScene& scene, const CameraPose& pose) {
  track.left = edge(Side::left, pose);
  track.right = edge(Side::right, pose);
  track.left_marking_width = paint[0].width();
  track.right_marking_width = paint[1].width();
  write_state(filter.state(), track);
  track.range = 0;
  track.quality = 0;
  for (const auto* side : {&track.left, &track.right}) {
    if (!*side) continue;
    track.range = std::max(track.range, (*side)->range_end);
    track.quality += (*side)->confidence / 2;
  }
  track.left_neighbour.reset();
  track.right_neighbour.reset();
  if (track.status == LaneTrackStatus::tracking) {
    track.left_neighbour = neighbours.measure(scene, filter.state().mean, Side::left);
    track.right_neighbour = neighbours.measure(scene, filter.state().mean, Side::right);
  }
  track.windows.clear();
  if (track.status != LaneTrackStatus::lost) list_windows(search, fit, track.windows);
}

LaneTracker::LaneTracker(const CameraIntrinsics& intrinsics, const LaneTrackerConfig& config)
    : parts_(std::make_unique<Parts>(intrinsics, config)) {
  reset();
}
LaneTracker::~LaneTracker() = default;
LaneTracker::LaneTracker(LaneTracker&&) noexcept = default;
LaneTracker& LaneTracker::operator=(LaneTracker&&) noexcept = default;

const LaneTrack& LaneTracker::track(const Input& input) {
  parts_->run(input);
  return parts_->track;
}

const LaneTrack& LaneTracker::last() const { return parts_->track; }

void LaneTracker::reset() {
  parts_->lose();
  parts_->track.left.reset();
  parts_->track.right.reset();
  parts_->track.windows.clear();
}

}  // namespace lanefuse
