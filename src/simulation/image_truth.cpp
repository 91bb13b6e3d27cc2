// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "simulation/roadside.hpp"
#include "simulation/vehicle_faces.hpp"

namespace lanefuse {
namespace {

constexpr double kNearest = 2;     ///< [m]
constexpr double kFarthest = 200;  ///< [m]

/// The curvature of z = k x^2 / 2 that comes nearest to the road's heights.
double vertical_curvature(const Scene& scene) {
  double product = 0, squares = 0;
  for (double x = 5; x <= 100; x += 5) {
    const double parabola = x * x / 2;
    product += parabola * scene.road->height().above_tangent(scene.ego.station, scene.ego.station + x);
    squares += parabola * parabola;
  }
  return product / squares;
}

CameraPose pose_of(const Scene& scene, const Mounting& mounting) {
  CameraPose pose;
  pose.mounting = mounting;
  pose.vertical_curvature = vertical_curvature(scene);
  return pose;
}

/// Whether the segment between two points passes through a box on the ground: by the slabs.
bool passes(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& low,
            const Eigen::Vector3d& high) {
  double enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    const double way = to[i] - from[i];
    if (std::abs(way) < 1e-12) {
      if (from[i] < low[i] || from[i] > high[i]) return false;
      continue;
    }
    const double a = (low[i] - from[i]) / way;
    const double b = (high[i] - from[i]) / way;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

/// The share of a box that none of the others covers, on a grid.
double uncovered(const VehicleBox& box, std::span<const VehicleBox> others) {
  constexpr int kGrid = 16;
  int free = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int column = i % kGrid;
    const int line = i / kGrid;
    const double u = box.left + (column + 0.5) / kGrid * (box.right - box.left);
    const double v = box.top + (line + 0.5) / kGrid * (box.bottom - box.top);
    const bool covered = std::any_of(others.begin(), others.end(), [&](const VehicleBox& other) {
      return other.left < u && u < other.right && other.top < v && v < other.bottom;
    });
    free += covered ? 0 : 1;
  }
  return static_cast<double>(free) / (kGrid * kGrid);
}

}  // namespace

ImageTruth::ImageTruth(const Scene& scene, const CameraModel& camera, const Mounting& mounting)
    : scene_(&scene),
      camera_(&camera),
      pose_(pose_of(scene, mounting)),
      flat_(camera, CameraPose{mounting, 0, Eigen::Matrix4d::Zero(), 0}) {}

std::optional<Eigen::Vector2d> ImageTruth::pixel(double station, double lateral, double height) const {
  const Pose2 place = scene_->ego.world_from_vehicle.inverse() * scene_->road->pose(station, lateral);
  const double road = scene_->road->height().above_tangent(scene_->ego.station, station);
  return flat_.pixel(place.position(), road + height);
}

std::vector<int> ImageTruth::lines() const {
  std::vector<int> lines;
  const double here = scene_->ego.station;
  for (int line = 0; line < scene_->road->line_count(); ++line) {
    if (scene_->road->line_runs_within(line, {here, here + kFarthest})) lines.push_back(line);
  }
  return lines;
}

std::optional<TrueMarking> ImageTruth::marking_at(int line, double station) const {
  const Road& road = *scene_->road;
  const double lateral = road.line_lateral(line, station);
  const auto centre = pixel(station, lateral);
  if (!centre || !road.line_exists(line, station)) return {};
  // The edges in this very row: the line's course there is straight enough to be cut at one row.
  const double half = road.marking_width(line, station) / 2;
  const auto column_at_row = [&](double offset) {
    const auto here = pixel(station, lateral + offset);
    const auto ahead = pixel(station + 0.5, road.line_lateral(line, station + 0.5) + offset);
    if (!here || !ahead || here->y() == ahead->y()) return centre->x();
    return here->x() + (centre->y() - here->y()) / (ahead->y() - here->y()) * (ahead->x() - here->x());
  };
  TrueMarking marking;
  marking.line = line;
  marking.row = centre->y();
  marking.column = centre->x();
  marking.left = column_at_row(half);
  marking.right = column_at_row(-half);
  marking.station = station;
  marking.ground = (scene_->ego.world_from_vehicle.inverse() * road.pose(station, lateral)).position();
  marking.painted = road.painted(line, station);
  marking.hidden = hidden(station, lateral);
  return marking;
}

std::optional<TrueMarking> ImageTruth::marking(int line, double row) const {
  const Road& road = *scene_->road;
  const double here = scene_->ego.station;
  // How far below the row the line is: falls with the distance, but for crests.
  const auto below = [&](double x) {
    const auto at = pixel(here + x, road.line_lateral(line, here + x));
    return at ? at->y() - row : std::numeric_limits<double>::infinity();
  };
  constexpr double kGrowth = 1.08;
  double near = kNearest;
  if (below(near) < 0) return {};
  for (double far = near; far < kFarthest;) {
    far = std::min(near * kGrowth, kFarthest);
    if (below(far) < 0) {
      constexpr int kHalvings = 40;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (near + far) / 2;
        (below(middle) < 0 ? far : near) = middle;
      }
      return marking_at(line, here + (near + far) / 2);
    }
    near = far;
  }
  return {};
}

