// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStanding = 0.05;        ///< [m/s] slower, the car stands
constexpr double kFirstMemory = 400;      ///< innovations for which what was assumed counts
constexpr double kSurpriseMemory = 5000;  ///< innovations
constexpr double kLeastScale = 0.3;
constexpr double kMostScale = 5;
constexpr double kCurvedStep = 2e-4;  ///< [1/m] over one knot spacing, of a road with curves
constexpr double kBehind = 15;        ///< [m] of road that stays known behind the car

double square(double x) { return x * x; }

}  // namespace

void RoadState::clear() {
  numbers_.clear();
  lines_.clear();
  vehicles_.clear();
  lines_.reserve(kMostLines);
  vehicles_.reserve(kMostVehicles);
  first_knot_ = -RoadAxis::kKnotSpacing;
  first_offset_ = -kOffsetSpacing;
  driven_ = 0;
  noise_scale_ = 1;
  innovations_ = 0;
  restlessness_ = square(config_.course.curvature_step);
  const CameraErrorsConfig& camera = config_.camera;
  numbers_.append(0, square(config_.course.first_heading_deg * kDegree));
  numbers_.append(0, square(config_.motion.yaw_rate_bias_deg * kDegree));
  numbers_.append(0, square(camera.yaw_deg.sigma * kDegree));
  numbers_.append(0, square(camera.lean_deg.sigma * kDegree));
  numbers_.append(0, square(camera.pitch_deg.sigma * kDegree / camera.height));
  numbers_.append(0, square(config_.tracked_lane.yaw_deg.sigma * kDegree));
  numbers_.append(0, square(config_.vehicles.misalignment_deg * kDegree));
  numbers_.append(0, square(config_.motion.speed_scale));
  numbers_.append(0, square(config_.course.first_curvature));
  for (int k = 1; k < RoadAxis::kKnots; ++k) {
    numbers_.append(next_curvature(kCurvatures + k), 0, square(2 * config_.course.curvature_step));
  }
  numbers_.append(0, square(camera.vertical_curvature / camera.height));
  for (int k = 1; k < kOffsets; ++k) numbers_.append(next_crest(kCrests + k - 1), 0, crest_noise());
  rebuild_axis();
}

/// Where a road has curves, the clothoids into them last for a while; on a calm road there are none, and in
/// sharp bends they are short.
double RoadState::persistence() const {
  const double step = usual_step() / kCurvedStep;
  return config_.course.persistence * std::min(step, 1 / step);
}

/// The curvature at a knot from those before it: where a road begins to bend, it goes on to.
SparseRow RoadState::next_curvature(int knot) const {
  SparseRow row;
  const double on = knot - 2 < kCurvatures ? 0 : persistence();
  row.add(knot - 1, 1 + on);
  if (on > 0) row.add(knot - 2, -on);
  return row;
}

/// The road's vertical curvature one knot on from that of `before`.
SparseRow RoadState::next_crest(int before) const {
  SparseRow row;
  row.add(before, std::exp(-kOffsetSpacing / config_.camera.vertical_length));
  return row;
}

double RoadState::crest_noise() const {
  const CameraErrorsConfig& camera = config_.camera;
  const double keep = std::exp(-kOffsetSpacing / camera.vertical_length);
  return (1 - keep * keep) * square(camera.vertical_curvature / camera.height);
}

void RoadState::rebuild_axis() {
  std::array<double, RoadAxis::kKnots> curvatures{};
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    curvatures[static_cast<std::size_t>(k)] = numbers_.mean(kCurvatures + k);
  }
  axis_.rebuild(numbers_.mean(kHeading), curvatures, first_knot_);
}

/// A car that stands does not turn: whatever its dead reckoning says of that is what it errs by.
bool RoadState::stand(const Pose2& before_from_now, double seconds) {
  if (seconds <= 0 || before_from_now.position().norm() > kStanding * seconds) return false;
  SparseRow row;
  row.add(kYawRateError, 1);
  const double noise = square(config_.motion.heading_deg * kDegree) / seconds;
  numbers_.update(row, before_from_now.heading / seconds - numbers_.mean(kYawRateError), noise);
  decay_errors(seconds);
  rebuild_axis();
  return true;
}

