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

void add_lane_segmentation(const Section& s, LaneSegmentationSourceConfig& c) {
  LaneSegmentationConfig& n = c.network;
  s.add("enabled", c.enabled,
        "whether a network of your own finds paint in cameras' images; not in the paper");
  s.add("model", n.model, "the network, an .onnx file: 1 x 3 x H x W in, a mask of 1 x N x h x w out");
  s.add("input_width", n.input_width, {0, 8192}, "px", "that images are scaled to; 0: as they are");
  s.add("input_height", n.input_height, {0, 8192}, "px", "the same");
  s.add("input_mean", n.input_mean, {-1000.0, 1000.0}, "levels of 255", "is taken off every channel");
  s.add("input_scale", n.input_scale, {1e-9, 1000.0}, "", "and then the channels are multiplied by it");
  s.add("red_first", n.red_first, "the channels are red, green, blue, else blue, green, red");
  s.add("logits", n.logits, "a mask of one channel holds logits, else probabilities");
  s.add("background_class", n.background_class, {0, 100000}, "",
        "of a mask of several; all others are paint");
  s.add("threshold", n.threshold, {0.001, 0.999}, "", "probability of paint in a mask of one channel");
  s.add("width_max", n.width_max, {0.05, 5.0}, "m", "wider runs are no marking");
  s.add("range_max", n.range_max, {5.0, 300.0}, "m", "features further ahead are dropped");
  s.add("spacing", n.spacing, {0.1, 20.0}, "m", "between the features of one line");
  s.add("sigma_px", n.sigma_px, {0.1, 100.0}, "px", "of the image: how well the paint's middle is placed");
  s.add("confidence", n.confidence, {0.0, 1.0}, "", "of each feature");
  s.add("height_sigma", c.height_sigma, {1e-6, 1.0}, "m",
        "how well the mounting in the rig holds, image by image");
  s.add("roll_sigma_deg", c.roll_sigma_deg, {1e-6, 45.0}, "deg", "the same");
  s.add("pitch_sigma_deg", c.pitch_sigma_deg, {1e-6, 45.0}, "deg", "the same");
  s.add("yaw_sigma_deg", c.yaw_sigma_deg, {1e-6, 45.0}, "deg", "the same");
}

}  // namespace lanefuse
