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
constexpr double kBehind = 15;  ///< [m] of road that stays known behind the car

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
    SparseRow before;
    before.add(kCurvatures + k - 1, 1);
    numbers_.append(before, 0, square(2 * config_.course.curvature_step));
  }
  numbers_.append(0, square(camera.vertical_curvature / camera.height));
  for (int k = 1; k < kOffsets; ++k) numbers_.append(next_crest(kCrests + k - 1), 0, crest_noise());
  rebuild_axis();
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
  for (RoadLine& line : lines_) line.begin -= along;
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
    SparseRow before;
    before.add(kCrests - 2, 1);
    numbers_.shift(kCurvatures, RoadAxis::kKnots, before, square(usual_step()));
    first_knot_ += RoadAxis::kKnotSpacing;
  }
  while (first_offset_ + kOffsetSpacing < -kBehind) {
    for (const RoadLine& line : lines_) {
      SparseRow before;
      before.add(line.first + kOffsets - 2, 1);
      numbers_.shift(line.first, kOffsets, before, square(course.offset_step));
    }
    numbers_.shift(kCrests, kOffsets, next_crest(kFixedNumbers - 2), crest_noise());
    first_offset_ += kOffsetSpacing;
  }
}

RoadLine* RoadState::add_line(double offset, double sigma) {
  if (lines_.size() == kMostLines || !numbers_.has_room(kOffsets)) return nullptr;
  // Lines stand before vehicles: those make room.
  while (!vehicles_.empty()) remove_vehicle(vehicles_.size() - 1);
  RoadLine& line = lines_.emplace_back();
  line.id = next_line_++;
  line.first = numbers_.append(offset, square(sigma));
  for (int k = 1; k < kOffsets; ++k) {
    SparseRow before;
    before.add(line.first + k - 1, 1);
    numbers_.append(before, 0, square(config_.course.offset_step));
  }
  line.seen_at = driven_;
  return &line;
}

RoadLine* RoadState::add_line_beside(std::uint64_t known, double distance, double sigma) {
  const RoadLine* beside = find_line(known);
  if (!beside || lines_.size() == kMostLines || !numbers_.has_room(kOffsets)) return nullptr;
  while (!vehicles_.empty()) remove_vehicle(vehicles_.size() - 1);
  const int first = beside->first;
  RoadLine& line = lines_.emplace_back();
  line.id = next_line_++;
  SparseRow same;
  same.add(first, 1);
  line.first = numbers_.append(same, distance, square(sigma));
  for (int k = 1; k < kOffsets; ++k) {
    SparseRow parallel;
    parallel.add(first + k, 1);
    parallel.add(line.first + k - 1, 1);
    parallel.add(first + k - 1, -1);
    numbers_.append(parallel, 0, square(config_.course.offset_step));
  }
  line.seen_at = driven_;
  line.density = 0;
  return &line;
}

void RoadState::remove_line(std::size_t line) {
  numbers_.remove(lines_[line].first, kOffsets);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line));
  for (std::size_t i = line; i < lines_.size(); ++i) lines_[i].first -= kOffsets;
  for (RoadVehicle& vehicle : vehicles_) vehicle.index -= kOffsets;
}

/// Sensors whose noise is not as their makers say are told from what they measure: innovations that are
/// larger, or smaller, than their variances allow.
void RoadState::note_surprise(double surprise) {
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

void RoadState::free_line(const RoadLine& line, double station, double sigma) {
  for (int k = 0; k < kOffsets; ++k) {
    if (first_offset_ + k * kOffsetSpacing < station) continue;
    numbers_.add_noise(line.first + k, square(sigma));
  }
}

RoadVehicle* RoadState::add_vehicle(std::int64_t track_id) {
  if (vehicles_.size() == kMostVehicles || !numbers_.has_room(1)) return nullptr;
  RoadVehicle& vehicle = vehicles_.emplace_back();
  vehicle.track_id = track_id;
  vehicle.index = numbers_.append(0, square(config_.vehicles.driver.sigma));
  return &vehicle;
}

RoadVehicle* RoadState::add_stranger(std::int64_t track_id, double aside, double sigma) {
  RoadVehicle* vehicle = add_vehicle(track_id);
  if (!vehicle) return nullptr;
  vehicle->in_lane = false;
  numbers_.set_mean(vehicle->index, aside);
  numbers_.add_noise(vehicle->index, square(sigma));
  return vehicle;
}

void RoadState::remove_vehicle(std::size_t vehicle) {
  numbers_.remove(vehicles_[vehicle].index, 1);
  vehicles_.erase(vehicles_.begin() + static_cast<std::ptrdiff_t>(vehicle));
  for (std::size_t i = vehicle; i < vehicles_.size(); ++i) --vehicles_[i].index;
}

const RoadLine* RoadState::find_line(std::uint64_t id) const {
  const auto found =
      std::find_if(lines_.begin(), lines_.end(), [id](const RoadLine& line) { return line.id == id; });
  return found == lines_.end() ? nullptr : &*found;
}

double RoadState::offset(const RoadLine& line, double station) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  return w.of_first * numbers_.mean(line.first + w.first) +
         w.of_second * numbers_.mean(line.first + w.first + 1);
}

double RoadState::slope(const RoadLine& line, double station) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  return (numbers_.mean(line.first + w.first + 1) - numbers_.mean(line.first + w.first)) / kOffsetSpacing;
}

void RoadState::add_lateral(SparseRow& row, const RoadAxis::Place& at, double factor) const {
  row.add(kHeading, factor * axis_.heading_lever(at));
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    row.add(kCurvatures + k, -factor * axis_.curvature_lever(k, at.station));
  }
}

void RoadState::add_offset(SparseRow& row, const RoadLine& line, double station, double factor) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  row.add(line.first + w.first, factor * w.of_first);
  row.add(line.first + w.first + 1, factor * w.of_second);
}

double RoadState::relative_height(double station) const {
  double height = 0;
  for (int k = 0; k < kOffsets; ++k) {
    height +=
        numbers_.mean(kCrests + k) * hat_lever(first_offset_ + k * kOffsetSpacing, kOffsetSpacing, station);
  }
  return height;
}

void RoadState::add_relative_height(SparseRow& row, double station, double factor) const {
  for (int k = 0; k < kOffsets; ++k) {
    row.add(kCrests + k, factor * hat_lever(first_offset_ + k * kOffsetSpacing, kOffsetSpacing, station));
  }
}

double RoadState::variance(const RoadLine& line, double station) const {
  SparseRow row;
  add_lateral(row, axis_.at(station), -1);
  add_offset(row, line, station);
  return numbers_.variance(row);
}

}  // namespace lanefuse
