// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <random>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "pipeline/damaged_stream.hpp"
#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

using testing::perceive;
using testing::SimulatedDrive;

/// A sound drive and its lanes: what damaged ones are compared with.
class SoundDrive {
 protected:
  explicit SoundDrive(EstimatorKind kind) : config_(fused_by(kind)) {}

  [[nodiscard]] std::vector<LaneEstimate> lanes_of(const std::vector<Measurement>& stream) const {
    MultiLanePerception perception(config_, drive_.rig);
    return perceive(perception, stream);
  }
  void expect_same_lanes(const std::vector<Measurement>& stream) const {
    const auto estimates = lanes_of(stream);
    ASSERT_EQ(estimates.size(), sound_.size());
    EXPECT_EQ(testing::first_difference(sound_, estimates), sound_.size()) << "the first cycle that differs";
  }

  static PerceptionConfig fused_by(EstimatorKind kind) {
    PerceptionConfig config;
    config.estimator = kind;
    return config;
  }

  const PerceptionConfig config_;
  const SimulatedDrive drive_ = testing::short_drive();
  const std::vector<LaneEstimate> sound_ = [this] { return lanes_of(drive_.measurements); }();
};

class Stream : public SoundDrive, public ::testing::TestWithParam<EstimatorKind> {
 protected:
  Stream() : SoundDrive(GetParam()) {}
};

InputAccounting sum_of(const std::vector<LaneEstimate>& estimates) {
  InputAccounting sum;
  for (const LaneEstimate& estimate : estimates) sum += estimate.inputs;
  return sum;
}

/// The share of good cycles after the first second, and before the odometry ends.
double share_ok(const std::vector<LaneEstimate>& estimates) {
  int all = 0;
  int good = 0;
  for (const LaneEstimate& estimate : estimates) {
    const double seconds = to_seconds(estimate.time - kSimulationStart);
    if (seconds < 1 || seconds > 10) continue;
    ++all;
    if (estimate.status == EstimateStatus::ok) ++good;
  }
  return static_cast<double>(good) / all;
}

TEST_P(Stream, IsUsedWholeWhereItIsSound) {
  const InputAccounting inputs = sum_of(sound_);
  EXPECT_EQ(inputs.used + inputs.dropped, testing::items_in(drive_.measurements));
  EXPECT_EQ(inputs.rejected, 0U);
  EXPECT_LT(inputs.dropped, inputs.used / 20) << "features beyond the camera's range";
  EXPECT_GT(share_ok(sound_), 0.95);
}

TEST_P(Stream, GivesTheSameBitsAgain) { expect_same_lanes(drive_.measurements); }

TEST_P(Stream, MayComeTwice) {
  std::vector<Measurement> twice;
  for (const Measurement& measurement : drive_.measurements) twice.insert(twice.end(), 2, measurement);
  expect_same_lanes(twice);
}

TEST_P(Stream, MayBeRepeatedLater) {
  std::vector<Measurement> repeated = drive_.measurements;
  for (const Measurement& measurement : drive_.measurements) {
    repeated.push_back(measurement);
    testing::stamp_in(repeated.back()).received_at += std::chrono::milliseconds(300);
  }
  std::ranges::stable_sort(repeated, {}, [](const Measurement& m) { return stamp_of(m).received_at; });
  const auto estimates = lanes_of(repeated);
  EXPECT_EQ(testing::first_difference(sound_, estimates), sound_.size());
}

TEST_P(Stream, MayBeShuffledWithinACycle) {
  std::map<std::int64_t, std::vector<Measurement>> cycles;
  for (const Measurement& measurement : drive_.measurements) {
    // What arrives at the very moment of a cycle belongs to it.
    const Duration received = stamp_of(measurement).received_at.time_since_epoch() - Duration(1);
    cycles[received / std::chrono::milliseconds(80)].push_back(measurement);
  }
  std::mt19937 random(3);
  std::vector<Measurement> shuffled;
  for (auto& [cycle, measurements] : cycles) {
    std::ranges::shuffle(measurements, random);
    shuffled.insert(shuffled.end(), measurements.begin(), measurements.end());
  }
  expect_same_lanes(shuffled);
}

TEST_P(Stream, LosesNothingToDamagedNeighbours) {
  std::vector<Measurement> stream = drive_.measurements;
  for (Measurement& measurement : stream) std::visit(testing::AddDamagedItem{}, measurement);
  expect_same_lanes(stream);
  const InputAccounting inputs = sum_of(lanes_of(stream));
  EXPECT_EQ(inputs.rejected, testing::items_in(stream) - testing::items_in(drive_.measurements));
}

class DamagedStream : public SoundDrive,
                      public ::testing::TestWithParam<std::tuple<EstimatorKind, std::uint32_t>> {
 protected:
  DamagedStream() : SoundDrive(std::get<0>(GetParam())) {}
};

TEST_P(DamagedStream, IsAccountedForToTheLastItem) {
  const std::vector<Measurement> stream = testing::damaged(drive_.measurements, std::get<1>(GetParam()));
  const auto estimates = lanes_of(stream);
  const InputAccounting inputs = sum_of(estimates);
  EXPECT_EQ(inputs.used + inputs.rejected + inputs.dropped, testing::items_in(stream));
  EXPECT_GT(inputs.rejected, 50U);
  EXPECT_GT(inputs.dropped, 50U);
  for (const LaneEstimate& estimate : estimates) {
    for (const Boundary& boundary : estimate.boundaries) {
      EXPECT_TRUE(boundary.clothoid.vector().allFinite());
      EXPECT_TRUE(boundary.covariance.allFinite());
    }
  }
  EXPECT_GT(share_ok(estimates), 0.8);
}

constexpr auto kEstimators = {EstimatorKind::graph, EstimatorKind::road};

INSTANTIATE_TEST_SUITE_P(Seeds, DamagedStream,
                         ::testing::Combine(::testing::ValuesIn(kEstimators), ::testing::Range(1U, 7U)));

TEST_P(Stream, IsForgottenOnReset) {
  MultiLanePerception perception(config_, drive_.rig);
  perceive(perception, drive_.measurements);
  perception.reset();
  EXPECT_EQ(perception.advance(Time::max()), nullptr) << "the clock stands again";
  const auto again = perceive(perception, drive_.measurements);
  ASSERT_EQ(again.size(), sound_.size());
  EXPECT_EQ(testing::first_difference(sound_, again), sound_.size());
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].inputs, sound_[i].inputs);
}

TEST_P(Stream, CutsListsThatAreTooLong) {
  PerceptionConfig config = config_;
  config.max_objects = 2;
  MultiLanePerception perception(config, drive_.rig);
  const Stamp stamp = stamp_of(drive_.measurements.front());
  perception.add(ObjectList{stamp, std::vector<TrackedObject>(5, TrackedObject{1, 40})});
  const LaneEstimate* lanes = perception.advance(stamp.received_at + std::chrono::seconds(1));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{2, 0, 3}));
}

INSTANTIATE_TEST_SUITE_P(Estimators, Stream, ::testing::ValuesIn(kEstimators),
                         [](const auto& one) { return std::string(to_string(one.param)); });

}  // namespace
}  // namespace lanefuse
