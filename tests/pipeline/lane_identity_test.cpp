// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "pipeline/config.hpp"
#include "pipeline/graph_estimator.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

constexpr double kWidth = 3.6;                                                          ///< [m] of each lane
constexpr std::array kLines{1.5 * kWidth, 0.5 * kWidth, -0.5 * kWidth, -1.5 * kWidth};  ///< [m] from left
constexpr double kPeriod = 0.04;                                                        ///< [s] a cycle

/// A bend with three lanes, and a car that changes from one to the next: all that a cycle is told of it.
class LaneChangeDrive {
 public:
  explicit LaneChangeDrive(std::uint64_t seed) : random_(seed, "lane change") {
    radius_ = 1 / random_.uniform(-1.0 / 700, 1.0 / 700);
    speed_ = random_.uniform(20, 40);
    // One of the four ways from a lane to the next.
    from_ = std::array{kWidth, 0.0, 0.0, -kWidth}[seed % 4];
    to_ = std::array{0.0, kWidth, -kWidth, 0.0}[seed % 4];
    change_seconds_ = random_.uniform(3, 7);
  }

  [[nodiscard]] bool is_over() const { return seconds() > kChangeAt + change_seconds_ + 2; }
  /// Whether everything has been seen long enough to have its name.
  [[nodiscard]] bool is_warm() const { return seconds() > kChangeAt; }

  Cycle step() {
    ++cycle_;
    const Time now = from_nanoseconds(1'000'000'000) + from_seconds(seconds());
    car_ = place(speed_ * seconds(), offset_at(seconds()));
    car_.heading = heading_at(seconds());
    const double yaw_rate = (heading_at(seconds() + kStep) - heading_at(seconds() - kStep)) / (2 * kStep);
    motion_.push_back({now, car_, speed_, yaw_rate});
    sets_ = {markings(now), tracked_lane(now)};
    return {now, motion_, sets_};
  }

  /// [m] in the vehicle frame, `ahead` along the road from the car.
  [[nodiscard]] double lateral_of(std::size_t line, double ahead) const {
    return (car_.inverse() * place(speed_ * seconds() + ahead, kLines[line])).y;
  }
  /// Which of the three lanes the car is in, 0 at the left.
  [[nodiscard]] std::size_t ego() const {
    return static_cast<std::size_t>(1.5 - offset_at(seconds()) / kWidth);
  }

 private:
  static constexpr double kChangeAt = 3;  ///< [s]
  static constexpr double kStep = 0.01;   ///< [s] of derivatives

  [[nodiscard]] double seconds() const { return kPeriod * cycle_; }
  [[nodiscard]] double offset_at(double seconds) const {
    const double phase = std::clamp((seconds - kChangeAt) / change_seconds_, 0.0, 1.0);
    return from_ + (to_ - from_) * (1 - std::cos(std::numbers::pi * phase)) / 2;
  }
  /// Between the car's heading and the road's.
  [[nodiscard]] double slope_at(double seconds) const {
    return std::atan((offset_at(seconds + kStep) - offset_at(seconds - kStep)) / (2 * kStep * speed_));
  }
  [[nodiscard]] double heading_at(double seconds) const {
    return speed_ * seconds / radius_ + slope_at(seconds);
  }
  /// A place along the road and beside its middle.
  [[nodiscard]] Pose2 place(double station, double offset) const {
    const double angle = station / radius_;
    return {(radius_ - offset) * std::sin(angle), radius_ - (radius_ - offset) * std::cos(angle), angle};
  }

  FeatureSet markings(Time now) {
    FeatureSet set;
    set.source = Source::high_resolution_camera;
    set.sensor_id = 2;
    set.measured_at = now;
    for (const double line : kLines) {
      for (double ahead = 6; ahead < 75; ahead += 3) {
        const Pose2 seen = car_.inverse() * place(speed_ * seconds() + ahead, line);
        Feature& feature = set.features.emplace_back();
        feature.x = seen.x;
        feature.y = seen.y + random_.normal(0.05);
        feature.heading = seen.heading + random_.normal(0.005);
        feature.confidence = 0.6;
        feature.covariance = Eigen::Vector3d(0.5, 0.05, 0.005).cwiseAbs2().asDiagonal();
        feature.source = set.source;
      }
    }
    return set;
  }

  /// The lane of a serial camera, which takes the next one as its own when the car has crossed the line.
  FeatureSet tracked_lane(Time now) {
    FeatureSet set;
    set.source = Source::serial_camera;
    set.sensor_id = 1;
    set.measured_at = now;
    for (const std::size_t line : {ego(), ego() + 1}) {
      ClothoidMeasurement& side = set.clothoids.emplace_back();
      side.clothoid = {kLines[line] - offset_at(seconds()) + random_.normal(0.03), -slope_at(seconds()),
                       1 / radius_, 0};
      side.covariance = Eigen::Vector4d(0.03, 0.003, 1e-4, 1e-6).cwiseAbs2().asDiagonal();
      side.range_end = 50;
      side.side = line == ego() ? Side::left : Side::right;
    }
    return set;
  }

  Random random_;
  double radius_ = 0;
  double speed_ = 0;
  double from_ = 0;
  double to_ = 0;
  double change_seconds_ = 0;
  int cycle_ = 0;
  Pose2 car_;
  std::vector<MotionSample> motion_;
  std::vector<FeatureSet> sets_;
};

/// Every estimator names the lanes, and the names stay while the car changes between them.
class LaneIdentity : public ::testing::TestWithParam<std::tuple<EstimatorKind, std::uint64_t>> {
 protected:
  static std::unique_ptr<LaneEstimator> make_estimator() {
    if (std::get<0>(GetParam()) == EstimatorKind::road) return std::make_unique<RoadEstimator>(RoadConfig{});
    return std::make_unique<GraphEstimator>(FusionConfig{}, LaneModelConfig{});
  }

