// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "simulation/image_air.hpp"

namespace lanefuse {
namespace {

constexpr double kShortestTruck = 8;  ///< [m]
constexpr std::array kCarPaints{0.62F, 0.35F, 0.22F, 0.05F, 0.035F, 0.10F};

Random draws_of(const SceneVehicle& vehicle) {
  return {static_cast<std::uint64_t>(vehicle.id), "looks of a vehicle"};
}

LinearColour paint_of(const SceneVehicle& vehicle, bool truck) {
  Random random = draws_of(vehicle);
  random.uniform();
  const double hue = random.uniform();
  if (truck) return hue < 0.5 ? grey(0.5F) : colour(0.30F, 0.16F, 0.10F);
  const float value = kCarPaints[static_cast<std::size_t>(random.uniform() * kCarPaints.size())];
  if (hue < 0.15) return colour(0.03F, 0.03F, 0.28F);
  if (hue < 0.3) return colour(0.25F, 0.09F, 0.04F);
  return grey(value);
}

/// Gathers a vehicle's faces in its own frame: x ahead from its rear, y to the left, z up.
class BodyPainter {
 public:
  /// `mirror`: 0, or how clearly the road mirrors the vehicle, which is all that is painted then.
  BodyPainter(const VehiclePlace& place, float mirror, ImageFaces& faces)
      : place_(place), mirror_(mirror), faces_(&faces) {
    const Eigen::Vector2d rear = place.ego_from_vehicle.position();
    distance_ = std::max(0.5, rear.norm());
    light_ = light_upright(rear.x(), rear.y(), faces.light());
    const Eigen::Vector2d eye = place.ego_from_vehicle.inverse() * Eigen::Vector2d(faces.eye().head<2>());
    seen_from_ = eye;
  }

  [[nodiscard]] bool shows_rear() const { return seen_from_.x() < 0; }
  [[nodiscard]] double eye_y() const { return seen_from_.y(); }

  /// Across the vehicle at x, from z to z, half as wide as said below and above.
  void across(const Eigen::Vector2d& x, const Eigen::Vector2d& z, const Eigen::Vector2d& half_width,
              const LinearColour& albedo) {
    add({{x[0], half_width[0], z[0]},
         {x[0], -half_width[0], z[0]},
         {x[1], -half_width[1], z[1]},
         {x[1], half_width[1], z[1]}},
        albedo * light_);
  }
  /// Beside its middle, from y to y.
  void patch(double x, const Eigen::Vector2d& y, const Eigen::Vector2d& z, const LinearColour& radiance) {
    add({{x, y[0], z[0]}, {x, y[1], z[0]}, {x, y[1], z[1]}, {x, y[0], z[1]}}, radiance);
  }
  /// Along its side at y: from x to x below and above.
  void side(double y, const Eigen::Vector4d& x, const Eigen::Vector2d& z, const LinearColour& albedo) {
    add({{x[0], y, z[0]}, {x[1], y, z[0]}, {x[3], y, z[1]}, {x[2], y, z[1]}}, albedo * light_ * 0.85F);
  }
  void wheel(double x, double y, double radius) {
    std::vector<Eigen::Vector3d> rim;
    for (int i = 0; i < 8; ++i) {
      const double angle = (i + 0.5) * 0.7853981633974483;
      rim.emplace_back(x + radius * std::cos(angle), y, radius + radius * std::sin(angle));
    }
    add(rim, grey(0.02F) * light_);
  }
  [[nodiscard]] const LinearColour& light() const { return light_; }
  [[nodiscard]] bool night() const { return faces_->light().headlights; }

 private:
  VehiclePlace place_;
  float mirror_;
  ImageFaces* faces_;
  double distance_ = 0;
  LinearColour light_;
  Eigen::Vector2d seen_from_;

