// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/estimator.hpp"

/// A road of constant curvature, and all that a car on it is told, without an error: what must be found is
/// known exactly.
namespace lanefuse::testing {

inline constexpr double kLane = 3.6;  ///< [m] wide

class NoiselessDrive {
 public:
  using Course = std::function<double(double)>;  ///< [m] beside the road's middle at a station, or a second
  struct Line {
    Course offset;
    MarkingEvidence marking;
    double begin = -1e9;  ///< [m] station from which there is paint
    double end = 1e9;
  };
  struct Vehicle {
    std::int64_t track = 0;
    double ahead = 0;  ///< [m]
    Course offset;     ///< over the seconds
  };

  explicit NoiselessDrive(double curvature = 0) : curvature_(curvature) {}

  std::vector<Line> lines;
  std::vector<Vehicle> vehicles;
  Course own = [](double) { return 0.0; };  ///< the car's way, over the seconds
  double speed = 30;                        ///< [m/s]
  double reach = 120;                       ///< [m] to which paint is seen

  void paint(double offset, MarkingEvidence marking = {}) {
    lines.push_back({[offset](double) { return offset; }, marking});
  }
  /// Three lanes, the car in the middle one.
  void paint_three_lanes() {
    for (const double offset : {1.5, 0.5, -0.5, -1.5}) paint(offset * kLane);
  }

  [[nodiscard]] double seconds() const { return kPeriod * cycle_; }
  [[nodiscard]] double station() const { return station_; }

  /// The next cycle, which the caller may still change in `sets()`.
  void advance() {
    ++cycle_;
    station_ += kPeriod * speed;
    now_ += from_seconds(kPeriod);
    const double slope = speed > 0 ? (own(seconds() + 0.01) - own(seconds() - 0.01)) / 0.02 / speed : 0;
    const double before = car_.heading;
    car_ = place(station_, own(seconds()));
    car_.heading += std::atan(slope);
    motion_.push_back({now_, car_, speed, cycle_ > 1 ? (car_.heading - before) / kPeriod : 0});
    if (motion_.size() > 50) motion_.erase(motion_.begin());
    sets_.clear();
    if (!lines.empty()) sets_.push_back(markings());
    if (!vehicles.empty()) sets_.push_back(witnesses());
  }
  [[nodiscard]] std::vector<FeatureSet>& sets() { return sets_; }
  [[nodiscard]] std::vector<MotionSample>& motion() { return motion_; }
  [[nodiscard]] Cycle cycle() const { return {now_, motion_, sets_}; }
  [[nodiscard]] Time now() const { return now_; }

  const LaneEstimate& run(LaneEstimator& estimator, double for_seconds) {
    const LaneEstimate* estimate = nullptr;
    for (int i = 0; i < std::lround(for_seconds / kPeriod); ++i) {
      advance();
      estimate = &estimator.process(cycle());
    }
    return *estimate;
  }

  /// In the vehicle frame: a place `ahead` along the road, and beside its middle.
  [[nodiscard]] Pose2 seen(double ahead, double offset) const {
    return car_.inverse() * place(station_ + ahead, offset);
  }
  /// Where a line is at x of the vehicle frame.
  [[nodiscard]] double lateral_of(const Course& line, double x) const {
    double low = x - 20;
    double high = x + 60;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (seen(middle, line(station_ + middle)).x < x ? low : high) = middle;
    }
    return seen(low, line(station_ + low)).y;
  }
  /// The boundary that runs within `within` [m] of the line at x, or null.
  static const Boundary* along(const LaneEstimate& estimate, double x, double lateral, double within = 0.5) {
    for (const Boundary& boundary : estimate.boundaries) {
      if (boundary.range_begin > x || boundary.range_end < x) continue;
      if (std::abs(lateral_at(boundary, x) - lateral) < within) return &boundary;
    }
    return nullptr;
  }

  /// A point of paint in the vehicle frame.
  static Feature feature(const Pose2& place, MarkingEvidence marking = {}) {
    Feature feature{place.x, place.y, place.heading, 0.6};
    feature.covariance = Eigen::Vector3d(0.3, 0.05, 0.01).cwiseAbs2().asDiagonal();
    feature.source = Source::high_resolution_camera;
    feature.marking = marking;
    return feature;
  }

 private:
  static constexpr double kPeriod = 0.04;  ///< [s]

  [[nodiscard]] Pose2 place(double station, double offset) const {
    if (curvature_ == 0) return {station, offset, 0};
    const double angle = curvature_ * station;
    const double radius = 1 / curvature_ - offset;
    return {radius * std::sin(angle), 1 / curvature_ - radius * std::cos(angle), angle};
  }

  FeatureSet markings() {
    FeatureSet set;
    set.source = Source::high_resolution_camera;
    set.sensor_id = 2;
    set.measured_at = now_;
    for (const Line& line : lines) {
      for (double ahead = 6; ahead < reach; ahead += 2.5) {
        const double at = station_ + ahead;
        if (at < line.begin || at > line.end) continue;
        set.features.push_back(feature(seen(ahead, line.offset(at)), line.marking));
      }
    }
    return set;
  }

  FeatureSet witnesses() {
    FeatureSet set;
    set.source = Source::objects;
    set.sensor_id = 3;
    set.measured_at = now_;
    set.lane_width = LaneWidth{kLane, 0.1};
    for (const Vehicle& vehicle : vehicles) {
      for (const Side side : {Side::left, Side::right}) {
        const double aside = side == Side::left ? kLane / 2 : -kLane / 2;
        Feature one = feature(seen(vehicle.ahead, vehicle.offset(seconds()) + aside));
        one.covariance = Eigen::Vector3d(0.5, 0.3, 0.02).cwiseAbs2().asDiagonal();
        one.source = set.source;
        one.track_id = vehicle.track;
        one.side = side;
        set.features.push_back(one);
      }
    }
    return set;
  }

  double curvature_;
  int cycle_ = 0;
  double station_ = 0;
  Time now_ = from_nanoseconds(1'000'000'000);
  Pose2 car_;
  std::vector<MotionSample> motion_;
  std::vector<FeatureSet> sets_;
};

}  // namespace lanefuse::testing
