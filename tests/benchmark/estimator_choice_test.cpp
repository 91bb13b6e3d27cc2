// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/estimator_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

TEST(EstimatorChoice, TheOracleIsTheRoadLevelEstimatorWithLabels) {
  PerceptionConfig config;
  choose_estimator(config, kOracle);
  EXPECT_EQ(config.estimator, EstimatorKind::road);
  EXPECT_EQ(config.road.association, RoadAssociation::labelled);
}

TEST(EstimatorChoice, NobodyElseIsTold) {
  for (const std::string& name : estimator_names()) {
    if (name == kOracle) continue;
    PerceptionConfig config;
    choose_estimator(config, kOracle);
    choose_estimator(config, name);
    EXPECT_EQ(to_string(config.estimator), name);
    EXPECT_EQ(config.road.association, RoadAssociation::gated) << name;
  }
}

TEST(EstimatorChoice, NoSettingMakesAnOracle) {
  PerceptionConfig config;
  EXPECT_THROW(set_key(config, "estimator=oracle"), Error);
  EXPECT_THROW(set_key(config, "road.association=labelled"), Error);
  PerceptionConfig oracle;
  choose_estimator(config, "road");
  choose_estimator(oracle, kOracle);
  EXPECT_EQ(to_yaml(oracle), to_yaml(config)) << "no key tells them apart";
}

TEST(EstimatorChoice, UnknownNamesAreRefusedWithThoseThereAre) {
  PerceptionConfig config;
  try {
    choose_estimator(config, "x");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("graph, road, oracle"));
  }
}

}  // namespace
}  // namespace lanefuse
