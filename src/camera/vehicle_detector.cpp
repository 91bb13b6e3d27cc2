// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_detector.hpp"

#include <algorithm>
#include <cmath>

#include "camera/ground_projection.hpp"
#include "camera/road_plane_alignment.hpp"
#include "camera/road_plane_warp.hpp"
#include "camera/vehicle_cues.hpp"
#include "camera/vehicle_shapes.hpp"
#include "camera/vehicle_tracks.hpp"

namespace lanefuse {
namespace {

constexpr int kImageColumns = 640;  ///< [px] that images are reduced to
constexpr double kLeastShadow = 0.4;
constexpr double kLeastScore = 0.3;     ///< of a box on the grid
constexpr double kRefinedScore = 0.42;  ///< of a box whose edges have been refined
constexpr double kSimilar = 0.5;        ///< overlap of two boxes on the grid that show the same
constexpr double kMostOverlap = 0.15;   ///< of two boxes in one image

/// The best ones, none overlapping a better one more than `most`.
std::vector<FoundVehicle> without_overlap(std::vector<FoundVehicle> all, double most) {
  std::stable_sort(all.begin(), all.end(),
                   [](const FoundVehicle& a, const FoundVehicle& b) { return a.score > b.score; });
  std::vector<FoundVehicle> kept;
  for (const FoundVehicle& candidate : all) {
    const bool covered = std::any_of(kept.begin(), kept.end(), [&](const FoundVehicle& better) {
      return overlap(better.shape.box, candidate.shape.box) > most;
    });
    if (!covered) kept.push_back(candidate);
  }
  return kept;
}

}  // namespace

class VehicleDetector::State {
 public:
  State(const CameraIntrinsics& intrinsics, const VehicleDetectorConfig& config)
      : camera_(intrinsics), config_(config), tracks_(config) {}

  const std::vector<VehicleBox>& detect(const Input& input) {
    if (!warp_) begin(input.pose);
    if (!shapes_fit(input.pose)) {
      shapes_ = vehicle_shapes(camera_, input.pose, reduction_, config_);
      shapes_pose_ = input.pose;
    }
    const NumberImage brightness = reduced_brightness(input.image, reduction_);
    NumberImage texture = road_texture(brightness);
    const VehicleCues cues(brightness, residual(input, texture));
    const bool first = before_.values.empty();
    tracks_.update(found(cues, row_shift(input.pose)), first ? 0 : input.seconds);
    before_ = std::move(texture);
    report();
    return boxes_;
  }

  void reset() {
    before_ = {};
    warp_.reset();
    tracks_.clear();
    boxes_.clear();
  }

 private:
  CameraModel camera_;
  VehicleDetectorConfig config_;
  Reduction reduction_;
  std::unique_ptr<RoadPlaneWarp> warp_;
  std::vector<VehicleShape> shapes_;
  CameraPose shapes_pose_;
  NumberImage before_;
  VehicleTracks tracks_;
  std::vector<VehicleBox> boxes_;