  void add(std::vector<Eigen::Vector3d> corners, const LinearColour& radiance) {
    for (Eigen::Vector3d& corner : corners) {
      const Eigen::Vector2d at = place_.ego_from_vehicle * Eigen::Vector2d(corner.head<2>());
      corner = {at.x(), at.y(), place_.ground + (mirror_ > 0 ? -corner.z() : corner.z())};
    }
    faces_->add(corners, distance_, {radiance, mirror_ > 0 ? mirror_ : 1.0F});
  }
};

LinearColour tail_light(const BodyPainter& painter) {
  return painter.night() ? colour(0.05F, 0.06F, 1.3F) : colour(0.02F, 0.02F, 0.30F) * painter.light();
}

void paint_car(const VehicleBody& body, const LinearColour& paint, BodyPainter& painter) {
  const double half = body.width / 2;
  const double belt = 0.63 * body.height;
  const LinearColour glass = grey(0.05F);
  const LinearColour dark = grey(0.03F);
  const double roof_end = std::min(body.length - 1.3, 3.0);
  for (const double y : {half, -half}) {
    if ((painter.eye_y() - y) * y <= 0) continue;
    painter.side(y, {0.05, body.length, 0, body.length}, {0.3, belt}, paint);
    painter.side(y * 0.94, {0.15, roof_end + 0.8, 0.7, roof_end}, {belt, body.height - 0.08}, glass);
    painter.side(y * 0.88, {0.7, roof_end, 0.9, roof_end - 0.2}, {body.height - 0.08, body.height}, paint);
    painter.wheel(0.75, y, 0.32);
    painter.wheel(body.length - 0.85, y, 0.32);
  }
  if (!painter.shows_rear()) return;
  for (const double y : {half - 0.12, -half + 0.12}) {
    painter.patch(0.4, {y - 0.1, y + 0.1}, {0, 0.5}, grey(0.015F) * painter.light());
  }
  painter.across({0.3, 0.3}, {0.18, 0.4}, {half * 0.8, half * 0.9}, dark);
  painter.across({0, 0}, {0.3, 0.55}, {half * 0.97, half}, paint * 0.7F);
  painter.across({0, 0.1}, {0.55, belt}, {half, half * 0.97}, paint);
  painter.across({0.12, 0.7}, {belt, body.height - 0.05}, {half * 0.93, half * 0.76}, glass);
  painter.across({0.7, 0.9}, {body.height - 0.06, body.height}, {half * 0.78, half * 0.72}, paint);
  for (const double side : {1.0, -1.0}) {
    painter.patch(-0.01, {side * half * 0.97, side * half * 0.68}, {0.68, 0.84}, tail_light(painter));
  }
  painter.patch(-0.01, {-0.26, 0.26}, {0.6, 0.72}, grey(0.55F) * painter.light());
}

void paint_truck(const VehicleBody& body, const LinearColour& paint, BodyPainter& painter) {
  const double half = body.width / 2;
  for (const double y : {half, -half}) {
    if ((painter.eye_y() - y) * y <= 0) continue;
    painter.side(y, {0, body.length, 0, body.length}, {1.05, body.height}, paint);
    painter.side(y, {0.6, body.length - 0.5, 0.6, body.length - 0.5}, {0.5, 1.05}, grey(0.04F));
    for (const double x : {1.6, 2.9, 4.2, body.length - 1.4}) painter.wheel(x, y, 0.5);
  }
  if (!painter.shows_rear()) return;
  for (const double side : {1.0, -1.0}) {
    painter.patch(1.2, {side * half * 0.98, side * half * 0.55}, {0, 1}, grey(0.015F) * painter.light());
  }
  painter.across({0.8, 0.8}, {0.55, 1.05}, {half * 0.95, half * 0.95}, grey(0.03F));
  painter.across({0.1, 0.1}, {0.45, 0.62}, {half * 0.98, half * 0.98}, grey(0.18F));
  painter.across({0, 0}, {1.05, body.height}, {half, half}, paint);
  painter.patch(-0.01, {0.015, -0.015}, {1.1, body.height - 0.05}, grey(0.08F) * painter.light());
  for (const double side : {1.0, -1.0}) {
    painter.patch(0.05, {side * half * 0.95, side * half * 0.72}, {0.68, 0.86}, tail_light(painter));
  }
}

void paint_vehicle(const SceneVehicle& vehicle, BodyPainter painter) {
  const VehicleBody body = body_of(vehicle);
  const LinearColour paint = paint_of(vehicle, body.truck);
  if (body.truck) {
    paint_truck(body, paint, painter);
  } else {
    paint_car(body, paint, painter);
  }
}

}  // namespace

VehicleBody body_of(const SceneVehicle& vehicle) {
  Random random = draws_of(vehicle);
  const double draw = random.uniform();
  VehicleBody body;
  body.length = vehicle.front + vehicle.rear;
  body.width = vehicle.width;
  body.truck = body.length > kShortestTruck;
  if (body.truck) {
    body.height = 3.6 + 0.4 * draw;
  } else {
    body.height = draw < 0.12 ? 2.0 : 1.4 + 0.2 * draw;
  }
  return body;
}

VehiclePlace place_of_vehicle(const SceneVehicle& vehicle, const Scene& scene) {
  const Pose2 world_from_rear = vehicle.world_from_vehicle * Pose2{-vehicle.rear, 0, 0};
  return {scene.ego.world_from_vehicle.inverse() * world_from_rear,
          scene.road->height().above_tangent(scene.ego.station, vehicle.station)};
}

void add_vehicle(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces) {
  paint_vehicle(vehicle, BodyPainter(place_of_vehicle(vehicle, scene), 0, faces));
}

void add_mirrored_vehicle(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces) {
  paint_vehicle(vehicle, BodyPainter(place_of_vehicle(vehicle, scene), 0.4F * faces.light().mirror, faces));
}

void add_vehicle_shadow(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces) {
  const VehicleBody body = body_of(vehicle);
  const VehiclePlace place = place_of_vehicle(vehicle, scene);
  const double distance = std::max(0.5, place.ego_from_vehicle.position().norm());
  const ImageLight& light = faces.light();
  const auto darken = [&](double grown, const Eigen::Vector2d& moved, float opacity) {
    std::vector<Eigen::Vector3d> corners;
    for (const auto& [x, y] : {std::pair(0, 1), std::pair(0, -1), std::pair(1, -1), std::pair(1, 1)}) {
      const Eigen::Vector2d own(x == 0 ? -grown : body.length + grown, y * (body.width / 2 + grown));
      const Eigen::Vector2d at = place.ego_from_vehicle * own + moved;
      corners.emplace_back(at.x(), at.y(), place.ground);
    }
    faces.add(corners, distance, {grey(0), opacity});
  };
  for (const double grown : {0.15, 0.0, -0.15}) darken(grown, {0, 0}, light.headlights ? 0.2F : 0.38F);
  const float direct = light.sun.head<3>().sum() / (light.sun + light.ambient).head<3>().sum();
  if (direct <= 0) return;
  const double azimuth = light.sun_azimuth - scene.ego.world_from_vehicle.heading;
  const double reach = std::min(12.0, body.height / std::tan(light.sun_height));
  const Eigen::Vector2d away(-std::cos(azimuth), -std::sin(azimuth));
  for (const double part : {0.45, 0.9}) darken(0, part * reach * away, 0.6F * direct);
}

}  // namespace lanefuse
