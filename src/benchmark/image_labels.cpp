// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/image_labels.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/lane_track_judge.hpp"
#include "camera/ground_projection.hpp"
#include "core/error.hpp"
#include "core/pose2.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::json;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kNear = 50;        ///< [m] up to which boxes are judged
constexpr double kSameBox = 0.5;    ///< of intersection over union
constexpr double kLineBegin = 3;    ///< [m] from which on boundaries are drawn
constexpr double kLineStep = 0.5;   ///< [m]
constexpr double kLineBeyond = 30;  ///< [m] that a boundary is drawn beyond the range of the labels

Points points_of(const Json& boundaries, const char* name) {
  Points points;
  if (!boundaries.contains(name)) return points;
  for (const Json& point : boundaries.at(name)) points.emplace_back(point.at(0), point.at(1));
  return points;
}

ImageLabels frame_of(const Json& json) {
  ImageLabels labels;
  labels.clip = json.at("clip");
  labels.frame = json.at("frame");
  const Json& boundaries = json.at("boundaries");
  labels.ego_left = points_of(boundaries, "ego_left");
  labels.ego_right = points_of(boundaries, "ego_right");
  labels.right_outer = points_of(boundaries, "right_outer");
  for (const Json& vehicle : json.at("vehicles")) {
    VehicleBox box;
    box.left = vehicle.at("left");
    box.top = vehicle.at("top");
    box.right = vehicle.at("right");
    box.bottom = vehicle.at("bottom");
    const bool cut = vehicle.at("partial").get<bool>() || vehicle.at("occluded").get<bool>();
    labels.vehicles.push_back({box, vehicle.at("near"), cut});
  }
  return labels;
}

/// A boundary as the image would show it: its column by row, from near to far.
Points drawn(const Boundary& boundary, const Pose2& then_from_now, const GroundProjection& projection,
             double range) {
  Points line;
  for (double x = kLineBegin; x <= range + kLineBeyond; x += kLineStep) {
    const Eigen::Vector2d now(x, lateral_at(boundary, x));
    const auto pixel = projection.pixel(then_from_now * now);
    if (pixel && (line.empty() || pixel->y() < line.back().y())) line.push_back(*pixel);
  }
  return line;
}

/// The line's column in a row; nothing where it is not drawn.
std::optional<double> column_at(const Points& line, double row) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d& below = line[i - 1];
    const Eigen::Vector2d& above = line[i];
    if (!(above.y() <= row && row <= below.y())) continue;
    const double part = (below.y() - row) / std::max(1e-9, below.y() - above.y());
    return below.x() + part * (above.x() - below.x());
  }
  return {};
}

Points within(const Points& points, const GroundProjection& projection, double range) {
  Points near;
  std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](const Eigen::Vector2d& point) {
    const auto ground = projection.ground(point);
    return ground && ground->x() <= range;
  });
  return near;
}

bool lies_on(const Points& labels, const Points& line, double tolerance) {
  return std::all_of(labels.begin(), labels.end(), [&](const Eigen::Vector2d& label) {
    const auto column = column_at(line, label.y());
    return column && std::abs(*column - label.x()) <= tolerance;
  });
}

/// The middle of the lane to the right, in the rows of its outer boundary's labels.
Points dummy_line(const ImageLabels& labels) {
  Points inner = labels.ego_right;
  std::sort(inner.begin(), inner.end(), [](const auto& a, const auto& b) { return a.y() > b.y(); });
  Points dummy;
  for (const Eigen::Vector2d& outer : labels.right_outer) {
    if (const auto column = column_at(inner, outer.y())) {
      dummy.emplace_back((*column + outer.x()) / 2, outer.y());
    }
  }
  return dummy;
}

