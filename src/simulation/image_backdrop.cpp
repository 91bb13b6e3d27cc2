// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "core/pose2.hpp"

namespace lanefuse {
namespace {

constexpr double kHillDistance = 4000;  ///< [m]
constexpr double kWoodsDistance = 700;  ///< [m]
constexpr double kTexelsARadian = 900;

/// How high the woods and the hills stand over the horizon in a direction of the world [rad].
double skyline(const TextureTile& texture, double bearing, double row, double mean, double spread) {
  const TextureTile::Level fine = texture.level(0.02, 0.02);
  return std::max(0.0, mean + spread * fine.at(bearing * kTexelsARadian * 0.02, row));
}

}  // namespace

ImageBackdrop::ImageBackdrop(const GroundRays& rays, const CameraIntrinsics& camera, const ImageLight& light,
                             const TextureTile& texture, double heading)
    : light_(light), texture_(&texture), pixels_a_radian_(camera.fx) {
  columns_.resize(static_cast<std::size_t>(camera.width));
  const Eigen::Vector3d ahead = rays.ray({camera.cx, camera.cy});
  bearing_ = (heading + std::atan2(ahead.y(), ahead.x())) * pixels_a_radian_;
  sun_column_ = camera.cx -
                wrap_angle(light.sun_azimuth - heading - std::atan2(ahead.y(), ahead.x())) * pixels_a_radian_;
  for (int u = 0; u < camera.width; ++u) {
    // The ray in the row of the principal point, and how far it is from level.
    const Eigen::Vector3d ray = rays.ray({static_cast<double>(u), camera.cy});
    Column& column = columns_[static_cast<std::size_t>(u)];
    const double horizon = camera.cy + camera.fy * ray.z();
    const double bearing = heading + std::atan2(ray.y(), ray.x());
    column.horizon = static_cast<float>(horizon);
    column.woods = static_cast<float>(horizon - camera.fy * skyline(texture, bearing, 1.3, 0.018, 0.006));
    column.hills =
        static_cast<float>(horizon - camera.fy * skyline(texture, bearing * 0.12, 3.1, 0.03, 0.014));
    column.sun = static_cast<float>((u - sun_column_) * (u - sun_column_));
  }
  sun_row_ = -light.sun_height * camera.fy;
}

Colour ImageBackdrop::sky(const Column& column, double v) const {
  const double height = std::max(0.0, (column.horizon - v) / pixels_a_radian_);
  const auto up = static_cast<float>(1 - std::exp(-height / 0.22));
  Colour colour = light_.horizon + up * (light_.sky - light_.horizon);
  const double row = v - column.horizon - sun_row_;
  const auto from_sun = static_cast<float>((column.sun + row * row) / (pixels_a_radian_ * pixels_a_radian_));
  const float direct = light_.sun.head<3>().maxCoeff();
  if (direct > 0)
    colour += light_.sun * (2.2F * std::exp(-from_sun / 0.02F) + (from_sun < 2e-4F ? 30.0F : 0.0F));
  return colour;
}

void ImageBackdrop::draw_row(int v, Colour* pixels) const {
  const auto row = static_cast<float>(v);
  const Colour lit = 0.7F * light_.ambient + 0.3F * light_.sun;
  const auto far_away = [&](const Colour& albedo, double distance) {
    const auto kept = static_cast<float>(std::exp(-3.9 * distance / light_.visibility));
    return Colour(light_.horizon + kept * (albedo * lit - light_.horizon));
  };
  const Colour fields = far_away(colour(0.06F, 0.15F, 0.12F), 600);
  const Colour woods = far_away(colour(0.04F, 0.09F, 0.06F), kWoodsDistance);
  const Colour hills = far_away(colour(0.09F, 0.11F, 0.08F), kHillDistance);
  const TextureTile::Level leaves = texture_->level(0.04, 0.04);
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    const Column& column = columns_[u];
    const float below_horizon = std::clamp(row - column.horizon + 0.5F, 0.0F, 1.0F);
    const float in_woods = std::clamp(row - column.woods + 0.5F, 0.0F, 1.0F);
    const float in_hills = std::clamp(row - column.hills + 0.5F, 0.0F, 1.0F);
    Colour colour = in_woods < 1 ? sky(column, row) : woods;
    colour += in_hills * (hills - colour);
    if (in_woods > 0 && below_horizon < 1) {
      const double bearing = bearing_ - static_cast<double>(u);
      const float leaf = leaves.at(bearing * 0.012, (row - column.horizon) * 0.012);
      colour += in_woods * (woods * (1 + 0.22F * leaf) - colour);
    }
    pixels[u] = colour + below_horizon * (fields - colour);
  }
}

}  // namespace lanefuse
