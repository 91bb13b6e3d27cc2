// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/tracked_traffic.hpp"

/// Looks that come late count as if they had come in time.
namespace lanefuse {
namespace {

using testing::TrackedTraffic;
using testing::TrafficScene;

const TrafficScene kScene{{30, 0.01}, {{{40, 1.75}, {31, 0}}, {{60, -1.75}, {29, 0.3}}, {{20, 5}, {30, 0}}}};

/// One and a half seconds of two sensors, 40 ms apart, in order of time.
std::vector<SightingSet> looks() {
  testing::DetectedTraffic detected(1);
  std::vector<SightingSet> looks;
  for (int i = 0; i < 38; ++i) {
    const TrueFrame frame = kScene.at(0.04 * i);
    looks.push_back(TrackedTraffic::sightings(detected.scan(testing::kFrontRadar, frame), frame));
    looks.push_back(TrackedTraffic::sightings(detected.boxes(frame), frame));
  }
  return looks;
}

std::vector<TrackedObject> tracks(const ObjectTracker& tracker) {
  const TrueFrame end = kScene.at(0.04 * 37);
  std::vector<TrackedObject> objects;
  tracker.write(end.time, end.world_from_vehicle, objects);
  return objects;
}

/// Bit by bit the same.
bool same(const std::vector<TrackedObject>& a, const std::vector<TrackedObject>& b) {
  return std::ranges::equal(a, b, [](const TrackedObject& p, const TrackedObject& q) {
    return p.id == q.id && p.x == q.x && p.y == q.y && p.heading == q.heading && p.speed == q.speed &&
           p.covariance == q.covariance && p.width == q.width && p.existence == q.existence &&
           p.seen_by_radar == q.seen_by_radar && p.seen_by_camera == q.seen_by_camera &&
           p.last_radar == q.last_radar && p.last_camera == q.last_camera &&
           p.changing_lane == q.changing_lane;
  });
}

std::vector<TrackedObject> tracks_of(const std::vector<SightingSet>& looks) {
  ObjectTracker tracker{{}};
  for (const SightingSet& look : looks) EXPECT_TRUE(tracker.add(look));
  return tracks(tracker);
}

RC_GTEST_PROP(LateLooks, GiveWhatSortedOnesGive, ()) {
  static const std::vector<SightingSet> sorted = looks();
  static const std::vector<TrackedObject> expected = tracks_of(sorted);
  // Each is received up to 200 ms after it was measured.
  std::vector<std::pair<int, std::size_t>> received;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    received.emplace_back(static_cast<int>(i / 2) * 40 + *rc::gen::inRange(0, 201), i);
  }
  std::ranges::sort(received);
  std::vector<SightingSet> shuffled;
  for (const auto& [ms, i] : received) shuffled.push_back(sorted[i]);
  RC_ASSERT(same(tracks_of(shuffled), expected));
}

TEST(LateLooks, TellOfThreeVehicles) { EXPECT_EQ(tracks_of(looks()).size(), 3U); }

TEST(LateLooks, AreRefusedBeyondTheWindowAndChangeNothing) {
  const std::vector<SightingSet> sorted = looks();
  ObjectTracker tracker{{}};
  for (const SightingSet& look : sorted) tracker.add(look);
  const auto before = tracks(tracker);
  SightingSet late = sorted[40];
  late.measured_at += std::chrono::milliseconds(1);
  EXPECT_FALSE(tracker.add(late));
  EXPECT_TRUE(same(tracks(tracker), before));
}

TEST(LateLooks, CountOnceWhereTheyComeTwice) {
  ObjectTracker tracker{{}};
  const std::vector<SightingSet> sorted = looks();
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    EXPECT_TRUE(tracker.add(sorted[i]));
    EXPECT_FALSE(tracker.add(sorted[i])) << "the newest again";
    if (i > 2) {
      EXPECT_FALSE(tracker.add(sorted[i - 2])) << "an older one again";
    }
  }
  EXPECT_TRUE(same(tracks(tracker), tracks_of(sorted)));
}

}  // namespace
}  // namespace lanefuse
