// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/suite.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/scene.hpp"
#include "benchmark/variant.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// The ablations of an estimator.
std::vector<std::string> names_of(const std::string& estimator) {
  std::vector<std::string> names = variant_names();
  std::erase_if(names, [&](const std::string& name) { return !has_piece(find_variant(name), estimator); });
  return names;
}

TEST(Seeds, AreListsAndRanges) {
  EXPECT_THAT(parse_seeds("7"), ElementsAre(7U));
  EXPECT_THAT(parse_seeds("1-3,9"), ElementsAre(1U, 2U, 3U, 9U));
  EXPECT_THAT(parse_seeds("9,2-2"), ElementsAre(9U, 2U));
  EXPECT_THAT(parse_seeds("18446744073709551615"), SizeIs(1));
}

TEST(Seeds, WhatIsNoListIsRefused) {
  for (const char* text : {"", "x", "1,", ",1", "3-1", "1-", "-1", "1-2-3", "1, 2", "1,1", "1-5,3",
                           "0-99999999", "0-18446744073709551615", "18446744073709551616"}) {
    EXPECT_THROW(parse_seeds(text), Error) << text;
  }
}

TEST(Suites, NominalIsBothRoadsOfTheFullSystem) {
  const auto drives = drives_of({.seeds = {1, 2}});
  EXPECT_THAT(drives, SizeIs(4));
  EXPECT_THAT(drives, Each(Field(&DriveKey::km, 24)));
  EXPECT_THAT(drives, Each(Field(&DriveKey::variant, "full")));
  EXPECT_EQ(std::set<DriveKey>(drives.begin(), drives.end()).size(), 4U);
}

TEST(Suites, AblationsAreEveryVariantOnTheGentleRoad) {
  const auto drives = drives_of({.suite = "ablations"});
  EXPECT_THAT(drives, SizeIs(names_of("graph").size()));
  EXPECT_THAT(drives, Each(Field(&DriveKey::road, "gentle")));
  EXPECT_THAT(drives, Each(Field(&DriveKey::estimator, "graph")));
}

TEST(Suites, RoadAblationsAreThoseOfTheRoadLevelEstimator) {
  const auto drives = drives_of({.suite = "road-ablations"});
  EXPECT_THAT(drives, SizeIs(names_of("road").size()));
  EXPECT_THAT(drives, Each(Field(&DriveKey::road, "gentle")));
  EXPECT_THAT(drives, Each(Field(&DriveKey::estimator, "road")));
  EXPECT_THAT(drives, Each(Field(&DriveKey::km, 24)));
  EXPECT_THAT(drives, Contains(Field(&DriveKey::variant, "full")));
  EXPECT_THAT(drives, Contains(Field(&DriveKey::variant, "no-objects")));
  EXPECT_THAT(drives, Contains(Field(&DriveKey::variant, "no-pitch")));
  EXPECT_THAT(drives, Not(Contains(Field(&DriveKey::variant, "no-width"))));
}

TEST(Suites, AllVariantsAreThoseThatEachEstimatorHas) {
  const auto drives = drives_of({.suite = "ablations", .estimators = {"graph", "road"}});
  EXPECT_THAT(drives, SizeIs(names_of("graph").size() + names_of("road").size()));
}

TEST(Suites, AVariantOfTheOtherEstimatorIsRefused) {
  EXPECT_THROW(drives_of({.variant = "no-pitch"}), Error);
  EXPECT_THROW(drives_of({.variant = "no-width", .estimators = {"graph", "road"}}), Error);
  EXPECT_THROW(drives_of({.suite = "road-ablations", .variant = "no-width"}), Error);
  EXPECT_THAT(drives_of({.road = "curved", .variant = "no-pitch", .estimators = {"road"}}), SizeIs(1));
  EXPECT_THAT(drives_of({.road = "curved", .variant = "no-objects", .estimators = {"graph", "road"}}),
              SizeIs(2));
}

TEST(Suites, CoverageIsShortDrivesOnBothRoads) {
  const auto drives = drives_of({.suite = "coverage", .noise = 2});
  EXPECT_THAT(drives, SizeIs(2));
  EXPECT_THAT(drives, Each(Field(&DriveKey::km, 2)));
  EXPECT_THAT(drives, Each(Field(&DriveKey::noise, 2)));
  EXPECT_NE(drives[0].road, drives[1].road);
}

TEST(Suites, ScenesAreAllThereAre) {
  EXPECT_THAT(drives_of({.suite = "scenes"}), SizeIs(benchmark_scenes().size()));
}

TEST(Suites, TheNominalSceneComesOnBothRoadsAndOnce) {
  const auto drives = drives_of({.suite = "scenes"});
  const auto nominal = std::count_if(drives.begin(), drives.end(),
                                     [](const DriveKey& key) { return key.scene.starts_with("nominal"); });
  EXPECT_EQ(nominal, 2);
  for (const DriveKey& drive : drives) EXPECT_EQ(simulation_of(drive).scenario.name, drive.scene);
}

TEST(Suites, ASceneIsDrivenOnItsOwnRoad) {
  const auto drives = drives_of({.suite = "nominal", .scene = "sharp-bends"});
  ASSERT_THAT(drives, SizeIs(1));
  EXPECT_EQ(drives[0].road, "sharp");
  EXPECT_THROW(drives_of({.road = "gentle", .scene = "sharp-bends"}), Error);
}

