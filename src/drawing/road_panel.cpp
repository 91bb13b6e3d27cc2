// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/road_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/boundary_curve.hpp"
#include "drawing/overlay_colours.hpp"

namespace lanefuse {
namespace {

using namespace overlay_colour;

constexpr double kBehind = 8;   // [m] of road behind the car
constexpr double kBeyond = 6;   // [m] further than the last label
constexpr double kMargin = 44;  // [px] at the left, for labels
constexpr double kFoot = 20;    // [px] below, for labels

// The ego vehicle around the middle of its front axle.
constexpr double kEgoFront = 0.9;
constexpr double kEgoRear = -3.8;
constexpr double kEgoWidth = 1.85;
constexpr double kVehicleLength = 4.5;  // [m] of what the camera sees only the rear of

double metres_ahead(const OverlayConfig& config) { return kBehind + config.reach + kBeyond; }

/// Where places on the road lie in the panel.
class RoadAxes {
 public:
  RoadAxes(const Box& box, const OverlayConfig& config)
      : frame_{box.left + kMargin, box.top, box.width - kMargin, box.height - kFoot},
        scale_(frame_.width / metres_ahead(config)) {}

  [[nodiscard]] const Box& frame() const { return frame_; }
  [[nodiscard]] Pixel at(double x, double y) const {
    return {frame_.left + (x + kBehind) * scale_, frame_.top + frame_.height / 2 - y * scale_};
  }

