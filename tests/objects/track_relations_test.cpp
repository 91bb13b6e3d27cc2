// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_relations.hpp"

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

constexpr double kSameAlong = 3;

ObjectTrack track_at(std::int64_t id, double x, double y, double sigma) {
  ObjectTrack track;
  track.id = id;
  track.confirmed = true;
  track.state.mean.setZero();
  track.state.mean[kTrackX] = x;
  track.state.mean[kTrackY] = y;
  track.state.mean[kTrackVx] = 25;
  track.state.mean[kTrackLength] = 5;
  track.state.covariance.setIdentity();
  track.state.covariance *= sigma * sigma;
  return track;
}

TEST(Doubles, AreTracksOnOneVehicle) {
  const ObjectTrack old = track_at(1, 80, 3, 0.3);
  EXPECT_TRUE(is_double(track_at(2, 82, 2, 0.3), old, kSameAlong));
  EXPECT_FALSE(is_double(old, track_at(2, 82, 2, 0.3), kSameAlong)) << "the younger is the double";
  EXPECT_FALSE(is_double(track_at(2, 90, 3, 0.3), old, kSameAlong)) << "another vehicle ahead";
}

TEST(Doubles, OfAnUncertainTrackMayBeFurtherAwayButNotOnTheNextLane) {
  const ObjectTrack old = track_at(1, 80, 3, 0.3);
  EXPECT_FALSE(is_double(track_at(2, 80, 1.3, 0.3), old, kSameAlong));
  EXPECT_TRUE(is_double(track_at(2, 80, 1.3, 1), old, kSameAlong));
  // Hidden for long, it may be anywhere; but there was a lane between them.
  EXPECT_FALSE(is_double(track_at(2, 80, 0.2, 3), old, kSameAlong));
}

}  // namespace
}  // namespace lanefuse
