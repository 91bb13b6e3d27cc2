// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/lost_tracks.hpp"

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

constexpr Time kThen = from_nanoseconds(10'000'000'000);

/// A driving vehicle that was seen last at `seen` and is carried on since.
ObjectTrack track_at(std::int64_t id, const Eigen::Vector2d& place, double speed, double seen) {
  ObjectTrack track;
  track.id = id;
  track.state.mean << place, speed, 0, 0, 4.6;
  track.state.covariance.diagonal() << 4, 1, 2, 0.5, 0.09, 0.25;
  track.confirmed = track.has_moved = true;
  track.born = track.last_seen = kThen + from_seconds(seen);
  return track;
}

class LostTracksTest : public ::testing::Test {
 protected:
  /// The name that a new track gets three seconds later.
  std::int64_t name_of(ObjectTrack young) {
    lost_.know_again(young, young.born, others_, {});
    return young.id;
  }

  LostTracks lost_;
  std::vector<ObjectTrack> others_;
};

TEST_F(LostTracksTest, KnowsTheVehicleAgainWhereItMustBeByNow) {
  lost_.add(track_at(1, {60, 0}, 27, 0));
  lost_.add(track_at(2, {90, 0}, 27, 0));
  EXPECT_EQ(name_of(track_at(9, {88, 0.5}, 28, 3)), 2);
  EXPECT_EQ(name_of(track_at(10, {88, 0.5}, 28, 3)), 10) << "nobody comes back twice";
  EXPECT_EQ(name_of(track_at(11, {61, 0}, 26, 3)), 1);
}

TEST_F(LostTracksTest, TakesNobodyForAVehicleOnAnotherLaneOrOfAnotherSpeed) {
  lost_.add(track_at(1, {60, 0}, 27, 0));
  EXPECT_EQ(name_of(track_at(9, {60, 3.5}, 27, 3)), 9);
  EXPECT_EQ(name_of(track_at(9, {60, 0}, 40, 3)), 9);
  EXPECT_EQ(name_of(track_at(9, {85, 0}, 27, 3)), 9);
}

TEST_F(LostTracksTest, TakesNobodyForOneThatWasStillSeenElsewhere) {
  lost_.add(track_at(1, {60, 0}, 27, 4));
  EXPECT_EQ(name_of(track_at(9, {60, 0}, 27, 3)), 9);
}

TEST_F(LostTracksTest, PassesOnTheBodyButNotTheWordOfACamera) {
  ObjectTrack truck = track_at(1, {60, 0}, 24, 0);
  truck.state.mean[kTrackLength] = 13;
  truck.width = 2.5;
  truck.width_sigma = 0.06;
  truck.camera.verified = true;
  lost_.add(truck);
  ObjectTrack young = track_at(9, {60, 0}, 24, 3);
  lost_.know_again(young, young.born, others_, {});
  EXPECT_NEAR(young.length(), 13, 1e-9);
  EXPECT_EQ(young.width, 2.5);
  EXPECT_FALSE(young.camera.verified) << "it may be another after all";
}

TEST_F(LostTracksTest, FindsTheVehicleAmongThoseCarriedOnBehindOthers) {
  others_ = {track_at(1, {60, 0}, 27, 2), track_at(2, {60, 0.2}, 27, 2.9)};
  EXPECT_EQ(name_of(track_at(9, {60, 0}, 27, 3)), 1) << "the other one is in sight";
  EXPECT_TRUE(others_[0].superseded);
  EXPECT_FALSE(others_[1].superseded);
}

TEST_F(LostTracksTest, ForgetsInTheEndAndNeverRemembersWhatStood) {
  lost_.add(track_at(1, {60, 0}, 27, 0));
  lost_.forget(kThen + from_seconds(5), {});
  EXPECT_EQ(lost_.tracks().size(), 1U);
  lost_.forget(kThen + from_seconds(7), {});
  EXPECT_TRUE(lost_.tracks().empty());
  ObjectTrack post = track_at(2, {60, 0}, 0, 0);
  post.has_moved = false;
  lost_.add(post);
  EXPECT_TRUE(lost_.tracks().empty());
}

}  // namespace
}  // namespace lanefuse