void RoadState::drive(const Pose2& before_from_now, double seconds) {
  if (stand(before_from_now, seconds)) return;
  const double heading = numbers_.mean(kHeading);
  const Eigen::Vector2d way =
      rotation(heading) * before_from_now.position() * (1 + numbers_.mean(kSpeedScale));
  const KnotWeights near = knot_weights(way.x() / 2, first_knot_, RoadAxis::kKnotSpacing, RoadAxis::kKnots);
  const double curvature = near.of_first * numbers_.mean(kCurvatures + near.first) +
                           near.of_second * numbers_.mean(kCurvatures + near.first + 1);
  const double aside = way.y() - curvature * square(way.x()) / 2;
  const double along = way.x() * (1 + curvature * way.y());

  // The axis goes through the car: where that goes aside, all lines come nearer.
  SparseRow shift;
  shift.add(kHeading, -way.x());
  shift.add(kCurvatures + near.first, square(way.x()) / 2 * near.of_first);
  shift.add(kCurvatures + near.first + 1, square(way.x()) / 2 * near.of_second);
  if (!lines_.empty()) {
    const int count = static_cast<int>(lines_.size()) * kOffsets;
    numbers_.transform(kFixedNumbers, count, shift, -aside);
    numbers_.add_shared_noise(kFixedNumbers, count,
                              square(noise_scale_ * config_.motion.slip) * std::abs(along));
  }
  SparseRow turn;
  turn.add(kYawRateError, -seconds);
  turn.add(kSpeedScale, -along * curvature);
  turn.add(kCurvatures + near.first, -along * near.of_first);
  turn.add(kCurvatures + near.first + 1, -along * near.of_second);
  const double turned = before_from_now.heading - seconds * numbers_.mean(kYawRateError) - along * curvature;
  numbers_.transform(kHeading, 1, turn, turned);
  numbers_.add_noise(kHeading, square(noise_scale_ * config_.motion.heading_deg * kDegree) * seconds);
  for (int k = kCurvatures; k < kCrests; ++k) {
    const double c = numbers_.mean(k);
    numbers_.set_mean(k, c / (1 - c * aside));
  }
  // Between its knots the road bends otherwise than straight lines between them say, the more so the more it
  // bends.
  const double churn =
      square(config_.course.churn) * restlessness_ * std::abs(along) / RoadAxis::kKnotSpacing;
  for (int k = kCurvatures; k < kCrests; ++k) numbers_.add_noise(k, churn);
  // Who has gone further than it seems is further along a road that bends more and more.
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    const int before = kCurvatures + std::max(0, k - 1);
    const int after = kCurvatures + std::min(RoadAxis::kKnots - 1, k + 1);
    const double rate =
        (numbers_.mean(after) - numbers_.mean(before)) / (RoadAxis::kKnotSpacing * (after - before));
    SparseRow further;
    further.add(kSpeedScale, rate * along);
    numbers_.transform(kCurvatures + k, 1, further, 0);
  }
  for (KnownLine& line : lines_) line.begin -= along;
  first_knot_ -= along;
  first_offset_ -= along;
  driven_ += along;
  decay_errors(seconds);
  move_knots();
  rebuild_axis();
}

void RoadState::decay_errors(double seconds) {
  const auto wander = [&](int i, double keep, double sigma) {
    numbers_.decay(i, keep, noise_scale_ * sigma);
  };
  const CameraErrorsConfig& camera = config_.camera;
  wander(kPaintYaw, std::exp(-seconds / camera.yaw_deg.tau), camera.yaw_deg.sigma * kDegree);
  wander(kPaintLean, std::exp(-seconds / camera.lean_deg.tau), camera.lean_deg.sigma * kDegree);
  wander(kPaintPitch, std::exp(-seconds / camera.pitch_deg.tau),
         camera.pitch_deg.sigma * kDegree / camera.height);
  const WanderingError& tracked = config_.tracked_lane.yaw_deg;
  wander(kTrackedYaw, std::exp(-seconds / tracked.tau), tracked.sigma * kDegree);
  const WanderingError& driver = config_.vehicles.driver;
  for (const RoadVehicle& vehicle : vehicles_) {
    if (vehicle.in_lane) {
      numbers_.decay(vehicle.index, std::exp(-seconds / driver.tau), driver.sigma);
    } else {
      numbers_.add_noise(vehicle.index, 2 * seconds / driver.tau * square(driver.sigma));
    }
  }
  numbers_.add_noise(kYawRateError,
                     square(noise_scale_ * config_.motion.yaw_rate_drift_deg * kDegree) * seconds);
}

void RoadState::move_knots() {
  const RoadCourseConfig& course = config_.course;
  while (first_knot_ + RoadAxis::kKnotSpacing < -kBehind) {
    const double step = numbers_.mean(kCurvatures + 1) - numbers_.mean(kCurvatures);
    restlessness_ += RoadAxis::kKnotSpacing / course.habit_m * (square(step) - restlessness_);
    const double own = 1 - square(persistence());
    numbers_.shift(kCurvatures, RoadAxis::kKnots, next_curvature(kCrests - 1), own * square(usual_step()));
    first_knot_ += RoadAxis::kKnotSpacing;
  }
  while (first_offset_ + kOffsetSpacing < -kBehind) {
    for (const KnownLine& line : lines_) {
      SparseRow before;
      before.add(line.first + kOffsets - 2, 1);
      numbers_.shift(line.first, kOffsets, before, square(course.offset_step));
    }
    numbers_.shift(kCrests, kOffsets, next_crest(kFixedNumbers - 2), crest_noise());
    first_offset_ += kOffsetSpacing;
  }
}

/// Sensors whose noise is not as their makers say are told from what they measure: innovations that are
/// larger, or smaller, than their variances allow.
void RoadState::note_surprise(double surprise) {
  if (!config_.adapt_noise) return;
  const double memory = std::min(kSurpriseMemory, kFirstMemory + innovations_++);
  const double change = 1 + (surprise / config_.usual_surprise - 1) / memory;
  noise_scale_ = std::clamp(noise_scale_ * std::sqrt(change), kLeastScale, kMostScale);
}

double RoadState::usual_step() const {
  return std::clamp(std::sqrt(restlessness_), config_.course.curvature_step,
                    config_.course.curvature_step_max);
}

void RoadState::free_course(double station) {
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    if (first_knot_ + k * RoadAxis::kKnotSpacing < station) continue;
    numbers_.add_noise(kCurvatures + k, square(config_.course.curvature_step_max));
  }
}

}  // namespace lanefuse
