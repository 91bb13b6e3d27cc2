// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_shape.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

/// From the origin along x.
SightingSet look_of(SightingKind kind) {
  SightingSet look;
  look.measured_at = from_nanoseconds(1'000'000'000);
  look.kind = kind;
  look.velocity = {25, 0};
  return look;
}

Sighting radar_sighting(const Eigen::Vector2d& place) {
  Sighting sighting{place.norm(), std::atan2(place.y(), place.x()), 0.2, 0.003};
  sighting.range_rate = 0;
  return sighting;
}

/// What a camera sees of a vehicle whose rear stands there.
Sighting box_of(const Eigen::Vector2d& rear, double length, double width) {
  ObjectTrack vehicle;
  vehicle.state.mean << rear, 25, 0, 0, length;
  const Silhouette seen = silhouette(vehicle, look_of(SightingKind::camera), length, width);
  Sighting box{rear.norm(), std::atan2(rear.y(), rear.x()) + seen.middle, 0.05 * rear.norm(), 0.002};
  box.angular_width = seen.width;
  return box;
}

/// A track that radar and camera have followed on this way of a vehicle's rear.
ObjectTrack followed(const Eigen::Vector2d& from, const Eigen::Vector2d& step, double length, double width) {
  const ObjectTrackerConfig config;
  const SightingSet radar = look_of(SightingKind::radar);
  const SightingSet camera = look_of(SightingKind::camera);
  ObjectTrack track = start_track(radar, radar_sighting(from), config, 0);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d rear = from + i * step;
    track.state.mean.head<2>() = rear;
    update(track, radar, radar_sighting(rear), config);
    update(track, camera, box_of(rear, length, width), config);
  }
  return track;
}

TEST(TrackShape, TellsATruckFromACarByItsWidth) {
  EXPECT_GT(followed({40, 0}, {0, 0}, 13, 2.5).length(), 9);
  EXPECT_LT(followed({40, 0}, {0, 0}, 4.4, 1.8).length(), 6);
}

TEST(TrackShape, TakesNoFlankForAWidth) {
  const ObjectTrack car = followed({20, 4}, {-0.2, 0}, 4.6, 1.8);
  EXPECT_NEAR(car.width, 1.8, 0.15) << "its flank spans half of the box";
  EXPECT_LT(car.length(), 6);
}

TEST(TrackShape, AMistakenTruckBecomesACarAgain) {
  const ObjectTrackerConfig config;
  ObjectTrack track = followed({20, 4}, {0, 0}, 4.6, 1.8);
  track.width = 2.4;
  track.width_sigma = 0.2;
  suppose_length(track, kTruckLength, kTruckLengthSigma);
  for (int i = 0; i < 60; ++i) {
    update(track, look_of(SightingKind::camera), box_of(track.position(), 4.6, 1.8), config);
  }
  EXPECT_LT(track.length(), 6);
}

TEST(TrackShape, MeasuresTheLengthOfWhatWasSeenFromBothEnds) {
  const ObjectTrackerConfig config;
  SightingSet look = look_of(SightingKind::radar);
  ObjectTrack track = start_track(look, radar_sighting({10, 0}), config, 0);
  for (int i = 0; i < 20; ++i) update(track, look, radar_sighting({10, 0}), config);
  suppose_length(track, kTruckLength, kTruckLengthSigma);
  look.odometry_from_sensor = {60, 0, std::acos(-1.0)};
  for (int i = 0; i < 20; ++i) update(track, look, radar_sighting({60 - 25.5, 0}), config);
  EXPECT_NEAR(track.length(), 15.5, 0.4);
  EXPECT_NEAR(track.position().x(), 10, 0.3);
}

TEST(TrackShape, AnotherLengthMovesTheRearOnlyWhereTheFrontWasSeen) {
  const ObjectTrackerConfig config;
  const SightingSet look = look_of(SightingKind::radar);
  ObjectTrack ahead = start_track(look, radar_sighting({30, 0}), config, 0);
  suppose_length(ahead, 13, 2);
  EXPECT_NEAR(ahead.position().x(), 30, 1e-6);
  ObjectTrack behind = start_track(look, radar_sighting({-30, 0}), config, 0);
  suppose_length(behind, 13, 2);
  EXPECT_NEAR(behind.position().x(), -43, 1e-6);
}

TEST(Prediction, FollowsTheRoadThatItIsTold) {
  const ObjectTrackerConfig config;
  const SightingSet look = look_of(SightingKind::radar);
  ObjectTrack track = start_track(look, radar_sighting({30, 0}), config, 0);
  track.state.mean.segment<2>(kTrackVx) << 30, 0;
  for (int i = 0; i < 40; ++i) predict(track, 0.05, {0, 0}, 1e-3, config);
  EXPECT_NEAR(track.position().x(), 30 + 1000 * std::sin(0.06), 0.01);
  EXPECT_NEAR(track.position().y(), 1000 * (1 - std::cos(0.06)), 0.01);
  EXPECT_NEAR(track.heading, 0.06, 1e-6);
}

}  // namespace
}  // namespace lanefuse
