// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/feature.hpp"
#include "core/lane_estimate.hpp"

namespace lanefuse {

const char* to_string(Source source) {
  switch (source) {
    case Source::serial_camera:
      return "serial_camera";
    case Source::high_resolution_camera:
      return "high_resolution_camera";
    case Source::objects:
      return "objects";
    case Source::ego_path:
      return "ego_path";
    case Source::vehicle_to_vehicle:
      return "vehicle_to_vehicle";
    case Source::user:
      return "user";
  }
  return "unknown";
}

const char* to_string(MarkingType type) {
  switch (type) {
    case MarkingType::unknown:
      return "unknown";
    case MarkingType::solid:
      return "solid";
    case MarkingType::dashed:
      return "dashed";
    case MarkingType::road_edge:
      return "road_edge";
    case MarkingType::guard_rail:
      return "guard_rail";
  }
  return "unknown";
}

const char* to_string(MarkingColour colour) {
  switch (colour) {
    case MarkingColour::unknown:
      return "unknown";
    case MarkingColour::white:
      return "white";
    case MarkingColour::yellow:
      return "yellow";
  }
  return "unknown";
}

const char* to_string(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::ok:
      return "OK";
    case EstimateStatus::degraded:
      return "DEGRADED";
    case EstimateStatus::invalid:
      return "INVALID";
  }
  return "unknown";
}

const char* to_string(StatusReason reason) {
  switch (reason) {
    case StatusReason::none:
      return "none";
    case StatusReason::warming_up:
      return "warming_up";
    case StatusReason::no_motion:
      return "no_motion";
    case StatusReason::no_ego_lane:
      return "no_ego_lane";
    case StatusReason::source_silent:
      return "source_silent";
    case StatusReason::solver_failed:
      return "solver_failed";
    case StatusReason::no_road_course:
      return "no_road_course";
    case StatusReason::image_fault:
      return "image_fault";
    case StatusReason::camera_bumped:
      return "camera_bumped";
    case StatusReason::sensor_inconsistent:
      return "sensor_inconsistent";
  }
  return "unknown";
}

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::sources:
      return "sources";
    case Stage::association:
      return "association";
    case Stage::solve:
      return "solve";
    case Stage::lane_model:
      return "lane_model";
  }
  return "unknown";
}

}  // namespace lanefuse