 private:
  Box frame_;
  double scale_;  // [px/m]
};

void draw_grid(Canvas& canvas, const RoadAxes& axes, const OverlayConfig& config) {
  const Box& frame = axes.frame();
  for (double x = 0; x <= config.reach; x += 10) {
    const double u = axes.at(x, 0).x();
    canvas.line({u, frame.top}, {u, frame.bottom()}, {kGrid, 1});
    if (std::fmod(x, 20) == 0) {
      canvas.text({u, frame.bottom() + 14}, fmt::format("{:.0f} m", x), kMuted, 9, Anchor::middle);
    }
  }
  const double widest = 5 * std::floor(config.half_width / 5);
  for (double y = -widest; y <= widest; y += 5) {
    const double v = axes.at(0, y).y();
    canvas.line({frame.left, v}, {frame.right(), v}, {kGrid, 1});
    if (std::abs(y) > config.half_width - 2) continue;  // the words' place
    canvas.text({frame.left - 6, v + 4}, fmt::format("{:.0f}", y), kMuted, 9, Anchor::end);
  }
  canvas.text({frame.left - 6, frame.top + 9}, "left", kMuted, 8, Anchor::end);
  canvas.text({frame.left - 6, frame.bottom() - 1}, "right", kMuted, 8, Anchor::end);
}

std::vector<Pixel> curve(const RoadAxes& axes, const Boundary& boundary, double from, double to) {
  std::vector<Pixel> pixels;
  for (double x = from; x < to; x += kPointSpacing) pixels.push_back(axes.at(x, curve_at(boundary, x)));
  if (from < to) pixels.push_back(axes.at(to, curve_at(boundary, to)));
  return pixels;
}

void draw_band(Canvas& canvas, const RoadAxes& axes, const Boundary& boundary) {
  std::vector<Pixel> outline;
  for (const BoundaryPoint& point : boundary.points)
    outline.push_back(axes.at(point.x, point.y + point.sigma));
  for (auto point = boundary.points.rbegin(); point != boundary.points.rend(); ++point) {
    outline.push_back(axes.at(point->x, point->y - point->sigma));
  }
  canvas.fill(outline, kBoundary, 0.3);
}

void draw_boundaries(Canvas& canvas, const RoadAxes& axes, const TopView& road) {
  for (const Boundary& boundary : road.estimate.boundaries) {
    draw_band(canvas, axes, boundary);
    canvas.polyline(curve(axes, boundary, boundary.range_begin, boundary.range_end), {kBoundary, 2});
  }
}

void draw_truth(Canvas& canvas, const RoadAxes& axes, const TopView& road) {
  const auto draw = [&](const std::vector<Eigen::Vector2d>& line) {
    std::vector<Pixel> pixels;
    for (const Eigen::Vector2d& point : line) pixels.push_back(axes.at(point.x(), point.y()));
    canvas.polyline(pixels, {kTruth, 1, 8});
  };
  for (const auto& line : road.true_boundaries) draw(line);
  draw(road.driven_path);
}

OverlayLegendEntry look_of(Source source) {
  switch (source) {
    case Source::serial_camera:
      return {"serial camera", OverlaySample::circle, kSerial};
    case Source::high_resolution_camera:
      return {"high-resolution camera", OverlaySample::bar, kHighResolution};
    case Source::objects:
      return {"vehicles", OverlaySample::triangle, kVehicle};
    case Source::ego_path:
      return {"own path", OverlaySample::diamond, kOther};
    case Source::vehicle_to_vehicle:
    case Source::user:
      break;
  }
  return {"other", OverlaySample::diamond, kOther};
}

void draw_features(Canvas& canvas, const RoadAxes& axes, const DebugView& debug) {
  for (const FusedFeature& fused : debug.features) {
    const OverlayLegendEntry look = look_of(fused.feature.source);
    const Pixel at = axes.at(fused.feature.x, fused.feature.y);
    if (fused.outlier) {
      draw_sample(canvas, OverlaySample::cross, at, 3, kMuted);
    } else {
      draw_sample(canvas, look.sample, at, look.sample == OverlaySample::bar ? 4 : 2.6, look.colour);
    }
  }
}

std::array<Pixel, 4> corners(const RoadAxes& axes, const Pose2& rear, double length, double width) {
  std::array<Pixel, 4> result;
  std::size_t i = 0;
  for (const auto& [along, across] :
       {std::pair{0.0, -width / 2}, {length, -width / 2}, {length, width / 2}, {0.0, width / 2}}) {
    const Eigen::Vector2d corner = rear * Eigen::Vector2d(along, across);
    result[i++] = axes.at(corner.x(), corner.y());
  }
  return result;
}

void outline(Canvas& canvas, const std::array<Pixel, 4>& c, const Pen& pen) {
  canvas.polyline(std::array{c[0], c[1], c[2], c[3], c[0]}, pen);
}

void draw_vehicles(Canvas& canvas, const RoadAxes& axes, const OverlayScene& scene) {
  if (scene.road) {
    for (const TrackedObject& object : scene.road->vehicles) {
      outline(canvas, corners(axes, {object.x, object.y, object.heading}, object.length, object.width),
              {kTruth, 1, 4});
    }
  }
  if (scene.view) {
    for (const VehicleBox& box : scene.view->vehicles) {
      outline(canvas, corners(axes, {box.distance, box.lateral, 0}, kVehicleLength, box.width),
              {kVehicle, 2});
    }
  }
  canvas.fill(corners(axes, {kEgoRear, 0, 0}, kEgoFront - kEgoRear, kEgoWidth), kOther);
}

}  // namespace

double road_panel_height(double width, const OverlayConfig& config) {
  return kFoot + std::floor((width - kMargin) / metres_ahead(config) * 2 * config.half_width);
}

void draw_road_panel(Canvas& canvas, const Box& box, const OverlayScene& scene, const OverlayConfig& config) {
  const RoadAxes axes(box, config);
  draw_grid(canvas, axes, config);
  canvas.begin_clip(axes.frame());
  if (scene.road) {
    draw_boundaries(canvas, axes, *scene.road);
    draw_truth(canvas, axes, *scene.road);
    draw_features(canvas, axes, scene.road->debug);
  }
  draw_vehicles(canvas, axes, scene);
  canvas.end_clip();
}

std::vector<OverlayLegendEntry> road_panel_legend() {
  std::vector<OverlayLegendEntry> entries{
      {"fused features of:  serial camera", OverlaySample::circle, kSerial}};
  for (const Source source : {Source::high_resolution_camera, Source::objects, Source::ego_path}) {
    entries.push_back(look_of(source));
  }
  entries.push_back({"outlier", OverlaySample::cross, kMuted});
  entries.push_back({"vehicle in the image", OverlaySample::box, kVehicle});
  return entries;
}

}  // namespace lanefuse
