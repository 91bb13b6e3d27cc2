// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_track.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/kalman.hpp"

namespace lanefuse {
namespace {

constexpr Duration kNodePeriod{100'000'000};
constexpr Duration kLongestNodeGap{150'000'000};

// Odometry's errors, a square root of a second.
constexpr double kAlong = 0.03;     ///< [m]
constexpr double kAcross = 0.02;    ///< [m]
constexpr double kTurn = 5e-4;      ///< [rad]
constexpr double kBiasWalk = 2e-5;  ///< [rad/s]
constexpr double kScaleWalk = 1e-4;

constexpr double kFirstBias = 0.01;   ///< [rad/s] sigma
constexpr double kFirstScale = 0.02;  ///< sigma
constexpr double kGate = 16;          ///< squared Mahalanobis distance from which on a fix is trusted less

using State = Gaussian<5>;  ///< (x, y, heading, gyro bias, what the speed lacks)
using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

struct Step {
  State filtered;
  State predicted;
  Matrix5 transition;  ///< from the step before
};

State first_state(const TrackSmoother::Fix& fix) {
  State state;
  state.mean << fix.map_from_vehicle.x, fix.map_from_vehicle.y, fix.map_from_vehicle.heading, 0, 0;
  state.covariance.setZero();
  state.covariance.topLeftCorner<3, 3>() = fix.covariance;
  state.covariance(3, 3) = kFirstBias * kFirstBias;
  state.covariance(4, 4) = kFirstScale * kFirstScale;
  return state;
}

/// Moves the state by what odometry reckoned, less what is known of its errors.
Matrix5 move(State& state, const Pose2& reckoned, double seconds) {
  const double turned = state.mean[3] * seconds;
  const Eigen::Vector2d way = rotation(state.mean[2] - turned / 2) * reckoned.position();
  const Eigen::Vector2d moved = (1 + state.mean[4]) * way;
  Matrix5 transition = Matrix5::Identity();
  transition.block<2, 1>(0, 2) << -moved.y(), moved.x();
  transition.block<2, 1>(0, 3) = -seconds / 2 * transition.block<2, 1>(0, 2);
  transition.block<2, 1>(0, 4) = way;
  transition(2, 3) = -seconds;
  Matrix5 noise = Matrix5::Zero();
  noise.topLeftCorner<3, 3>() = rotate_covariance(
      Eigen::Vector3d(kAlong * kAlong, kAcross * kAcross, kTurn * kTurn).asDiagonal(), state.mean[2]);
  noise.diagonal().tail<2>() << kBiasWalk * kBiasWalk, kScaleWalk * kScaleWalk;
  const Vector5 before = state.mean;
  predict<5>(state, transition, noise * seconds);
  state.mean = before;
  state.mean.head<2>() += moved;
  state.mean[2] += reckoned.heading - turned;
  return transition;
}

void correct(State& state, const TrackSmoother::Fix& fix) {
  const Pose2& pose = fix.map_from_vehicle;
  const Eigen::Vector3d residual(pose.x - state.mean[0], pose.y - state.mean[1],
                                 wrap_angle(pose.heading - state.mean[2]));
  const Eigen::Matrix<double, 3, 5> jacobian = Eigen::Matrix<double, 3, 5>::Identity();
  const double surprise = innovation<5, 3>(state, residual, jacobian, fix.covariance).distance_squared();
  const double distrust = std::max(1.0, surprise / kGate);
  update<5, 3>(state, residual, jacobian, distrust * fix.covariance);
}

/// Turns the filtered means into smoothed ones, from the last to the first.
void smooth_backwards(std::vector<Step>& steps) {
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    State& here = steps[i].filtered;
    const Step& next = steps[i + 1];
    const Matrix5 gain =
        next.predicted.covariance.ldlt().solve(next.transition * here.covariance).transpose();
    here.mean += gain * (next.filtered.mean - next.predicted.mean);
  }
}

/// Where in time-ordered `items` the pair around `time` begins.
template <typename Items>
std::size_t pair_at(const Items& items, Time time) {
  const auto after = std::upper_bound(items.begin(), items.end(), time,
                                      [](Time t, const auto& item) { return t < item.time; });
  const auto index = std::max<std::ptrdiff_t>(after - items.begin() - 1, 0);
  return std::min(static_cast<std::size_t>(index), items.size() - 2);
}

double fraction_between(Time from, Time to, Time time) {
  return to_seconds(time - from) / to_seconds(to - from);
}

}  // namespace

