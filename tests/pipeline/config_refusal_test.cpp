// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "pipeline/config.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What the refusal says; empty where there was none.
std::string refusal(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    return error.what();
  }
  return {};
}

std::string refusal_of(const std::string& yaml) {
  return refusal([&] { parse_config(yaml, "a.yaml"); });
}

std::string refusal_of_set(const std::string& assignment) {
  PerceptionConfig config;
  const std::string before = fingerprint(config);
  const std::string message = refusal([&] { set_key(config, assignment); });
  EXPECT_EQ(fingerprint(config), before) << "a refused key changes nothing";
  return message;
}

TEST(ConfigRefusal, NamesFileLineAndUnknownKey) {
  EXPECT_THAT(
      refusal_of("cycle_hz: 10\n\ncycles_hz: 10\n"),
      AllOf(StartsWith("a.yaml:3: "), HasSubstr("unknown key 'cycles_hz'"), HasSubstr("--print-config")));
  EXPECT_THAT(refusal_of("fusion:\n  solver:\n    iterations: 5\n"),
              AllOf(StartsWith("a.yaml:3: "), HasSubstr("'fusion.solver.iterations'")));
  EXPECT_THAT(refusal_of("fus: 5\n"), HasSubstr("unknown key 'fus'")) << "the beginning of a section is none";
}

class BadValue : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadValue, IsRefusedWithLineKeyAndWhatIsAllowed) {
  const auto& [key, value] = GetParam();
  const std::string yaml = std::string("# a comment\n") + key + ": " + value + "\n";
  EXPECT_THAT(refusal_of(yaml),
              AllOf(StartsWith("a.yaml:2: "), HasSubstr(std::string("'") + key + "' cannot be "),
                    HasSubstr("allowed: ")));
}

INSTANTIATE_TEST_SUITE_P(Values, BadValue,
                         ::testing::Values(std::pair{"cycle_hz", "fast"}, std::pair{"cycle_hz", "12.5 Hz"},
                                           std::pair{"cycle_hz", "0.99"}, std::pair{"cycle_hz", "100.1"},
                                           std::pair{"cycle_hz", "-12.5"}, std::pair{"cycle_hz", "1e999"},
                                           std::pair{"cycle_hz", ".nan"}, std::pair{"cycle_hz", "nan"},
                                           std::pair{"cycle_hz", "inf"}, std::pair{"cycle_hz", ""},
                                           std::pair{"cycle_hz", "\"\""}, std::pair{"cycle_hz", "true"},
                                           std::pair{"cycle_hz", "[10]"}, std::pair{"cycle_hz", "{hz: 10}"},
                                           std::pair{"cycle_hz", "12,5"}, std::pair{"max_objects", "3.5"},
                                           std::pair{"max_objects", "-1"}, std::pair{"max_objects", "0"},
                                           std::pair{"max_objects", "99999999999"}));

TEST(ConfigRefusal, TellsChoicesAndSwitchesFromOtherWords) {
  EXPECT_THAT(refusal_of("fusion: {width_edges: yes}\n"),
              AllOf(HasSubstr("'fusion.width_edges' cannot be yes"), HasSubstr("true, false")));
  EXPECT_THAT(refusal_of("lanes: {base: {fit: both}}\n"),
              AllOf(HasSubstr("'lanes.base.fit' cannot be both"), HasSubstr("heading, joint")));
}

TEST(ConfigRefusal, WantsSectionsWhereSectionsAre) {
  EXPECT_THAT(refusal_of("cycle_hz: 10\nfusion: 5\n"),
              AllOf(StartsWith("a.yaml:2: "), HasSubstr("'fusion' is not a section of keys")));
  EXPECT_THAT(refusal_of("fusion: [width_edges]\n"), HasSubstr("'fusion' is not a section of keys"));
  EXPECT_THAT(refusal_of("just some words\n"),
              AllOf(StartsWith("a.yaml:1: "), HasSubstr("not a section of keys")));
}

TEST(ConfigRefusal, NamesTheLineWhereYamlEnds) {
  EXPECT_THAT(refusal_of("cycle_hz: 10\nfusion: {width_edges: true\n"),
              AllOf(StartsWith("a.yaml:"), HasSubstr("not YAML")));
  EXPECT_THAT(refusal_of("cycle_hz: 10\n\tsilence_s: 3\n"),
              AllOf(StartsWith("a.yaml:2"), HasSubstr("not YAML")));
  EXPECT_THAT(refusal_of("{a: b}: 3\n"), StartsWith("a.yaml:1"));
}

TEST(ConfigRefusal, LooksAtKeysTogether) {
  EXPECT_THAT(refusal_of("lanes:\n  lane_width_min: 5\n  lane_width_max: 4\n"),
              AllOf(HasSubstr("lane_width_min"), HasSubstr("lane_width_max")));
  EXPECT_THAT(refusal_of("lanes: {base: {range_begin: 50, range_end: 50}}\n"), HasSubstr("range_begin"));
}

TEST(ConfigRefusal, NamesWhatStoodOnTheCommandLine) {
  EXPECT_THAT(refusal_of_set("cycle_hz"), AllOf(HasSubstr("--set cycle_hz"), HasSubstr("KEY=VALUE")));
  EXPECT_THAT(refusal_of_set("cycle_hz=fast"),
              AllOf(HasSubstr("--set cycle_hz=fast"), HasSubstr("allowed: ")));
  EXPECT_THAT(refusal_of_set("no.such.key=1"), HasSubstr("unknown key 'no'"));
  EXPECT_THAT(refusal_of_set("fusion=1"), HasSubstr("'fusion' is not a section"));
  EXPECT_THAT(refusal_of_set("cycle_hz="), HasSubstr("'cycle_hz' cannot be"));
  EXPECT_THAT(refusal_of_set("=5"), HasSubstr("unknown key ''"));
  EXPECT_THAT(refusal_of_set("cycle_hz.x=5"), HasSubstr("'cycle_hz' cannot be"));
  EXPECT_THAT(refusal_of_set("lanes.lane_width_min=9"), HasSubstr("lane_width_max"));
}

TEST(ConfigRefusal, NamesFilesThatCannotBeRead) {
  const auto folder = std::filesystem::path(::testing::TempDir());
  EXPECT_THAT(refusal([&] { load_config(folder / "no_such_file.yaml"); }), HasSubstr("no_such_file.yaml"));
  EXPECT_THAT(refusal([&] { load_config(folder); }), HasSubstr("cannot be read"));
}

TEST(ConfigFile, IsReadFromDisk) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "lanefuse_config_test.yaml";
  std::ofstream(file) << "cycle_hz: 20\n";
  EXPECT_EQ(load_config(file).cycle_hz, 20);
  std::ofstream(file) << "cycle_hz: 20\nx: 1\n";
  EXPECT_THAT(refusal([&] { load_config(file); }), HasSubstr("lanefuse_config_test.yaml:2: unknown key 'x'"));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace lanefuse
