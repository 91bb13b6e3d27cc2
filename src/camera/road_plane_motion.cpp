// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_plane_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/ground_projection.hpp"
#include "camera/road_plane_alignment.hpp"
#include "camera/road_plane_warp.hpp"
#include "camera/still_cells.hpp"

namespace lanefuse {
namespace {

using Prior = Gaussian<PlaneMotion::kSize>;
constexpr int kImageColumns = 640;  ///< [px] that images are reduced to
constexpr double kRadians = std::numbers::pi / 180;
/// Below this share of fitting texture an image is not believed.
constexpr double kLeastQuality = 0.15;

/// What the filter carries: speed, acceleration, yaw rate, and the pitch against the pose.
enum StateIndex : int { kSpeed, kAcceleration, kYawRate, kPitch, kStateSize };
using MotionState = Gaussian<kStateSize>;

double squared(double value) { return value * value; }

}  // namespace

class RoadPlaneMotion::State {
 public:
  State(const CameraIntrinsics& intrinsics, const RoadPlaneMotionConfig& config)
      : camera_(intrinsics), config_(config) {}

  const RoadPlaneMotionEstimate& update(const Input& input) {
    if (!warp_) begin(input.pose);
    NumberImage texture = road_texture(reduced_brightness(input.image, reduction_));
    estimate_ = {};
    if (!before_.values.empty()) follow(input, texture);
    before_ = std::move(texture);
    return estimate_;
  }

  void reset() {
    before_ = {};
    locked_ = false;
    warp_.reset();
  }

 private:
  CameraModel camera_;
  RoadPlaneMotionConfig config_;
  Reduction reduction_;
  std::unique_ptr<RoadPlaneWarp> warp_;
  std::vector<RoadPlaneWarp::Place> places_;
  std::vector<RoadPlaneWarp::Jacobian> unmoved_jacobians_;
  std::unique_ptr<StillCells> still_cells_;
  NumberImage before_;
  MotionState state_;
  bool locked_ = false;
  int misses_ = 0;
  RoadPlaneMotionEstimate estimate_;

