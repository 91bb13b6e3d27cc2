// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The topics of a recording; docs/recording-format.md says what each of them holds.
namespace lanefuse::topic {

inline constexpr char kCalibration[] = "/in/calibration";
inline constexpr char kTransforms[] = "/in/transforms";
inline constexpr char kVehicleMotion[] = "/in/vehicle_motion";
inline constexpr char kWheelSpeeds[] = "/in/wheel_speeds";
inline constexpr char kSerialCamera[] = "/in/serial_camera";
inline constexpr char kHighResolutionCamera[] = "/in/high_resolution_camera";
inline constexpr char kRadar[] = "/in/radar";
inline constexpr char kObjects[] = "/in/objects";
inline constexpr char kCameraBoxes[] = "/in/camera_boxes";
inline constexpr char kGnssIns[] = "/in/gnss_ins";
inline constexpr char kImage[] = "/in/image";
inline constexpr char kCameraCalibration[] = "/in/camera_calibration";

inline constexpr char kLanes[] = "/out/lanes";
inline constexpr char kLaneBoundaries[] = "/out/lane_boundaries";
inline constexpr char kFusedFeatures[] = "/out/fused_features";
inline constexpr char kSwitches[] = "/out/switches";
inline constexpr char kRoadCourse[] = "/out/road_course";
inline constexpr char kScene[] = "/out/scene";
inline constexpr char kCameraView[] = "/out/camera_view";
inline constexpr char kTrackedObjects[] = "/out/objects";
inline constexpr char kStatus[] = "/out/status";

inline constexpr char kTrueRoad[] = "/truth/road";
inline constexpr char kTrueFrame[] = "/truth/frame";

/// Everything below /truth/, known to this version or not.
inline bool is_truth(std::string_view topic) { return topic.starts_with("/truth/"); }

}  // namespace lanefuse::topic
