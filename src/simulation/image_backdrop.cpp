// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "core/pose2.hpp"
#include "simulation/image_air.hpp"

namespace lanefuse {
namespace {

constexpr double kHillDistance = 4000;  ///< [m]
constexpr double kWoodsDistance = 700;  ///< [m]
constexpr double kTexelsARadian = 900;
constexpr double kGlow = 0.02;  ///< [rad^2] of the sky around the sun

/// How high the woods and the hills stand over the horizon in a direction of the world [rad].
double skyline(const TextureTile& texture, double bearing, double row, double mean, double spread) {
  const TextureTile::Level fine = texture.level(0.02, 0.02);
  return std::max(0.0, mean + spread * fine.at(bearing * kTexelsARadian * 0.02, row));
}

}  // namespace

ImageBackdrop::ImageBackdrop(const GroundRays& rays, const CameraIntrinsics& camera, const ImageLight& light,
                             const TextureTile& texture, double heading)
    : light_(light),
      texture_(&texture),
      pixels_a_radian_(camera.fx),
      sun_height_(light.sun_height * camera.fy),
      columns_(static_cast<std::size_t>(camera.width)) {
  const Eigen::Vector3d ahead = rays.ray({camera.cx, camera.cy});
  const double view = heading + std::atan2(ahead.y(), ahead.x());
  bearing_ = view * pixels_a_radian_;
  const double sun_column = camera.cx - wrap_angle(light.sun_azimuth - view) * pixels_a_radian_;
  const float sun = light.sun.head<3>().maxCoeff() > 0 ? 1 : 0;
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
    const double off = (u - sun_column) / pixels_a_radian_;
    column.glow = sun * static_cast<float>(std::exp(-off * off / kGlow));
  }
  lay_sky(camera.height);
}

void ImageBackdrop::lay_sky(int height) {
  sky_.reserve(static_cast<std::size_t>(2 * height));
  for (int i = 0; i < 2 * height; ++i) {
    const auto up = static_cast<float>(1 - std::exp(-i / pixels_a_radian_ / 0.22));
    sky_.push_back(light_.horizon + up * (light_.sky - light_.horizon));
  }
}

float ImageBackdrop::glow_of_row(float above_horizon) const {
  const double off = (above_horizon - sun_height_) / pixels_a_radian_;
  return static_cast<float>(std::exp(-off * off / kGlow));
}

void ImageBackdrop::draw_row(int v, LinearColour* pixels) const {
  const auto row = static_cast<float>(v);
  const LinearColour lit = 0.7F * light_.ambient + 0.3F * light_.sun;
  const LinearColour fields = through_air(colour(0.06F, 0.15F, 0.12F) * lit, 600, light_);
  const LinearColour trees = colour(0.04F, 0.09F, 0.06F) * lit;
  const LinearColour woods = through_air(trees, kWoodsDistance, light_);
  const LinearColour leaf_contrast = 0.25F * air_transmission(kWoodsDistance, light_) * trees;
  const LinearColour hills = through_air(colour(0.09F, 0.11F, 0.08F) * lit, kHillDistance, light_);
  const TextureTile::Level leaves = texture_->level(0.04, 0.04);
  const Column& middle = columns_[columns_.size() / 2];
  const LinearColour glow = light_.sun * (2.2F * glow_of_row(middle.horizon - row));
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    const Column& column = columns_[u];
    const float above = column.horizon - row;
    const float below_horizon = std::clamp(0.5F - above, 0.0F, 1.0F);
    const float in_woods = std::clamp(row - column.woods + 0.5F, 0.0F, 1.0F);
    const float in_hills = std::clamp(row - column.hills + 0.5F, 0.0F, 1.0F);
    LinearColour pixel = woods;
    if (in_woods < 1) {
      const auto height =
          static_cast<std::size_t>(std::clamp(above, 0.0F, static_cast<float>(sky_.size() - 1)));
      pixel = sky_[height] + column.glow * glow;
      pixel += in_hills * (hills - pixel);
    }
    if (in_woods > 0 && below_horizon < 1) {
      const double bearing = bearing_ - static_cast<double>(u);
      pixel += in_woods * (woods + leaf_contrast * leaves.at(bearing * 0.012, above * 0.012) - pixel);
    }
    pixels[u] = pixel + below_horizon * (fields - pixel);
  }
}

}  // namespace lanefuse