std::optional<Pose2> pose_at(std::span<const TrackNode> track, Time time) {
  if (track.size() < 2 || time < track.front().time || time > track.back().time) return std::nullopt;
  const std::size_t i = pair_at(track, time);
  return interpolate(track[i].map_from_vehicle, track[i + 1].map_from_vehicle,
                     fraction_between(track[i].time, track[i + 1].time, time));
}

double height_at(std::span<const TrackNode> track, Time time) {
  assert(!track.empty());
  if (track.size() < 2) return track.front().height;
  const std::size_t i = pair_at(track, time);
  const double fraction = std::clamp(fraction_between(track[i].time, track[i + 1].time, time), 0.0, 1.0);
  return track[i].height + fraction * (track[i + 1].height - track[i].height);
}

void TrackSmoother::add(const VehicleMotion& motion) {
  const Time time = motion.stamp.measured_at;
  if ((!motion.speed && !motion.yaw_rate) || (!reckoned_.empty() && time < reckoned_.back().time)) return;
  const double speed = motion.speed.value_or(speed_);
  const double yaw_rate = motion.yaw_rate.value_or(yaw_rate_);
  if (reckoned_.empty()) {
    reckoned_.push_back({time, {}});
  } else if (time > reckoned_.back().time) {
    const double seconds = to_seconds(time - reckoned_.back().time);
    const Pose2 moved = constant_turn((speed_ + speed) / 2, (yaw_rate_ + yaw_rate) / 2, seconds);
    reckoned_.push_back({time, reckoned_.back().odometry_from_vehicle * moved});
  }
  speed_ = speed;
  yaw_rate_ = yaw_rate;
}

void TrackSmoother::add(const Fix& fix) {
  if (fixes_.empty() || fix.time > fixes_.back().time) fixes_.push_back(fix);
}

Pose2 TrackSmoother::odometry_at(Time time) const {
  const std::size_t i = pair_at(reckoned_, time);
  return interpolate(reckoned_[i].odometry_from_vehicle, reckoned_[i + 1].odometry_from_vehicle,
                     fraction_between(reckoned_[i].time, reckoned_[i + 1].time, time));
}

Duration TrackSmoother::longest_hole() const {
  Duration longest{};
  for (std::size_t i = 1; i < fixes_.size(); ++i) {
    longest = std::max(longest, fixes_[i].time - fixes_[i - 1].time);
  }
  return longest;
}

std::vector<TrackSmoother::Instant> TrackSmoother::instants() const {
  std::vector<Instant> instants;
  for (const Fix& fix : fixes_) {
    if (fix.time < reckoned_.front().time || fix.time > reckoned_.back().time) continue;
    while (!instants.empty() && fix.time - instants.back().time > kLongestNodeGap) {
      instants.push_back({instants.back().time + kNodePeriod, nullptr});
    }
    instants.push_back({fix.time, &fix});
  }
  return instants;
}

std::vector<TrackNode> TrackSmoother::smooth() const {
  if (reckoned_.size() < 2) return {};
  const std::vector<Instant> instants = this->instants();
  if (instants.size() < 2) return {};
  std::vector<Step> steps{{first_state(*instants.front().fix), {}, {}}};
  for (std::size_t i = 1; i < instants.size(); ++i) {
    Step step{steps.back().filtered, {}, {}};
    const Pose2 reckoned = odometry_at(instants[i - 1].time).inverse() * odometry_at(instants[i].time);
    step.transition = move(step.filtered, reckoned, to_seconds(instants[i].time - instants[i - 1].time));
    step.predicted = step.filtered;
    if (instants[i].fix) correct(step.filtered, *instants[i].fix);
    steps.push_back(step);
  }
  smooth_backwards(steps);
  std::vector<TrackNode> track;
  double height = instants.front().fix->height;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Vector5& mean = steps[i].filtered.mean;
    if (instants[i].fix) height = instants[i].fix->height;
    track.push_back({instants[i].time, {mean[0], mean[1], wrap_angle(mean[2])}, height});
  }
  return track;
}

}  // namespace lanefuse
