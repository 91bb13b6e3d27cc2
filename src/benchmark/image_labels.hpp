// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "benchmark/error_figure.hpp"
#include "camera/camera_model.hpp"
#include "core/lane_estimate.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// What people have marked in one image. Pixels of the raw image; boundaries are centre lines of paint.
struct ImageLabels {
  std::string clip;
  std::int64_t frame = 0;  ///< counts the images of the clip from zero
  std::vector<Eigen::Vector2d> ego_left;
  std::vector<Eigen::Vector2d> ego_right;
  std::vector<Eigen::Vector2d> right_outer;  ///< the far boundary of the lane to the right
  struct Vehicle {
    VehicleBox box;
    bool near = false;     ///< nearer than 50 m
    bool partial = false;  ///< the image's edge or another vehicle cuts it
  };
  std::vector<Vehicle> vehicles;
};

/// Reads tests/data/highway_video_labels.json or a file like it; only the frames of `clip`, in their order.
/// Throws Error (input) naming what is wrong.
std::vector<ImageLabels> load_image_labels(const std::filesystem::path& file, const std::string& clip);

/// Lanes estimated from real images against labels.
struct LabelFigures {
  Share ego_left;     ///< of the frames: every point up to the range within the tolerance
  Share ego_right;    ///< the same
  Share ego_both;     ///< the same of both
  Share right_outer;  ///< any boundary there
  Share dummy;        ///< any boundary in the middle of the lane to the right, where there is none
  static constexpr int kBins = 6;
  static constexpr double kBinLength = 10;  ///< [m]
  std::array<ErrorFigure, kBins> error_px;  ///< of the ego lane's points, across, by distance
  Share vehicles_found;                     ///< of the labelled ones that are near and whole
  Share boxes_true;  ///< of the boxes nearer than 50 m: labelled ones, near or not, cut or not
  LabelFigures& operator+=(const LabelFigures& other);
};

struct LabelTolerance {
  double pixels = 5;  ///< [px] between a label and the estimated line in its row
  double range = 60;  ///< [m] up to which labels count
};

/// What one labelled image adds. `estimate` is moved to the image's time by the motion that it assumed.
void judge_labels(const ImageLabels& labels, const LaneEstimate& estimate, const CameraView& view,
                  const CameraModel& camera, const LabelTolerance& tolerance, LabelFigures& figures);

}  // namespace lanefuse
