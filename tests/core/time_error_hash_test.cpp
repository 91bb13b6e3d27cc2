// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/time.hpp"

namespace lanefuse {
namespace {

TEST(Time, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(from_seconds(1.5), Duration{1'500'000'000});
  EXPECT_EQ(from_seconds(-1.5), Duration{-1'500'000'000});
  EXPECT_EQ(from_seconds(0.6e-9), Duration{1});
  EXPECT_EQ(from_seconds(-0.6e-9), Duration{-1});
  EXPECT_EQ(from_seconds(0.4e-9), Duration{0});
  EXPECT_DOUBLE_EQ(to_seconds(Duration{2'500'000'000}), 2.5);
}

RC_GTEST_PROP(Time, NanosecondsComeBackExactly, (std::int64_t nanoseconds)) {
  RC_ASSERT(to_nanoseconds(from_nanoseconds(nanoseconds)) == nanoseconds);
}

RC_GTEST_PROP(Time, SecondsComeBackOverDays, ()) {
  const auto nanoseconds = *rc::gen::inRange<std::int64_t>(-1'000'000'000'000'000, 1'000'000'000'000'000);
  RC_ASSERT(from_seconds(to_seconds(Duration{nanoseconds})) == Duration{nanoseconds});
}

TEST(Error, NamesPlaceProblemAndMend) {
  const Error error = input_error("drive.mcap, byte 605", "chunk is cut off", "record it anew");
  EXPECT_STREQ(error.what(), "drive.mcap, byte 605: chunk is cut off; record it anew");
  EXPECT_EQ(error.kind(), Error::Kind::input);
}

TEST(Error, DoesWithoutAMend) {
  const Error error = configuration_error("a.yaml:3", "unknown key 'x'");
  EXPECT_STREQ(error.what(), "a.yaml:3: unknown key 'x'");
  EXPECT_EQ(error.kind(), Error::Kind::configuration);
}

TEST(Fnv1a, GivesItsPublishedValues) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace lanefuse
