// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "objects/object_tracker.hpp"
#include "sources/sighting_maker.hpp"
#include "support/detected_traffic.hpp"
#include "support/radar_scene.hpp"

/// Vehicles on straight ways around a car on an arc, looked at and tracked.
namespace lanefuse::testing {

struct TrafficScene {
  RadarCar car{30, 0};
  std::vector<RoadUser> users;  ///< the middle of their rears

  [[nodiscard]] TrueFrame at(double seconds) const {
    TrueFrame frame{scan_time(seconds), car.pose(seconds), car.speed, car.yaw_rate, {}};
    std::int64_t id = 0;
    for (const RoadUser& user : users) {
      const Eigen::Vector2d place = user.at(seconds);
      const double heading = std::atan2(user.velocity.y(), user.velocity.x());
      frame.objects.push_back({++id, {place.x(), place.y(), heading}, user.velocity.norm(), 4.7, 1.9});
    }
    return frame;
  }
};

/// Looks at frames as the pipeline does, by hand.
class TrackedTraffic {
 public:
  explicit TrackedTraffic(double noise = 0) : detected(noise) {}

  static SightingSet sightings(const Measurement& measurement, const TrueFrame& frame) {
    static const Rig rig{object_sensors()};
    SightingMaker maker({});
    const std::vector<MotionSample> motion{
        {frame.time, frame.world_from_vehicle, frame.speed, frame.yaw_rate}};
    const SourceContext context{rig, motion, {}};
    SightingSet look;
    if (const auto* scan = std::get_if<RadarScan>(&measurement)) {
      EXPECT_TRUE(maker.make(*scan, context, look));
    } else {
      EXPECT_TRUE(maker.make(std::get<CameraBoxes>(measurement), context, look));
    }
    return look;
  }

  bool add(const Measurement& measurement, const TrueFrame& frame) {
    return tracker.add(sightings(measurement, frame));
  }
  std::vector<TrackedObject> objects(const TrueFrame& frame) const {
    std::vector<TrackedObject> objects;
    tracker.write(frame.time, frame.world_from_vehicle, objects);
    return objects;
  }
  std::vector<TrackedObject> radar(const TrueFrame& frame) {
    EXPECT_TRUE(add(detected.scan(kFrontRadar, frame), frame));
    return objects(frame);
  }
  std::vector<TrackedObject> camera(const TrueFrame& frame) {
    EXPECT_TRUE(add(detected.boxes(frame), frame));
    return objects(frame);
  }
  std::vector<TrackedObject> both(const TrueFrame& frame) {
    radar(frame);
    return camera(frame);
  }

  DetectedTraffic detected;
  ObjectTracker tracker{ObjectTrackerConfig{}};
};

inline constexpr double kLook = 0.05;  ///< [s] from one look to the next

/// The moments of the looks from a second on and before another.
inline std::vector<double> moments(double from, double to) {
  std::vector<double> moments;
  for (auto i = std::lround(from / kLook); i < std::lround(to / kLook); ++i)
    moments.push_back(static_cast<double>(i) * kLook);
  return moments;
}

inline std::vector<TrackedObject> radar_only(TrackedTraffic& traffic, const TrafficScene& scene, double from,
                                             double to) {
  std::vector<TrackedObject> objects;
  for (const double t : moments(from, to)) objects = traffic.radar(scene.at(t));
  return objects;
}

inline std::vector<TrackedObject> fused(TrackedTraffic& traffic, const TrafficScene& scene, double from,
                                        double to) {
  std::vector<TrackedObject> objects;
  for (const double t : moments(from, to)) objects = traffic.both(scene.at(t));
  return objects;
}

/// The object nearest to a vehicle's rear, or null where none is within 2.5 m.
inline const TrackedObject* nearest(const std::vector<TrackedObject>& objects, const TrueFrame& frame,
                                    const TrueObject& object) {
  const Eigen::Vector2d truth = frame.world_from_vehicle.inverse() * object.world_from_object.position();
  const TrackedObject* found = nullptr;
  double least = 2.5;
  for (const TrackedObject& candidate : objects) {
    const double apart = (Eigen::Vector2d(candidate.x, candidate.y) - truth).norm();
    if (apart >= least) continue;
    least = apart;
    found = &candidate;
  }
  return found;
}

}  // namespace lanefuse::testing
