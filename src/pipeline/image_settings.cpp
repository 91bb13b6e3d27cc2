// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/image_settings.hpp"

namespace lanefuse {
namespace {

void add_tracker(const Section& s, LaneTrackerConfig& c) {
  s.add("nearest", c.nearest, {1.0, 50.0}, "m", "the first search window");
  s.add("farthest", c.farthest, {20.0, 200.0}, "m", "the last one");
  s.add("gate", c.gate, {1.0, 10.0}, "sigma",
        "half width of a window, and beyond which an edge is an outlier");
  s.add("pixel_noise", c.pixel_noise, {0.05, 10.0}, "px", "of an edge");
  s.add("contrast_min", c.contrast_min, {1.0, 255.0}, "grey levels", "of paint against the road");
  s.add("lane_width_min", c.lane_width_min, {1.5, 5.0}, "m", "narrower is no lane");
  s.add("lane_width_max", c.lane_width_max, {2.0, 10.0}, "m", "wider is none either");
}

void add_markings(const Section& s, MarkingExtractorConfig& c) {
  s.add("range_min", c.range_min, {1.0, 50.0}, "m", "nearer is not looked at");
  s.add("range_max", c.range_max, {20.0, 300.0}, "m", "further is not looked at");
  s.add("lateral_max", c.lateral_max, {2.0, 50.0}, "m", "to either side");
  s.add("width_min", c.width_min, {0.02, 1.0}, "m", "narrower is no paint");
  s.add("width_max", c.width_max, {0.05, 2.0}, "m", "wider is none either");
  s.add("feature_spacing", c.feature_spacing, {0.1, 20.0}, "m", "between the features of one line");
  s.add("contrast_min", c.contrast_min, {1.0, 255.0}, "grey levels", "of paint against the road");
}

}  // namespace

void add_images(const Section& s, CameraImagesConfig& c) {
  s.add("enabled", c.enabled, "whether cameras' images are looked at");
  s.add("detect_vehicles", c.camera.detect_vehicles, "find vehicles in the image, to keep markings off them");
  add_tracker(s.section("tracker"), c.camera.tracker);
  add_markings(s.section("markings"), c.camera.markings);
  const Section calibration = s.section("calibration");
  calibration.add("height_sigma", c.camera.calibration.height_sigma, {1e-6, 1.0}, "m",
                  "how well the mounting in the rig is known");
  calibration.add("roll_sigma", c.camera.calibration.roll_sigma, {1e-6, 1.0}, "rad", "the same");
  calibration.add("pitch_sigma", c.camera.calibration.pitch_sigma, {1e-6, 1.0}, "rad", "the same");
  calibration.add("yaw_sigma", c.camera.calibration.yaw_sigma, {1e-6, 1.0}, "rad", "the same");
}

}  // namespace lanefuse