  /// The id of the boundary that runs along the line 10 m ahead, 0 if none does.
  static std::uint64_t boundary_along(std::size_t line, const LaneEstimate& estimate,
                                      const LaneChangeDrive& drive) {
    for (const Boundary& boundary : estimate.boundaries) {
      if (std::abs(lateral_at(boundary, 10) - drive.lateral_of(line, 10)) < 0.4) return boundary.id;
    }
    return 0;
  }
};

TEST_P(LaneIdentity, StaysThroughTheCarsLaneChange) {
  LaneChangeDrive drive(std::get<1>(GetParam()));
  const auto estimator = make_estimator();
  std::vector<std::uint64_t> lines;
  std::vector<std::uint64_t> lanes;
  std::vector<std::uint64_t> own;
  while (!drive.is_over()) {
    const LaneEstimate& estimate = estimator->process(drive.step());
    if (!drive.is_warm()) continue;
    std::vector<std::uint64_t> lines_now;
    for (std::size_t line = 0; line < kLines.size(); ++line)
      lines_now.push_back(boundary_along(line, estimate, drive));
    std::vector<std::uint64_t> lanes_now;
    for (const Lane& lane : estimate.lanes) lanes_now.push_back(lane.id);
    if (lines.empty()) {
      lines = lines_now;
      lanes = lanes_now;
      ASSERT_EQ(lanes.size(), 3U);
    }
    ASSERT_EQ(lines_now, lines);
    ASSERT_EQ(lanes_now, lanes);
    const Lane* ego = ego_lane(estimate);
    ASSERT_NE(ego, nullptr);
    if (own.empty() || own.back() != ego->id) own.push_back(ego->id);
  }
  ASSERT_EQ(own.size(), 2U) << "the car is in one lane, then in the next";
  EXPECT_EQ(own.back(), lanes[drive.ego()]);
}

constexpr std::uint64_t kDrives = 16;

INSTANTIATE_TEST_SUITE_P(Graph, LaneIdentity,
                         ::testing::Combine(::testing::Values(EstimatorKind::graph),
                                            ::testing::Range<std::uint64_t>(0, kDrives)));
INSTANTIATE_TEST_SUITE_P(Road, LaneIdentity,
                         ::testing::Combine(::testing::Values(EstimatorKind::road),
                                            ::testing::Range<std::uint64_t>(0, kDrives)));

}  // namespace
}  // namespace lanefuse
