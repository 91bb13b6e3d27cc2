// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/camera_panel.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "camera/ground_projection.hpp"
#include "core/boundary_curve.hpp"
#include "drawing/overlay_colours.hpp"

namespace lanefuse {
namespace {

using namespace overlay_colour;

constexpr double kNearestAhead = 0.5;  // [m] from the camera to where lines begin: nearer is below the image
constexpr double kTruthReach = 150;    // [m]

/// Where pixels of the image and places on the road lie in the panel.
class PanelView {
 public:
  PanelView(const Box& box, const OverlayScene& scene)
      : box_(box),
        scale_(box.width / scene.intrinsics.width),
        camera_(scene.intrinsics),
        ground_(camera_, scene.pose) {}

  [[nodiscard]] Pixel at(double u, double v) const {
    return {box_.left + (u + 0.5) * scale_ - 0.5, box_.top + (v + 0.5) * scale_ - 0.5};
  }
  /// Not finite where the camera does not look.
  [[nodiscard]] Pixel on_road(double x, double y) const {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    if (x < ground_.pose().mounting.x + kNearestAhead) return {kNowhere, kNowhere};
    const std::optional<Eigen::Vector2d> pixel = ground_.pixel({x, y});
    return pixel ? at(pixel->x(), pixel->y()) : Pixel(kNowhere, kNowhere);
  }
  [[nodiscard]] std::vector<Pixel> curve(const Boundary& boundary, double from, double to) const {
    std::vector<Pixel> pixels;
    from = std::max(from, ground_.pose().mounting.x + kNearestAhead);
    for (double x = from; x < to; x += std::clamp((x - from) / 10, 0.25, 2.0)) {
      pixels.push_back(on_road(x, curve_at(boundary, x)));
    }
    if (from < to) pixels.push_back(on_road(to, curve_at(boundary, to)));
    return pixels;
  }