bool ImageTruth::hidden(double station, double lateral) const {
  const Pose2 place = scene_->ego.world_from_vehicle.inverse() * scene_->road->pose(station, lateral);
  const Eigen::Vector3d point(place.x, place.y,
                              scene_->road->height().above_tangent(scene_->ego.station, station));
  return behind_a_vehicle(point) || behind_a_rail(point, station);
}

bool ImageTruth::behind_a_vehicle(const Eigen::Vector3d& point) const {
  const Mounting& eye = pose_.mounting;
  return std::any_of(scene_->vehicles.begin(), scene_->vehicles.end(), [&](const SceneVehicle& vehicle) {
    const VehicleBody body = body_of(vehicle);
    const VehiclePlace place = place_of_vehicle(vehicle, *scene_);
    const Pose2 vehicle_from_ego = place.ego_from_vehicle.inverse();
    const auto own = [&](double x, double y, double z) {
      const Eigen::Vector2d at = vehicle_from_ego * Eigen::Vector2d(x, y);
      return Eigen::Vector3d(at.x(), at.y(), z - place.ground);
    };
    const double half = body.width / 2;
    return passes(own(eye.x, eye.y, eye.z), own(point.x(), point.y(), point.z() + 0.01), {0, -half, 0},
                  {body.length, half, body.height});
  });
}

/// On the way from the camera to the point, the sight may cross a rail at the height of its beam.
bool ImageTruth::behind_a_rail(const Eigen::Vector3d& point, double station) const {
  const Mounting& eye = pose_.mounting;
  const Road& road = *scene_->road;
  const Pose2& ego = scene_->ego.world_from_vehicle;
  constexpr double kPiece = 2;  // [m]
  for (double x = kPiece; x < point.x(); x += kPiece) {
    const double share = x / point.x();
    const Eigen::Vector2d at = ego * Eigen::Vector2d(x, eye.y + share * (point.y() - eye.y));
    const double there = scene_->ego.station + share * (station - scene_->ego.station);
    const double lateral = (road.pose(there, 0).inverse() * at).y();
    const double height =
        eye.z + share * (point.z() - eye.z) - road.height().above_tangent(scene_->ego.station, there);
    const bool outside = lateral > road.guard_rail(+1, there) || lateral < road.guard_rail(-1, there);
    if (outside && height < kRailTop) return true;
  }
  return false;
}

/// Around all corners that are before the camera; nothing where none is.
std::optional<VehicleBox> ImageTruth::box_of(const SceneVehicle& vehicle) const {
  const double right = camera_->intrinsics().width - 0.5;
  const double bottom = camera_->intrinsics().height - 0.5;
  const VehicleBody body = body_of(vehicle);
  const VehiclePlace place = place_of_vehicle(vehicle, *scene_);
  const Eigen::Vector2d rear = place.ego_from_vehicle.position();
  constexpr int kCorners = 8;
  int before = 0;
  VehicleBox box{right + 1, bottom + 1, -1, -1, rear.x(), rear.y(), body.width, 1};
  for (int i = 0; i < kCorners; ++i) {
    const Eigen::Vector2d own((i & 1) != 0 ? body.length : 0, ((i & 2) != 0 ? 0.5 : -0.5) * body.width);
    const double height = place.ground + ((i & 4) != 0 ? body.height : 0);
    const auto seen = flat_.pixel(place.ego_from_vehicle * own, height);
    if (!seen) continue;
    ++before;
    box.left = std::min(box.left, seen->x());
    box.right = std::max(box.right, seen->x());
    box.top = std::min(box.top, seen->y());
    box.bottom = std::max(box.bottom, seen->y());
  }
  if (before == 0) return {};
  if (before < kCorners) {
    // It reaches back past the camera, and so to the image's border.
    if (rear.y() > 0) box.left = -0.5;
    if (rear.y() <= 0) box.right = right;
    box.bottom = bottom;
  }
  box.left = std::max(box.left, -0.5);
  box.top = std::max(box.top, -0.5);
  box.right = std::min(box.right, right);
  box.bottom = std::min(box.bottom, bottom);
  if (box.left >= box.right || box.top >= box.bottom) return {};
  return box;
}

std::vector<VehicleBox> ImageTruth::vehicles() const {
  std::vector<VehicleBox> boxes;
  constexpr double kFarthestBox = 250;  // [m]
  for (const SceneVehicle& vehicle : scene_->vehicles) {
    const auto box = box_of(vehicle);
    if (box && box->distance < kFarthestBox) boxes.push_back(*box);
  }
  std::sort(boxes.begin(), boxes.end(),
            [](const VehicleBox& a, const VehicleBox& b) { return a.distance < b.distance; });
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].confidence = uncovered(boxes[i], {boxes.data(), i});
  return boxes;
}

}  // namespace lanefuse
