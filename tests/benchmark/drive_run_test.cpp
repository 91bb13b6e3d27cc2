// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/drive_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmark/variant.hpp"
#include "core/error.hpp"
#include "evaluation/evaluation_json.hpp"
#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

DriveJob short_job(const std::string& variant = "full", const std::string& estimator = "graph") {
  DriveJob job;
  job.key.km = 0.3;
  job.key.variant = variant;
  job.key.estimator = estimator;
  return job;
}

Json driven(const DriveJob& job) {
  return run_drive(job, {}, [](double) {});
}

TEST(DriveRun, SaysWhatSimulatingThenFusingThenJudgingSays) {
  const auto drive = testing::short_drive();
  const auto estimates = testing::perceive(drive, default_config(WitnessRule::radar_and_camera));
  const Json expected = to_json(testing::judge(drive, estimates));
  const Json line = driven(short_job());
  for (const char* key : {"cycles", "cycles_ok", "cycles_with_truth", "lanes", "nees", "wrong_lane_rate"}) {
    EXPECT_EQ(line.at(key), expected.at(key)) << key;
  }
}

TEST(DriveRun, GivesTheSameTwiceAndTimesOnlyWithAClock) {
  const Json line = driven(short_job());
  EXPECT_EQ(line.dump(), driven(short_job()).dump());
  double now = 0;
  Json timed = run_drive(
      short_job(), [&now] { return now += 0.001; }, [](double) {});
  EXPECT_NEAR(timed.at("cycle_ms").at("p50").get<double>(), 1, 1e-6);
  for (const char* key : kTimeKeys) {
    EXPECT_FALSE(line.contains(key)) << key;
    EXPECT_EQ(timed.erase(key), 1U) << key;
  }
  EXPECT_EQ(timed, line);
}

TEST(DriveRun, EveryVariantMakesADifference) {
  for (const char* estimator : {"graph", "road"}) {
    const Json full = driven(short_job("full", estimator)).at("lanes");
    for (const Variant& variant : variants().subspan(1)) {
      if (!has_piece(variant, estimator)) continue;
      // So short a drive need not hold a lane change that would switch anything off.
      if (variant.name == "no-switches") continue;
      EXPECT_NE(driven(short_job(std::string(variant.name), estimator)).at("lanes"), full) << variant.name;
    }
  }
}

TEST(DriveRun, SettingsMakeADifferenceAndAnOrigin) {
  DriveJob job = short_job();
  const Provenance before = provenance_of(job, "1");
  job.assignments = {"fusion.width_edges=false"};
  EXPECT_NE(provenance_of(job, "1").configuration, before.configuration);
  EXPECT_EQ(driven(job).at("lanes"), driven(short_job("no-width")).at("lanes"));
  job.assignments = {"fusion.bogus=1"};
  EXPECT_THROW(provenance_of(job, "1"), Error);
}

TEST(DriveRun, SurveyedTruthIsAnotherTruthOfTheSameDrive) {
  DriveJob job = short_job();
  job.key.truth = "surveyed";
  const Json line = driven(job);
  EXPECT_NE(line.at("lanes"), driven(short_job()).at("lanes"));
  EXPECT_EQ(line.at("inputs"), driven(short_job()).at("inputs"));
  EXPECT_EQ(line.at("surveyed").at("seed"), 1);
}

TEST(DriveRun, MoreNoiseIsMoreErrorForTheSameEstimator) {
  DriveJob job = short_job();
  job.key.noise = 2;
  const Json noisy = driven(job);
  const Json nominal = driven(short_job());
  EXPECT_EQ(provenance_of(job, "1"), provenance_of(short_job(), "1")) << "the noise is in the key";
  EXPECT_EQ(noisy.at("cycles_with_truth"), nominal.at("cycles_with_truth"));
  EXPECT_GT(noisy.at("nees").get<double>(), 1.2 * nominal.at("nees").get<double>());
}

TEST(DriveRun, TellsHowFarItIs) {
  double last = 0;
  run_drive(short_job(), {}, [&last](double done) {
    EXPECT_GE(done, last);
    last = done;
  });
  EXPECT_GT(last, 0.9);
  EXPECT_LE(last, 1);
}

}  // namespace
}  // namespace lanefuse