 private:
  Box box_;
  double scale_;
  CameraModel camera_;
  GroundProjection ground_;
};

struct EgoBoundaries {
  const Boundary* left = nullptr;
  const Boundary* right = nullptr;
  double from = 0;
  double to = 0;
};

std::optional<EgoBoundaries> ego_boundaries(const LaneEstimate& estimate) {
  const Lane* lane = ego_lane(estimate);
  if (!lane) return {};
  const Boundary* left = find_boundary(estimate, lane->left_boundary);
  const Boundary* right = find_boundary(estimate, lane->right_boundary);
  if (!left || !right) return {};
  return EgoBoundaries{left, right, std::max(left->range_begin, right->range_begin),
                       std::min(left->range_end, right->range_end)};
}

void draw_ego_lane(Canvas& canvas, const PanelView& view, const LaneEstimate& estimate) {
  const std::optional<EgoBoundaries> ego = ego_boundaries(estimate);
  if (!ego) return;
  std::vector<Pixel> outline = view.curve(*ego->left, ego->from, ego->to);
  const std::vector<Pixel> back = view.curve(*ego->right, ego->from, ego->to);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  canvas.fill(outline, kBoundary, 0.16);
}

/// Rungs across the ego lane that say how far ahead they lie.
void draw_distances(Canvas& canvas, const PanelView& view, const LaneEstimate& estimate) {
  const std::optional<EgoBoundaries> ego = ego_boundaries(estimate);
  if (!ego) return;
  double last_label = std::numeric_limits<double>::infinity();  // [px] row
  for (const double x : {10.0, 20.0, 50.0, 100.0}) {
    if (x < ego->from || x > ego->to) continue;
    const Pixel left = view.on_road(x, curve_at(*ego->left, x));
    const Pixel right = view.on_road(x, curve_at(*ego->right, x));
    canvas.line(left, right, {kBoundary, 1});
    if (!(left.y() < last_label - 10)) continue;  // no room
    canvas.text(left - Pixel(8, -3), fmt::format("{:.0f} m", x), kText, 8, Anchor::end);
    last_label = left.y();
  }
}

/// A line on the road in steps so short that the lens bends none of them.
void draw_line(Canvas& canvas, const PanelView& view, const std::vector<Eigen::Vector2d>& line,
               const Pen& pen) {
  constexpr double kStep = 1;  // [m]
  std::vector<Pixel> pixels;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    const int steps = std::clamp(static_cast<int>(way.norm() / kStep), 1, 1000);
    for (int s = 0; s < steps; ++s) {
      const Eigen::Vector2d point = line[i - 1] + way * s / steps;
      if (point.x() < kTruthReach) pixels.push_back(view.on_road(point.x(), point.y()));
    }
  }
  canvas.polyline(pixels, pen);
}

void draw_boundaries(Canvas& canvas, const PanelView& view, const TopView& road) {
  for (const Boundary& boundary : road.estimate.boundaries) {
    canvas.polyline(view.curve(boundary, boundary.range_begin, boundary.range_end), {kBoundary, 2, 0, true});
  }
  const Pen truth{kTruth, 2, 9};
  for (const auto& line : road.true_boundaries) draw_line(canvas, view, line, truth);
  draw_line(canvas, view, road.driven_path, truth);
}

void draw_bars(Canvas& canvas, const PanelView& view, const CameraView& seen) {
  for (const ImageBar& bar : seen.bars) {
    canvas.line(view.at(bar.left, bar.row), view.at(bar.right, bar.row),
                bar.believed ? Pen{kHighResolution, 3} : Pen{kOther, 1});
  }
}

void draw_windows(Canvas& canvas, const PanelView& view, const CameraView& seen) {
  constexpr double kEnd = 3;  // [px] of the strokes at the ends, to each side
  for (const SearchWindow& window : seen.windows) {
    const Pixel left = view.at(window.left, window.row);
    const Pixel right = view.at(window.right, window.row);
    const Pen pen{window.found ? kSerial : kMuted, 1};
    canvas.line(left, right, pen);
    for (const Pixel& end : {left, right}) canvas.line(end - Pixel(0, kEnd), end + Pixel(0, kEnd), pen);
    if (window.found) canvas.disc(view.at(window.column, window.row), 3, kSerial);
  }
}

void draw_vehicles(Canvas& canvas, const PanelView& view, const CameraView& seen) {
  for (const VehicleBox& vehicle : seen.vehicles) {
    const Pixel corner = view.at(vehicle.left, vehicle.top);
    const Pixel size = view.at(vehicle.right, vehicle.bottom) - corner;
    canvas.rectangle({corner.x(), corner.y(), size.x(), size.y()}, {kVehicle, 2, 0, true});
    const std::string words = fmt::format("{:.0f} m", vehicle.distance);
    if (size.x() > Canvas::text_width(words, 9)) canvas.text(corner - Pixel(-1, 5), words, kVehicle, 9);
  }
}

void draw_fault(Canvas& canvas, const Box& box, const std::string& words) {
  const Pixel middle(box.left + box.width / 2, box.top + box.height / 2);
  const double half = Canvas::text_width(words, 16) / 2 + 16;
  canvas.fill(Box{middle.x() - half, middle.y() - 30, 2 * half, 48}, kPage, 0.8);
  canvas.text(middle, words, kAlarm, 16, Anchor::middle);
}

std::string fault_of(const OverlayScene& scene) {
  if (!scene.view) return scene.image.empty() ? "no image" : "the run did not look at this image";
  if (scene.view->fault == ImageFault::none) return scene.image.empty() ? "no image" : "";
  return fmt::format("not believed: image {}", to_string(scene.view->fault));
}

}  // namespace

void draw_camera_panel(Canvas& canvas, const Box& box, const OverlayScene& scene) {
  const PanelView view(box, scene);
  canvas.begin_clip(box);
  canvas.fill(box, {0, 0, 0});
  canvas.place(scene.image, box);
  if (scene.road) {
    draw_ego_lane(canvas, view, scene.road->estimate);
    draw_boundaries(canvas, view, *scene.road);
    draw_distances(canvas, view, scene.road->estimate);
  }
  if (scene.view) {
    draw_bars(canvas, view, *scene.view);
    draw_windows(canvas, view, *scene.view);
    draw_vehicles(canvas, view, *scene.view);
  }
  if (const std::string fault = fault_of(scene); !fault.empty()) draw_fault(canvas, box, fault);
  canvas.end_clip();
}

std::vector<OverlayLegendEntry> camera_panel_legend(const OverlayScene& scene) {
  std::vector<OverlayLegendEntry> entries{
      {"lane boundary, fused", OverlaySample::line, kBoundary},
      {"bar of paint, believed", OverlaySample::bar, kHighResolution},
      {"not believed", OverlaySample::faint_bar, kOther},
      {"search window, edge found", OverlaySample::window, kSerial},
      {"not found", OverlaySample::faint_window, kMuted},
      {"vehicle", OverlaySample::box, kVehicle},
  };
  if (scene.road && !scene.road->true_boundaries.empty()) {
    entries.push_back({"truth", OverlaySample::dashed_line, kTruth});
  } else if (scene.road && !scene.road->driven_path.empty()) {
    entries.push_back({"path driven later", OverlaySample::dashed_line, kTruth});
  }
  return entries;
}

}  // namespace lanefuse
