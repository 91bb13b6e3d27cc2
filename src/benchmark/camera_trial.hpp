// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "benchmark/lane_track_judge.hpp"
#include "benchmark/marking_judge.hpp"
#include "camera/lane_camera.hpp"
#include "simulation/image_conditions.hpp"
#include "simulation/road.hpp"

namespace lanefuse {

/// A rendered drive in which cameras alone are judged, image by image, by what was rendered.
struct CameraTrial {
  std::uint64_t seed = 1;
  double km = 0.5;
  RoadKind road = RoadKind::gentle;
  ImageConditions conditions = ImageConditions::clear;
  double settle_s = 4;  ///< [s] at the beginning in which nothing is judged: calibration learns
  /// Whether the cameras are told of the vehicles that the car's object fusion tracks, as in any drive of the
  /// preset. Without, they have the vehicles that they find themselves, and those are judged, too.
  bool objects = true;
  LaneCameraConfig camera;
};

struct CameraTrialFigures {
  std::uint64_t images = 0;  ///< judged, of both cameras
  std::uint64_t refused = 0;
  MarkingFigures markings;  ///< of the high-resolution camera
  LaneTrackFigures serial;  ///< of the serial camera
  LaneTrackFigures high;    ///< pose and vehicles of the high-resolution camera
  CameraTrialFigures& operator+=(const CameraTrialFigures& other);
};

/// The same trial gives the same figures. `progress` hears now and then how far it is, in [0, 1].
CameraTrialFigures run_trial(const CameraTrial& trial, const std::function<void(double)>& progress);

}  // namespace lanefuse
