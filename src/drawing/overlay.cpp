// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "drawing/camera_panel.hpp"
#include "drawing/canvas.hpp"
#include "drawing/overlay_colours.hpp"
#include "drawing/overlay_legend.hpp"
#include "drawing/road_panel.hpp"

namespace lanefuse {
namespace {

using namespace overlay_colour;

constexpr double kHeadHeight = 60;    // [px]
constexpr double kLegendHeight = 30;  // [px]
constexpr double kSide = 12;          // [px] to the left and right of words
constexpr double kTitleSize = 12;     // [px]
constexpr double kWordSize = 11;      // [px]

struct Layout {
  Box head;
  Box image;
  Box image_legend;
  Box road;
  Box road_legend;
  int height = 0;
};

Layout lay_out(const OverlayScene& scene, const OverlayConfig& config) {
  const double width = config.width;
  const double image_height = std::round(width * scene.intrinsics.height / scene.intrinsics.width);
  Layout layout;
  layout.head = {0, 0, width, kHeadHeight};
  layout.image = {0, layout.head.bottom(), width, image_height};
  layout.image_legend = {kSide, layout.image.bottom(), width - 2 * kSide, kLegendHeight};
  layout.road = {0, layout.image_legend.bottom(), width - kSide, road_panel_height(width - kSide, config)};
  layout.road_legend = {kSide, layout.road.bottom(), width - 2 * kSide, kLegendHeight};
  layout.height = 2 * static_cast<int>(std::ceil(layout.road_legend.bottom() / 2));
  return layout;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// How far the ego lane is known on both sides [m].
std::optional<double> ego_range(const LaneEstimate& estimate) {
  const Lane* lane = ego_lane(estimate);
  if (!lane) return {};
  double range = std::numeric_limits<double>::infinity();
  for (const std::uint64_t id : {lane->left_boundary, lane->right_boundary}) {
    if (const Boundary* boundary = find_boundary(estimate, id)) range = std::min(range, boundary->range_end);
  }
  return range;
}

struct Word {
  std::string text;
  Colour colour = kText;
};

void add_estimate(std::vector<Word>& words, const LaneEstimate& estimate) {
  const bool good = estimate.status == EstimateStatus::ok;
  std::string status = fmt::format("lanes {}", to_string(estimate.status));
  if (estimate.reason != StatusReason::none) status += fmt::format(" ({})", to_string(estimate.reason));
  words.push_back({status, good ? kBoundary : kAlarm});
  const std::optional<double> range = ego_range(estimate);
  words.push_back(
      {range ? fmt::format("ego lane to {:.0f} m", *range) : "no ego lane", range ? kText : kAlarm});
  words.push_back({fmt::format("{:.0f} km/h", estimate.speed * 3.6), kText});
}

void add_camera(std::vector<Word>& words, const CameraView& view) {
  const bool steady = view.calibration == CalibrationStatus::steady;
  const double sigma = std::sqrt(std::max(0.0, view.pose.covariance(2, 2)));
  words.push_back({fmt::format("camera pitch {:.2f} +- {:.2f} deg (down is positive)",
                               degrees(view.pose.mounting.pitch), degrees(sigma)),
                   kText});
  words.push_back({fmt::format("calibration {}", to_string(view.calibration)), steady ? kText : kAlarm});
}

void draw_head(Canvas& canvas, const Box& box, const OverlayScene& scene) {
  canvas.text({box.left + kSide, box.top + 24}, fmt::format("{}, {}", scene.title, scene.camera), kText,
              kTitleSize);
  canvas.text({box.right() - kSide, box.top + 24}, fmt::format("{:.2f} s", scene.seconds), kText, kTitleSize,
              Anchor::end);
  std::vector<Word> words;
  if (scene.road) {
    add_estimate(words, scene.road->estimate);
  } else {
    words.push_back({"no lanes yet", kAlarm});
  }
  if (scene.view) add_camera(words, *scene.view);
  double left = box.left + kSide;
  for (const Word& word : words) {
    canvas.text({left, box.top + 48}, word.text, word.colour, kWordSize);
    left += Canvas::text_width(word.text, kWordSize) + 26;
  }
}

}  // namespace

Image draw_overlay(const OverlayScene& scene, const OverlayConfig& config) {
  const Layout layout = lay_out(scene, config);
  Canvas canvas(config.width, layout.height, kPage);
  draw_head(canvas, layout.head, scene);
  draw_camera_panel(canvas, layout.image, scene);
  draw_overlay_legend(canvas, layout.image_legend, camera_panel_legend(scene));
  draw_road_panel(canvas, layout.road, scene, config);
  draw_overlay_legend(canvas, layout.road_legend, road_panel_legend());
  return canvas.image();
}

}  // namespace lanefuse
