// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/config.hpp"

#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "pipeline/settings.hpp"

namespace lanefuse {
namespace {

TEST(Config, DefaultsComeBackFromTheirYaml) {
  for (const WitnessRule rule : {WitnessRule::radar_and_camera, WitnessRule::radar_only}) {
    const PerceptionConfig config = default_config(rule);
    const PerceptionConfig back = parse_config(to_yaml(config), "printed");
    EXPECT_EQ(fingerprint(back), fingerprint(config));
    EXPECT_EQ(to_yaml(back), to_yaml(config));
  }
}

/// Another value that a setting allows, found in what it says is allowed.
std::string another_value(const Setting& setting) {
  const auto dots = setting.allowed.find(" .. ");
  if (dots != std::string::npos) {
    const std::string lowest = setting.allowed.substr(0, dots);
    return setting.get() == lowest ? setting.allowed.substr(dots + 4) : lowest;
  }
  const auto comma = setting.allowed.find(", ");
  const std::string first = setting.allowed.substr(0, comma);
  return setting.get() == first ? setting.allowed.substr(comma + 2) : first;
}

TEST(Config, EveryKeyChangesTheFingerprintAndComesBack) {
  PerceptionConfig defaults;
  for (const Setting& setting : settings_of(defaults)) {
    PerceptionConfig changed;
    for (Setting& other : settings_of(changed)) {
      if (other.key == setting.key) {
        ASSERT_TRUE(other.set(another_value(other))) << other.key;
      }
    }
    EXPECT_NE(fingerprint(changed), fingerprint(defaults)) << setting.key;
    // A single key may contradict another's default: then it must not be read back either.
    if (setting.key == "lanes.lane_width_max") {
      EXPECT_THROW(parse_config(to_yaml(changed), "printed"), Error) << setting.key;
    } else {
      EXPECT_EQ(fingerprint(parse_config(to_yaml(changed), "printed")), fingerprint(changed)) << setting.key;
    }
  }
}

TEST(Config, EveryKeyIsUniqueAndExplained) {
  PerceptionConfig config;
  std::set<std::string> keys;
  for (const Setting& setting : settings_of(config)) {
    EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
    EXPECT_FALSE(setting.effect.empty()) << setting.key;
    EXPECT_FALSE(setting.allowed.empty()) << setting.key;
    EXPECT_TRUE(setting.set(setting.get())) << setting.key << "'s default is not allowed";
  }
  EXPECT_GT(keys.size(), 100U);
}

RC_GTEST_PROP(Config, AnyTextEitherIsAllowedOrLeavesTheValueAlone, (const std::string& text)) {
  PerceptionConfig config;
  const std::string before = fingerprint(config);
  for (Setting& setting : settings_of(config)) {
    const std::string value = setting.get();
    if (!setting.set(text)) RC_ASSERT(setting.get() == value);
    RC_ASSERT(setting.set(value));
  }
  RC_ASSERT(fingerprint(config) == before);
}

TEST(Config, ANameOfAFileComesBackWhateverItIs) {
  for (const char* name :
       {"", "lanes.onnx", "/a b/c: d.onnx", "\"quoted\" \\ #.onnx", "M\xC3\xBCnchen", "~", "true"}) {
    PerceptionConfig config;
    config.sources.lane_segmentation.network.model = name;
    EXPECT_EQ(parse_config(to_yaml(config), "printed").sources.lane_segmentation.network.model, name);
  }
}

TEST(Config, TakesSomeKeysAndLeavesTheOthers) {
  PerceptionConfig defaults;
  defaults.silence_s = 2;
  const PerceptionConfig config = parse_config(
      "cycle_hz: 25\nfusion:\n  width_edges: false\nlanes: {base: {fit: joint}}\n", "a.yaml", defaults);
  EXPECT_EQ(config.cycle_hz, 25);
  EXPECT_FALSE(config.fusion.width_edges);
  EXPECT_EQ(config.lanes.base.fit, BaseFit::joint);
  EXPECT_EQ(config.silence_s, 2);
  EXPECT_TRUE(config.fusion.smoothing_edges);
}

TEST(Config, AnEmptyFileOrSectionChangesNothing) {
  for (const char* yaml : {"", "# nothing but a comment\n", "fusion:\n", "---\n"}) {
    EXPECT_EQ(fingerprint(parse_config(yaml, "a.yaml")), fingerprint({})) << yaml;
  }
}

TEST(Config, SetsOneKeyFromTheCommandLine) {
  PerceptionConfig config;
  set_key(config, "cycle_hz=20");
  set_key(config, "fusion.association.along=0.5");
  set_key(config, "sources.objects.witness.rule=radar_only");
  EXPECT_EQ(config.cycle_hz, 20);
  EXPECT_EQ(config.fusion.association.along, 0.5);
  EXPECT_EQ(config.sources.objects.witness.rule, WitnessRule::radar_only);
}

TEST(Config, RadarOnlyGoesBeyondThePaperOnlyWhereItSaysSo) {
  PerceptionConfig expected;
  set_key(expected, "sources.objects.witness.rule=radar_only");
  set_key(expected, "sources.ego_path.enabled=true");
  set_key(expected, "lanes.base.fit=joint");
  set_key(expected, "lanes.base.position_sigma=0.3");
  expected.sources.objects.sensors.long_range_radar = unknown_radar_config();
  set_key(expected, "sources.objects.tracker.acceleration_across=0.12");
  EXPECT_EQ(to_yaml(default_config(WitnessRule::radar_only)), to_yaml(expected));
  EXPECT_EQ(to_yaml(default_config(WitnessRule::radar_and_camera)), to_yaml({}));
}

}  // namespace
}  // namespace lanefuse
