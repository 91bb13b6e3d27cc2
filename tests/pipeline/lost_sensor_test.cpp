// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

using testing::SimulatedDrive;

double seconds_of(const LaneEstimate& estimate) { return to_seconds(estimate.time - kSimulationStart); }

/// The lanes of a drive in which one kind of measurement is missing from second `from` to second `to`.
template <typename Lost>
std::vector<LaneEstimate> without(double from, double to, EstimatorKind estimator) {
  SimulatedDrive drive = testing::short_drive();
  std::erase_if(drive.measurements, [&](const Measurement& measurement) {
    const double seconds = to_seconds(stamp_of(measurement).measured_at - kSimulationStart);
    return std::holds_alternative<Lost>(measurement) && seconds > from && seconds < to;
  });
  PerceptionConfig config;
  config.estimator = estimator;
  return testing::perceive(drive, config);
}

class LostOdometry : public ::testing::TestWithParam<EstimatorKind> {};
class SilentSource : public ::testing::TestWithParam<EstimatorKind> {};

TEST_P(LostOdometry, EndsTheEstimateUntilItComesBack) {
  int invalid = 0;
  const auto estimates = without<VehicleMotion>(4, 6, GetParam());
  for (const LaneEstimate& estimate : estimates) {
    const double seconds = seconds_of(estimate);
    if (seconds > 4.2 && seconds < 6) {
      EXPECT_EQ(estimate.status, EstimateStatus::invalid) << seconds;
      EXPECT_EQ(estimate.reason, StatusReason::no_motion) << seconds;
      EXPECT_TRUE(estimate.boundaries.empty()) << seconds;
      EXPECT_TRUE(estimate.lanes.empty()) << seconds;
      EXPECT_EQ(estimate.speed, 0) << seconds;
      ++invalid;
    }
    if (seconds > 8 && seconds < 10) {
      EXPECT_EQ(estimate.status, EstimateStatus::ok) << seconds;
    }
  }
  EXPECT_GT(invalid, 20);
  EXPECT_GT(seconds_of(estimates.back()), 9);
}

TEST_P(LostOdometry, IsBridgedWhereItIsShort) {
  const auto estimates = without<VehicleMotion>(4, 4.4, GetParam());
  std::vector<std::uint64_t> before;
  for (const LaneEstimate& estimate : estimates) {
    if (seconds_of(estimate) > 4) break;
    before.clear();
    for (const Boundary& boundary : estimate.boundaries) before.push_back(boundary.id);
  }
  const auto after = std::ranges::find_if(estimates, [](const auto& e) { return seconds_of(e) > 5; });
  ASSERT_NE(after, estimates.end());
  EXPECT_EQ(after->status, EstimateStatus::ok);
  for (const std::uint64_t id : before) EXPECT_NE(find_boundary(*after, id), nullptr) << "boundary " << id;
}

template <typename Lost>
void expect_silence(Source source, EstimatorKind estimator) {
  int silent = 0;
  for (const LaneEstimate& estimate : without<Lost>(5, 100, estimator)) {
    const auto& status = estimate.sources[static_cast<std::size_t>(source)];
    const double seconds = seconds_of(estimate);
    if (seconds > 2 && seconds < 5) {
      EXPECT_EQ(status, SourceStatus::ok) << seconds;
    }
    if (seconds < 6) continue;
    EXPECT_EQ(status, SourceStatus::unavailable) << seconds;
    EXPECT_NE(estimate.status, EstimateStatus::ok) << seconds;
    if (estimate.status == EstimateStatus::degraded && estimate.reason == StatusReason::source_silent)
      ++silent;
    for (const Source other : {Source::serial_camera, Source::high_resolution_camera, Source::objects}) {
      if (other == source) continue;
      EXPECT_EQ(estimate.sources[static_cast<std::size_t>(other)], SourceStatus::ok) << seconds;
    }
  }
  EXPECT_GT(silent, 30) << "of the 50 cycles that follow";
}

TEST_P(SilentSource, DegradesTheEstimateAndIsNamed) {
  expect_silence<MarkingFeatures>(Source::high_resolution_camera, GetParam());
  expect_silence<SerialLane>(Source::serial_camera, GetParam());
  expect_silence<ObjectList>(Source::objects, GetParam());
}

TEST_P(SilentSource, IsNoneThatNeverSpoke) {
  const auto estimates = without<ObjectList>(-1, 100, GetParam());
  const auto late = std::ranges::find_if(estimates, [](const auto& e) { return seconds_of(e) > 9; });
  ASSERT_NE(late, estimates.end());
  EXPECT_EQ(late->status, EstimateStatus::ok);
  EXPECT_EQ(late->sources[static_cast<std::size_t>(Source::objects)], SourceStatus::unavailable);
}

constexpr auto kEstimators = {EstimatorKind::graph, EstimatorKind::road};
std::string name_of(const ::testing::TestParamInfo<EstimatorKind>& one) { return to_string(one.param); }

INSTANTIATE_TEST_SUITE_P(Estimators, LostOdometry, ::testing::ValuesIn(kEstimators), name_of);
INSTANTIATE_TEST_SUITE_P(Estimators, SilentSource, ::testing::ValuesIn(kEstimators), name_of);

}  // namespace
}  // namespace lanefuse