TEST(Suites, ComeSeedBySeed) {
  const auto drives = drives_of({.suite = "ablations", .seeds = {5, 3}});
  EXPECT_EQ(drives.front().seed, 5U);
  EXPECT_EQ(drives[names_of("graph").size() - 1].seed, 5U);
  EXPECT_EQ(drives.back().seed, 3U);
}

TEST(Suites, ChoicesNarrowThem) {
  const auto drives = drives_of({.road = "curved", .variant = "no-width", .km = 3, .truth = "surveyed"});
  ASSERT_THAT(drives, SizeIs(1));
  EXPECT_EQ(to_string(drives.front()), "nominal, curved, seed 1, 3 km, no-width, graph, truth surveyed");
}

TEST(Suites, DetectionsDriveEachOnceMore) {
  SuiteChoice choice;
  choice.road = "gentle";
  choice.detections = true;
  const auto drives = drives_of(choice);
  ASSERT_EQ(drives.size(), 2U);
  EXPECT_EQ(drives[0].variant, "full");
  EXPECT_EQ(drives[1].variant, kDetectionsVariant);
  choice.variant = std::string(kDetectionsVariant);
  EXPECT_EQ(drives_of(choice).size(), 1U);
}

TEST(Variants, DetectionsComeInPlaceOfTheObjectList) {
  SimulationConfig config;
  find_variant(kDetectionsVariant).leave_out(config);
  EXPECT_TRUE(config.detections);
  EXPECT_TRUE(config.objects);
  for (const Variant& ablation : variants()) EXPECT_NE(ablation.name, kDetectionsVariant);
}

TEST(Suites, EachDriveIsDrivenWithEachEstimator) {
  SuiteChoice choice;
  choice.road = "gentle";
  choice.seeds = {1, 2};
  choice.estimators = {"graph", "road", "graph"};
  const auto drives = drives_of(choice);
  ASSERT_EQ(drives.size(), 4U);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    EXPECT_EQ(drives[i].estimator, i % 2 == 0 ? "graph" : "road");
    EXPECT_EQ(drives[i].seed, 1 + i / 2);
  }
}

TEST(Suites, UnknownNamesAreRefused) {
  EXPECT_THROW(drives_of({.suite = "x"}), Error);
  EXPECT_THROW(drives_of({.road = "x"}), Error);
  EXPECT_THROW(drives_of({.scene = "x"}), Error);
  EXPECT_THROW(drives_of({.variant = "x"}), Error);
  EXPECT_THROW(drives_of({.estimators = {"graph", "x"}}), Error);
  EXPECT_THROW(drives_of({.truth = "x"}), Error);
}

TEST(Variants, EachTakesSomethingAway) {
  for (const char* estimator : {"graph", "road"}) {
    const std::string full = fingerprint(configure(variants().front(), estimator, {}));
    std::set<std::string> names;
    for (const std::string& name : names_of(estimator)) {
      const Variant& variant = find_variant(name);
      EXPECT_TRUE(names.insert(name).second) << name;
      SimulationConfig simulation;
      variant.leave_out(simulation);
      const bool all_sensors =
          simulation.serial_camera && simulation.high_resolution_camera && simulation.objects;
      const bool as_full = all_sensors && fingerprint(configure(variant, estimator, {})) == full;
      EXPECT_EQ(as_full, name == variants().front().name) << name;
    }
  }
}

TEST(Variants, MayHoldSeveralSettings) {
  const RoadConfig road = configure(find_variant("no-yaw-bias"), "road", {}).road;
  EXPECT_EQ(road.camera.yaw_deg.sigma, 1e-6);
  EXPECT_EQ(road.tracked_lane.yaw_deg.sigma, 1e-6);
  EXPECT_EQ(road.camera.pitch_deg.sigma, RoadConfig{}.camera.pitch_deg.sigma);
}

TEST(Variants, OfTheOtherEstimatorAreRefusedWithThoseThereAre) {
  EXPECT_THROW(configure(find_variant("no-width"), "road", {}), Error);
  EXPECT_THROW(configure(find_variant("no-width"), "oracle", {}), Error);
  EXPECT_NO_THROW(configure(find_variant("no-pitch"), "oracle", {}));
  try {
    configure(find_variant("no-pitch"), "graph", {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no-pitch"));
    EXPECT_THAT(error.what(), HasSubstr("graph"));
    EXPECT_THAT(error.what(), HasSubstr("no-switches"));
    EXPECT_THAT(error.what(), Not(HasSubstr("no-lean")));
  }
}

TEST(Variants, AssignmentsComeLast) {
  const std::vector<std::string> assignments{"fusion.width_edges=true"};
  EXPECT_EQ(fingerprint(configure(find_variant("no-width"), "graph", assignments)),
            fingerprint(configure(find_variant("full"), "graph", {})));
}

TEST(Variants, AreFusedByTheEstimatorThatTheDriveNames) {
  EXPECT_EQ(configure(find_variant("full"), "graph", {}).estimator, EstimatorKind::graph);
  EXPECT_EQ(configure(find_variant("full"), "road", {}).estimator, EstimatorKind::road);
  EXPECT_THROW(configure(find_variant("full"), "x", {}), Error);
}

TEST(Variants, AssignmentsCannotContradictTheEstimator) {
  const std::vector<std::string> road{"estimator=road"};
  EXPECT_THROW(configure(find_variant("full"), "graph", road), Error);
  EXPECT_EQ(configure(find_variant("full"), "road", road).estimator, EstimatorKind::road);
}

}  // namespace
}  // namespace lanefuse