void judge_boxes(const ImageLabels& labels, const CameraView& view, LabelFigures& figures) {
  const auto is_same = [](const VehicleBox& a, const VehicleBox& b) { return overlap(a, b) >= kSameBox; };
  for (const ImageLabels::Vehicle& vehicle : labels.vehicles) {
    if (!vehicle.near || vehicle.partial) continue;
    figures.vehicles_found.add(std::any_of(view.vehicles.begin(), view.vehicles.end(),
                                           [&](const VehicleBox& box) { return is_same(box, vehicle.box); }));
  }
  for (const VehicleBox& box : view.vehicles) {
    if (box.distance >= kNear) continue;
    figures.boxes_true.add(std::any_of(labels.vehicles.begin(), labels.vehicles.end(),
                                       [&](const auto& vehicle) { return is_same(box, vehicle.box); }));
  }
}

}  // namespace

std::vector<ImageLabels> load_image_labels(const std::filesystem::path& file, const std::string& clip) {
  std::ifstream stream(file);
  if (!stream) throw input_error(file.string(), "cannot be read");
  std::vector<ImageLabels> frames;
  try {
    const Json labelled = Json::parse(stream);
    for (const Json& json : labelled.at("frames")) {
      ImageLabels labels = frame_of(json);
      if (labels.clip == clip) frames.push_back(std::move(labels));
    }
  } catch (const Json::exception& error) {
    throw input_error(file.string(), fmt::format("is no file of image labels: {}", error.what()));
  }
  if (frames.empty()) throw input_error(file.string(), fmt::format("has no labels of a clip '{}'", clip));
  return frames;
}

LabelFigures& LabelFigures::operator+=(const LabelFigures& other) {
  ego_left += other.ego_left;
  ego_right += other.ego_right;
  ego_both += other.ego_both;
  right_outer += other.right_outer;
  dummy += other.dummy;
  for (std::size_t i = 0; i < error_px.size(); ++i) error_px[i] += other.error_px[i];
  vehicles_found += other.vehicles_found;
  boxes_true += other.boxes_true;
  return *this;
}

void judge_labels(const ImageLabels& labels, const LaneEstimate& estimate, const CameraView& view,
                  const CameraModel& camera, const LabelTolerance& tolerance, LabelFigures& figures) {
  const GroundProjection projection(camera, view.pose);
  const Pose2 then_from_now =
      constant_turn(estimate.speed, estimate.yaw_rate, to_seconds(estimate.time - view.measured_at));
  std::vector<Points> lines;
  for (const Boundary& boundary : estimate.boundaries) {
    lines.push_back(drawn(boundary, then_from_now, projection, tolerance.range));
  }
  const auto line_of = [&](std::uint64_t id) -> const Points& {
    const auto place = std::find_if(estimate.boundaries.begin(), estimate.boundaries.end(),
                                    [id](const Boundary& boundary) { return boundary.id == id; });
    return lines[static_cast<std::size_t>(place - estimate.boundaries.begin())];
  };
  const auto side_found = [&](const Points& points, const Points* line) {
    const Points near = within(points, projection, tolerance.range);
    for (const Eigen::Vector2d& label : near) {
      if (const auto column = line ? column_at(*line, label.y()) : std::nullopt) {
        const auto bin = static_cast<std::size_t>(projection.ground(label)->x() / LabelFigures::kBinLength);
        if (bin < figures.error_px.size()) figures.error_px[bin].add(*column - label.x());
      }
    }
    return line && !near.empty() && lies_on(near, *line, tolerance.pixels);
  };
  const auto any_found = [&](const Points& points) {
    const Points near = within(points, projection, tolerance.range);
    return !near.empty() && std::any_of(lines.begin(), lines.end(), [&](const Points& line) {
      return lies_on(near, line, tolerance.pixels);
    });
  };
  const Lane* ego = ego_lane(estimate);
  const bool left = side_found(labels.ego_left, ego ? &line_of(ego->left_boundary) : nullptr);
  const bool right = side_found(labels.ego_right, ego ? &line_of(ego->right_boundary) : nullptr);
  figures.ego_left.add(left);
  figures.ego_right.add(right);
  figures.ego_both.add(left && right);
  if (!labels.right_outer.empty()) figures.right_outer.add(any_found(labels.right_outer));
  const Points dummy = dummy_line(labels);
  if (!dummy.empty()) figures.dummy.add(any_found(dummy));
  judge_boxes(labels, view, figures);
}

}  // namespace lanefuse
