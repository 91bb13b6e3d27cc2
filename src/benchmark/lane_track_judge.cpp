// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/lane_track_judge.hpp"

#include <algorithm>
#include <cmath>

#include "benchmark/true_lines.hpp"

namespace lanefuse {
namespace {

constexpr double kNear = 50;      ///< [m] up to which boxes are judged
constexpr double kSameBox = 0.5;  ///< of intersection over union
constexpr double kMostlyShown = 0.5;

const TrueLine* find(const std::vector<TrueLine>& lines, int line) {
  const auto found =
      std::find_if(lines.begin(), lines.end(), [line](const TrueLine& l) { return l.line == line; });
  return found == lines.end() ? nullptr : &*found;
}

/// Sideways uncertainty of a clothoid `x` [m] ahead.
double sigma_at(const ClothoidMeasurement& side, double x) {
  const Eigen::Vector4d gradient(1, x, x * x / 2, x * x * x / 6);
  return std::sqrt(std::max(0.0, gradient.dot(side.covariance * gradient)));
}

void judge_side(const TrueLine& line, const ClothoidMeasurement& side, LaneTrackFigures& figures) {
  for (int i = 0; i < LaneTrackFigures::kDistances; ++i) {
    const double x = 10.0 * i;
    const auto place = line.at(x);
    if (!place || x > side.range_end) continue;
    const double error = (side.clothoid.y(x) - place->y) * std::cos(std::atan(place->slope));
    figures.lateral[static_cast<std::size_t>(i)].add(error, sigma_at(side, x));
  }
}

}  // namespace

LaneTrackFigures& LaneTrackFigures::operator+=(const LaneTrackFigures& other) {
  tracked += other.tracked;
  range_sum += other.range_sum;
  for (std::size_t i = 0; i < lateral.size(); ++i) lateral[i] += other.lateral[i];
  pitch += other.pitch;
  yaw += other.yaw;
  roll += other.roll;
  vehicles_found += other.vehicles_found;
  boxes_true += other.boxes_true;
  return *this;
}

void judge_lane(const Scene& scene, const ImageTruth& truth, const std::optional<SerialLane>& lane,
                LaneTrackFigures& figures) {
  figures.tracked.add(lane && lane->left && lane->right);
  if (!lane || !lane->left || !lane->right) return;
  figures.range_sum += std::min(lane->left->range_end, lane->right->range_end);
  const Road& road = *scene.road;
  const auto ego_lane = road.lane_at(scene.ego.station, scene.ego.lateral);
  if (!ego_lane) return;
  const int left = road.left_line(*ego_lane);
  const std::vector<TrueLine> lines = true_lines(scene, truth, [&road, left](int line, double station) {
    return (line <= left ? -0.5 : 0.5) * road.marking_width(line, station);
  });
  if (const TrueLine* line = find(lines, left)) judge_side(*line, *lane->left, figures);
  if (const TrueLine* line = find(lines, road.right_line(*ego_lane)))
    judge_side(*line, *lane->right, figures);
}

void judge_pose(const ImageTruth& truth, const CameraView& view, LaneTrackFigures& figures) {
  const Mounting& believed = view.pose.mounting;
  const Mounting& real = truth.pose().mounting;
  figures.pitch.add(believed.pitch - real.pitch, std::sqrt(view.pose.covariance(2, 2)));
  figures.yaw.add(believed.yaw - real.yaw, std::sqrt(view.pose.covariance(3, 3)));
  figures.roll.add(believed.roll - real.roll, std::sqrt(view.pose.covariance(1, 1)));
}

double overlap(const VehicleBox& a, const VehicleBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (width <= 0 || height <= 0) return 0;
  const auto area = [](const VehicleBox& box) { return (box.right - box.left) * (box.bottom - box.top); };
  return width * height / (area(a) + area(b) - width * height);
}

void judge_vehicles(const std::vector<VehicleBox>& true_boxes, const std::vector<VehicleBox>& seen,
                    LaneTrackFigures& figures) {
  const auto is_among = [](const VehicleBox& box, const std::vector<VehicleBox>& boxes) {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&box](const VehicleBox& other) { return overlap(box, other) >= kSameBox; });
  };
  for (const VehicleBox& box : true_boxes) {
    if (box.distance < kNear && box.confidence >= kMostlyShown)
      figures.vehicles_found.add(is_among(box, seen));
  }
  for (const VehicleBox& box : seen) {
    if (box.distance < kNear) figures.boxes_true.add(is_among(box, true_boxes));
  }
}

}  // namespace lanefuse
