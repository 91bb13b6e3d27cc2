// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// The lane tracker on real motorway video, against labels placed by hand.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "camera/ground_projection.hpp"
#include "camera/lane_tracker.hpp"
#include "camera/online_calibration.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSpeed = 30;         // [m/s]
constexpr double kTolerance = 5;      // [px] across the line
constexpr double kRange = 60;         // [m]
constexpr double kUsualPaint = 0.12;  // [m]

CameraIntrinsics intrinsics() { return {1280, 720, 1160, 1155, 667, 388, {-0.27, 0, 0, 0, 0}}; }

struct Figures {
  int frames = 0;              ///< labelled
  int both = 0;                ///< in which both markings lie on their labels
  int dummies = 0;             ///< in which the left one lies on the middle of the lane
  std::vector<double> widths;  ///< [m] between the middles of the markings
  int tracked = 0;
  int images = 0;
};

/// The paint's middle: the inner edge moved outward.
Clothoid middle_of(const ClothoidMeasurement& edge, std::optional<double> marking_width) {
  Clothoid middle = edge.clothoid;
  middle.lateral_offset += (edge.side == Side::left ? 0.5 : -0.5) * marking_width.value_or(kUsualPaint);
  return middle;
}

/// The pixel of a line in the row `row`, and its distance.
struct Crossing {
  double distance;
  Eigen::Vector2d pixel;
  Eigen::Vector2d along;  ///< unit direction in the image
};
std::optional<Crossing> crossing(const GroundProjection& projection, const Clothoid& line, double row) {
  double near = 3;
  double far = 150;
  const auto pixel_at = [&](double x) { return projection.pixel({x, line.y(x)}); };
  for (int i = 0; i < 40; ++i) {
    const double x = (near + far) / 2;
    const auto pixel = pixel_at(x);
    (pixel && pixel->y() > row ? near : far) = x;
  }
  const auto here = pixel_at(near);
  const auto beyond = pixel_at(1.02 * near);
  if (!here || !beyond) return {};
  return Crossing{near, *here, (*beyond - *here).normalized()};
}

/// Whether all labelled points up to the range lie on the line; `shift` [m] moves them to the right.
bool lies_on(const GroundProjection& projection, const Clothoid& line, const YAML::Node& points,
             double shift) {
  Clothoid shifted = line;
  shifted.lateral_offset -= shift;
  for (const YAML::Node& point : points) {
    const auto there = crossing(projection, shifted, point[1].as<double>());
    if (!there) return false;
    if (there->distance > kRange) continue;
    const double in_row = point[0].as<double>() - there->pixel.x();
    if (std::abs(in_row * there->along.y()) > kTolerance) return false;
  }
  return true;
}

void judge(const LaneTrack& track, const CameraPose& pose, const YAML::Node& labels, Figures& figures) {
  static const CameraModel kCamera(intrinsics());
  ++figures.frames;
  if (!track.left || !track.right) return;
  CameraPose now = pose;
  now.mounting.pitch += track.pitch;
  now.vertical_curvature = track.vertical_curvature;
  const GroundProjection projection(kCamera, now);
  const Clothoid left = middle_of(*track.left, track.left_marking_width);
  const Clothoid right = middle_of(*track.right, track.right_marking_width);
  const bool both =
      lies_on(projection, left, labels["ego_left"], 0) && lies_on(projection, right, labels["ego_right"], 0);
  figures.both += both ? 1 : 0;
  figures.dummies += lies_on(projection, left, labels["ego_left"], track.width / 2) ? 1 : 0;
}

void drive(const std::string& clip, const std::filesystem::path& folder, const YAML::Node& all,
           Figures& figures) {
  cv::VideoCapture video((folder / clip).string());
  ASSERT_TRUE(video.isOpened());
  LaneTracker tracker(intrinsics());
  OnlineCalibration calibration({0, 0, 1.24, 0, -1.6 * kDegree, -1.4 * kDegree});
  cv::Mat image;
  for (int frame = 0; video.read(image); ++frame) {
    const CameraPose pose = calibration.pose();
    const Time time = from_nanoseconds(1'000'000'000 + 40'000'000LL * frame);
    const ImageView view{image.data, image.cols, image.rows, 3, static_cast<std::ptrdiff_t>(image.step)};
    const double yaw_rate = kSpeed * tracker.last().curvature;
    const LaneTrack& track = tracker.track({view, time, pose, kSpeed, yaw_rate, {}});
    calibration.update(track, kSpeed, yaw_rate, time);
    ++figures.images;
    if (track.left && track.right) {
      ++figures.tracked;
      figures.widths.push_back(track.width + (track.left_marking_width.value_or(kUsualPaint) +
                                              track.right_marking_width.value_or(kUsualPaint)) /
                                                 2);
    }
    for (const YAML::Node& labelled : all["frames"]) {
      if (labelled["clip"].as<std::string>() != clip || labelled["frame"].as<int>() != frame) continue;
      judge(track, pose, labelled["boundaries"], figures);
    }
  }
}

TEST(LaneTrackerVideo, BothEgoMarkingsLieOnHandPlacedLabels) {
  const auto folder = testing::real_data("highway_video");
  LANEFUSE_NEEDS_DATA(folder);
  const YAML::Node labels = YAML::LoadFile(LANEFUSE_SOURCE_DIR "/tests/data/highway_video_labels.json");
  Figures figures;
  drive("P4_trees_164f.mp4", folder, labels, figures);
  drive("P4_cut_76f.mp4", folder, labels, figures);
  ASSERT_GE(figures.frames, 24);
  ASSERT_GT(figures.tracked, 0.95 * figures.images);
  RecordProperty("both", figures.both);
  RecordProperty("frames", figures.frames);
  EXPECT_GE(figures.both, 0.9 * figures.frames) << "of " << figures.frames;
  EXPECT_EQ(figures.dummies, 0) << "a line where there is none is found, too";
  std::sort(figures.widths.begin(), figures.widths.end());
  const double width = figures.widths[figures.widths.size() / 2];
  RecordProperty("width", std::to_string(width));
  EXPECT_NEAR(width, 3.66, 0.2);
}

}  // namespace
}  // namespace lanefuse