  void begin(const CameraPose& pose);
  [[nodiscard]] bool shapes_fit(const CameraPose& pose) const;
  [[nodiscard]] double row_shift(const CameraPose& pose) const;
  [[nodiscard]] NumberImage residual(const Input& input, const NumberImage& texture) const;
  [[nodiscard]] std::vector<FoundVehicle> found(const VehicleCues& cues, double row_shift) const;
  void report();
};

/// The rows from above the horizon, where near cars' roofs are, to the near end of the road.
void VehicleDetector::State::begin(const CameraPose& pose) {
  const GroundProjection projection(camera_, pose);
  const CameraIntrinsics& camera = camera_.intrinsics();
  constexpr double kAbove = 0.06;  // [rad] roofs and pitch
  const double middle = projection.horizon_row(camera.cx);
  const double edges = std::min(projection.horizon_row(0), projection.horizon_row(camera.width - 1));
  const int first = static_cast<int>(std::min(middle, edges) - kAbove * camera.fy);
  const auto near = projection.pixel({pose.mounting.x + config_.nearest, pose.mounting.y});
  const int end = near ? static_cast<int>(near->y()) : camera.height;
  const int top = std::clamp(first, 0, camera.height);
  reduction_ = reduction_to(kImageColumns, camera.width, top, std::clamp(end, top, camera.height));
  warp_ = std::make_unique<RoadPlaneWarp>(camera_, reduction_);
  shapes_.clear();
}

bool VehicleDetector::State::shapes_fit(const CameraPose& pose) const {
  if (shapes_.empty()) return false;
  const Mounting& a = pose.mounting;
  const Mounting& b = shapes_pose_.mounting;
  constexpr double kAngle = 0.005;  // [rad]
  constexpr double kPitch = 0.02;   // [rad] moves all rows alike: row_shift()
  constexpr double kHeight = 0.03;  // [m]
  return std::abs(a.pitch - b.pitch) < kPitch && std::abs(a.roll - b.roll) < kAngle &&
         std::abs(a.yaw - b.yaw) < kAngle && std::abs(a.z - b.z) < kHeight;
}

/// By how many rows of the reduced image the road of this pose lies below that of the shapes' pose.
double VehicleDetector::State::row_shift(const CameraPose& pose) const {
  constexpr double kAhead = 20;  // [m]
  const auto row = [&](const CameraPose& at) {
    return GroundProjection(camera_, at).pixel({at.mounting.x + kAhead, at.mounting.y});
  };
  const auto now = row(pose);
  const auto then = row(shapes_pose_);
  return now && then ? (now->y() - then->y()) / reduction_.factor : 0;
}

/// How much each pixel differs from what the road's motion makes of the image before; nothing above the road.
NumberImage VehicleDetector::State::residual(const Input& input, const NumberImage& texture) const {
  if (before_.values.empty() || !(input.seconds > 0)) return {};
  PlaneMotion motion;
  motion.values[PlaneMotion::kForward] = input.speed * input.seconds;
  motion.values[PlaneMotion::kYaw] = input.yaw_rate * input.seconds;
  return plane_residual(*warp_, before_, texture, warp_->map(input.pose, motion));
}

/// The boxes that score best, none much overlapping a better one.
std::vector<FoundVehicle> VehicleDetector::State::found(const VehicleCues& cues, double row_shift) const {
  std::vector<FoundVehicle> all;
  for (VehicleShape shape : shapes_) {
    shape.box.top = std::max(0.0, shape.box.top + row_shift);
    shape.box.bottom += row_shift;
    if (cues.shadow(shape) < kLeastShadow) continue;
    const double score = cues.evidence(shape).score();
    if (score >= kLeastScore) all.push_back({shape, score});
  }
  std::vector<FoundVehicle> kept;
  for (const FoundVehicle& candidate : without_overlap(std::move(all), kSimilar)) {
    const VehicleShape shape = cues.refined(candidate.shape);
    const double score = cues.evidence(shape).score();
    if (score >= kRefinedScore) kept.push_back({shape, score});
  }
  return without_overlap(std::move(kept), kMostOverlap);
}

void VehicleDetector::State::report() {
  boxes_.clear();
  for (const VehicleTracks::Track& track : tracks_.all()) {
    if (!tracks_.confirmed(track)) continue;
    const VehicleShape& shape = track.shape;
    boxes_.push_back(
        {.left = std::max(0.0, reduction_.full_column(shape.box.left)),
         .top = reduction_.full_row(shape.box.top),
         .right = std::min(camera_.intrinsics().width - 1.0, reduction_.full_column(shape.box.right)),
         .bottom = reduction_.full_row(shape.box.bottom),
         .distance = shape.distance,
         .lateral = shape.lateral,
         .width = shape.width,
         .confidence = std::clamp(track.score, 0.0, 1.0)});
  }
  std::stable_sort(boxes_.begin(), boxes_.end(),
                   [](const VehicleBox& a, const VehicleBox& b) { return a.distance < b.distance; });
}

VehicleDetector::VehicleDetector(const CameraIntrinsics& intrinsics, const VehicleDetectorConfig& config)
    : state_(std::make_unique<State>(intrinsics, config)) {}
VehicleDetector::~VehicleDetector() = default;
VehicleDetector::VehicleDetector(VehicleDetector&&) noexcept = default;
VehicleDetector& VehicleDetector::operator=(VehicleDetector&&) noexcept = default;

const std::vector<VehicleBox>& VehicleDetector::detect(const Input& input) { return state_->detect(input); }

void VehicleDetector::reset() { state_->reset(); }

}  // namespace lanefuse