  void begin(const CameraPose& pose);
  void follow(const Input& input, const NumberImage& texture);
  void report(const RoadPlaneAlignment& alignment, double seconds);
  [[nodiscard]] std::vector<std::uint8_t> believed_cells(const Input& input) const;
  [[nodiscard]] double searched_way(const RoadPair& pair, const Input& input) const;
  [[nodiscard]] Prior prior_of(double seconds) const;
  void predict_state(double seconds);
  void take(const RoadPlaneAlignment& alignment, double seconds);
  void start_at(double speed);
};

/// The rows that show the patch of road, from the horizon's side to the near end.
void RoadPlaneMotion::State::begin(const CameraPose& pose) {
  const GroundProjection projection(camera_, pose);
  const CameraIntrinsics& camera = camera_.intrinsics();
  const auto row_at = [&](double ahead, int otherwise) {
    const auto pixel = projection.pixel({pose.mounting.x + ahead, pose.mounting.y});
    return pixel ? std::clamp(static_cast<int>(pixel->y()), 0, camera.height) : otherwise;
  };
  const int first = row_at(config_.farthest, 0);
  const int end = std::max(first, row_at(config_.nearest, camera.height));
  reduction_ = reduction_to(kImageColumns, camera.width, first, end);
  warp_ = std::make_unique<RoadPlaneWarp>(camera_, reduction_);
  places_ = warp_->cell_places(pose);
  unmoved_jacobians_ = warp_->jacobians(pose, {});
  still_cells_ = std::make_unique<StillCells>(places_.size());
}

std::vector<std::uint8_t> RoadPlaneMotion::State::believed_cells(const Input& input) const {
  std::vector<std::uint8_t> believed(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const RoadPlaneWarp::Place& place = places_[i];
    believed[i] = place.on_road && std::abs(place.y - input.pose.mounting.y) < config_.half_width;
  }
  constexpr int kCell = RoadPlaneWarp::kCell;
  for (const VehicleBox& box : input.vehicles) {
    const auto cell = [](double pixel, int cells) {
      return static_cast<int>(std::clamp(std::floor(pixel / kCell), 0.0, static_cast<double>(cells - 1)));
    };
    if (reduction_.row(box.bottom) < 0) continue;
    for (int v = cell(reduction_.row(box.top), warp_->rows());
         v <= cell(reduction_.row(box.bottom), warp_->rows()); ++v) {
      const int last = cell(reduction_.column(box.right), warp_->columns());
      for (int u = cell(reduction_.column(box.left), warp_->columns()); u <= last; ++u) {
        believed[static_cast<std::size_t>(v * warp_->columns() + u)] = 0;
      }
    }
  }
  return believed;
}

/// The way forward [m] under which most of the road's texture fits.
double RoadPlaneMotion::State::searched_way(const RoadPair& pair, const Input& input) const {
  constexpr double kStep = 0.05;  // [m]
  double best_way = 0;
  double best = 0;
  PlaneMotion motion;
  for (int i = 0; i * kStep <= config_.fastest * input.seconds; ++i) {
    motion.values[PlaneMotion::kForward] = i * kStep;
    const double fit = forward_fit(match_cells(pair, pair.warp.map(input.pose, motion)), unmoved_jacobians_);
    if (fit <= best) continue;
    best = fit;
    best_way = i * kStep;
  }
  return best_way;
}

void RoadPlaneMotion::State::start_at(double speed) {
  state_.mean << speed, 0, 0, 0;
  state_.covariance =
      Eigen::Vector4d(squared(2.0), squared(1.0), squared(0.05), squared(0.3 * kRadians)).asDiagonal();
}

void RoadPlaneMotion::State::predict_state(double seconds) {
  constexpr double kPitchMemory = 2;              // [s]
  constexpr double kPitchSigma = 0.3 * kRadians;  // of the car's pitch against its mounting
  const double keep = std::exp(-seconds / kPitchMemory);
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition(kSpeed, kAcceleration) = seconds;
  transition(kPitch, kPitch) = keep;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  const double jerk = squared(config_.acceleration);  // changes by one sigma within a second
  noise(kAcceleration, kAcceleration) = jerk * seconds;
  noise(kSpeed, kSpeed) = jerk * seconds * seconds * seconds / 3;
  noise(kSpeed, kAcceleration) = noise(kAcceleration, kSpeed) = jerk * seconds * seconds / 2;
  noise(kYawRate, kYawRate) = squared(config_.yaw_acceleration) * seconds;
  noise(kPitch, kPitch) = squared(kPitchSigma) * (1 - keep * keep);
  predict(state_, transition, noise);
}

Prior RoadPlaneMotion::State::prior_of(double seconds) const {
  constexpr double kHeave = 0.003;           // [m] between two images
  constexpr double kRoll = 0.03 * kRadians;  // between two images
  constexpr double kSlip = 0.004;            // [m/m]
  Eigen::Matrix<double, PlaneMotion::kSize, kStateSize> motion_from_state;
  motion_from_state.setZero();
  motion_from_state(PlaneMotion::kForward, kSpeed) = seconds;
  motion_from_state(PlaneMotion::kYaw, kYawRate) = seconds;
  motion_from_state(PlaneMotion::kPitchBefore, kPitch) = 1;
  Prior prior;
  prior.mean = motion_from_state * state_.mean;
  prior.covariance = motion_from_state * state_.covariance * motion_from_state.transpose();
  const double slip = std::max(1e-3, kSlip * std::abs(state_.mean[kSpeed]) * seconds);
  prior.covariance(PlaneMotion::kLateral, PlaneMotion::kLateral) += squared(slip);
  prior.covariance(PlaneMotion::kPitchChange, PlaneMotion::kPitchChange) +=
      squared(config_.pitch_step_deg * kRadians);
  prior.covariance(PlaneMotion::kHeightChange, PlaneMotion::kHeightChange) += squared(kHeave);
  prior.covariance(PlaneMotion::kRollChange, PlaneMotion::kRollChange) += squared(kRoll);
  return prior;
}

/// The alignment is the posterior of (speed, yaw rate, pitch) already; the acceleration follows by its
/// correlation with the speed.
void RoadPlaneMotion::State::take(const RoadPlaneAlignment& alignment, double seconds) {
  Eigen::Matrix<double, 3, PlaneMotion::kSize> pick = Eigen::Matrix<double, 3, PlaneMotion::kSize>::Zero();
  pick(0, PlaneMotion::kForward) = 1 / seconds;
  pick(1, PlaneMotion::kYaw) = 1 / seconds;
  pick(2, PlaneMotion::kPitchBefore) = 1;
  pick(2, PlaneMotion::kPitchChange) = 1;
  Eigen::Matrix<double, 3, kStateSize> of_state = Eigen::Matrix<double, 3, kStateSize>::Zero();
  of_state(0, kSpeed) = of_state(1, kYawRate) = of_state(2, kPitch) = 1;
  const Eigen::Vector3d mean = pick * alignment.motion.mean;
  const Eigen::Matrix3d covariance = pick * alignment.motion.covariance * pick.transpose();
  const Eigen::Matrix3d before = of_state * state_.covariance * of_state.transpose();
  const Eigen::Matrix<double, kStateSize, 3> gain =
      before.ldlt().solve(of_state * state_.covariance).transpose();
  state_.mean += gain * (mean - of_state * state_.mean);
  state_.covariance = (state_.covariance + gain * (covariance - before) * gain.transpose()).eval();
}

void RoadPlaneMotion::State::follow(const Input& input, const NumberImage& texture) {
  std::vector<std::uint8_t> believed = believed_cells(input);
  const RoadPair pair{*warp_, before_, texture, believed};
  const NumberImage smooth_before = smoothed(before_);
  const NumberImage smooth_now = smoothed(texture);
  const RoadPair smooth{*warp_, smooth_before, smooth_now, believed};
  still_cells_->judge(smooth, input.pose, unmoved_jacobians_);
  if (!still_cells_->car_stands()) {
    for (std::size_t i = 0; i < believed.size(); ++i) {
      if (still_cells_->still(i)) believed[i] = 0;
    }
  }
  if (!locked_) start_at(still_cells_->car_stands() ? 0 : searched_way(smooth, input) / input.seconds);
  predict_state(input.seconds);
  const Prior prior = prior_of(input.seconds);
  const PlaneMotion guess{align_road_plane(smooth, input.pose, {prior, {prior.mean}}).motion.mean};
  const RoadPlaneAlignment alignment = align_road_plane(pair, input.pose, {prior, guess});
  report(alignment, input.seconds);
}

/// Takes the alignment if it fits, and says so.
void RoadPlaneMotion::State::report(const RoadPlaneAlignment& alignment, double seconds) {
  constexpr int kMostMisses = 10;
  const double pitch_variance =
      alignment.motion.covariance(PlaneMotion::kPitchChange, PlaneMotion::kPitchChange);
  estimate_.quality = std::clamp(forward_fit(alignment.matches, unmoved_jacobians_), 0.0, 1.0);
  estimate_.measured = estimate_.quality > kLeastQuality;
  estimate_.pitch_change_sigma = config_.pitch_step_deg * kRadians;
  if (estimate_.measured) {
    take(alignment, seconds);
    estimate_.pitch_change = alignment.motion.mean[PlaneMotion::kPitchChange];
    estimate_.pitch_change_sigma = std::sqrt(pitch_variance);
  }
  misses_ = estimate_.measured ? 0 : misses_ + 1;
  locked_ = misses_ == 0 || (locked_ && misses_ < kMostMisses);
  estimate_.speed = std::max(0.0, state_.mean[kSpeed]);
  estimate_.yaw_rate = state_.mean[kYawRate];
  estimate_.speed_sigma = std::sqrt(state_.covariance(kSpeed, kSpeed));
  estimate_.yaw_rate_sigma = std::sqrt(state_.covariance(kYawRate, kYawRate));
}

RoadPlaneMotion::RoadPlaneMotion(const CameraIntrinsics& intrinsics, const RoadPlaneMotionConfig& config)
    : state_(std::make_unique<State>(intrinsics, config)) {}
RoadPlaneMotion::~RoadPlaneMotion() = default;
RoadPlaneMotion::RoadPlaneMotion(RoadPlaneMotion&&) noexcept = default;
RoadPlaneMotion& RoadPlaneMotion::operator=(RoadPlaneMotion&&) noexcept = default;

const RoadPlaneMotionEstimate& RoadPlaneMotion::update(const Input& input) { return state_->update(input); }

void RoadPlaneMotion::reset() { state_->reset(); }

}  // namespace lanefuse
