// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_row.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pose2.hpp"
#include "simulation/bridges.hpp"
#include "simulation/image_air.hpp"
#include "simulation/roadside.hpp"
#include "simulation/vehicle_faces.hpp"

namespace lanefuse {
namespace {

constexpr int kSegment = GroundRays::kSegment;
constexpr double kBehind = 25;  ///< [m]

/// The air is no clearer than the scene says; where it is less clear than the conditions have it, it is fog,
/// and hides the sky.
ImageLight seen_through(ImageLight light, double visibility) {
  if (visibility >= light.visibility) return light;
  light.visibility = std::max(visibility, 1.0);
  light.ambient += 0.6F * light.sun;
  light.sun = grey(0);
  light.sky = light.horizon;
  return light;
}

double distance_of(const GroundHit& hit) { return std::hypot(hit.x, hit.y); }

bool in_sight(const SceneVehicle& vehicle, const Scene& scene) {
  return std::abs(vehicle.station - scene.ego.station) < GroundRays::kGroundEnd;
}

/// Shadows and mirror images.
std::vector<Face> faces_on_road(const ImageScene::View& view, const ImageLight& light) {
  ImageFaces faces(view.camera, view.mounting, light);
  for (const SceneVehicle& vehicle : view.scene.vehicles) {
    if (!in_sight(vehicle, view.scene)) continue;
    add_vehicle_shadow(vehicle, view.scene, faces);
    if (light.mirror > 0) add_mirrored_vehicle(vehicle, view.scene, faces);
  }
  return std::move(faces).sorted();
}

std::vector<Face> upright_faces(const ImageScene::View& view, const RoadAhead& road, const ImageLight& light,
                                std::uint64_t seed) {
  ImageFaces faces(view.camera, view.mounting, light);
  for (const SceneVehicle& vehicle : view.scene.vehicles) {
    if (in_sight(vehicle, view.scene)) add_vehicle(vehicle, view.scene, faces);
  }
  add_guard_rails(view.scene, road, faces);
  add_trees(view.scene, road, seed, faces);
  add_bridges(view.scene, road, seed, faces);
  return std::move(faces).sorted();
}

}  // namespace

ImageScene::ImageScene(const View& view, const RenderConfig& config, const ImageLight& light,
                       const SurfaceTextures& textures)
    : time_(view.scene.time),
      ends_(&view.ends),
      width_(view.camera.intrinsics().width),
      light_(seen_through(light, view.scene.visibility)),
      sun_bearing_(light.sun_azimuth - view.scene.ego.world_from_vehicle.heading),
      road_(view.scene, kBehind, GroundRays::kGroundEnd + 60),
      rays_(view.camera, view.mounting, road_),
      surface_(view.scene, road_, textures, light.asphalt, config.texture),
      paint_(view.scene, road_, textures, {light.paint, config.wear, config.texture}),
      shade_(view.scene, textures, light_, config.seed),
      backdrop_(rays_, view.camera.intrinsics(), light_, textures.wear,
                view.scene.ego.world_from_vehicle.heading),
      on_road_(faces_on_road(view, light_), view.camera.intrinsics().height),
      faces_(upright_faces(view, road_, light_, config.seed), view.camera.intrinsics().height) {}

ImageRowPainter::ImageRowPainter(const ImageScene& scene)
    : scene_(&scene), coverage_(scene.width_), albedo_(static_cast<std::size_t>(scene.width_ + kSegment)) {}

void ImageRowPainter::cast(int v) {
  if (near_row_ == v - 1) {
    far_.swap(near_);
  } else {
    scene_->rays_.cast_upper_edge(*scene_->ends_, v, far_);
  }
  scene_->rays_.cast_upper_edge(*scene_->ends_, v + 1, near_);
  near_row_ = v;
}

/// Share of the sky's light that the road throws to the camera: more at a grazing view, and most towards a
/// sun that shines.
float ImageRowPainter::mirrored(const GroundHit& hit) const {
  const ImageLight& light = scene_->light_;
  if (light.mirror <= 0) return 0;
  const double grazing = std::exp(-18.0 / std::max(distance_of(hit), 1.0));
  const double from_sun = wrap_angle(scene_->sun_bearing_ - std::atan2(hit.y, hit.x));
  const bool sunny = light.sun.head<3>().maxCoeff() > 0;
  const double towards_sun = sunny ? 2 * std::exp(-from_sun * from_sun / 0.02) : 0;
  return std::min(1.0F, light.mirror * static_cast<float>(grazing * (1 + towards_sun)));
}

/// Light on the road, what it mirrors, and the air before it: exact at the segment's ends.
void ImageRowPainter::light_segment(int node, const LinearColour* albedo, LinearColour* pixels) const {
  const ImageLight& light = scene_->light_;
  struct End {
    LinearColour factor;
    LinearColour extra;
  };
  const auto end_at = [&](std::size_t i) {
    const GroundHit& hit = near_[i];
    const double distance = distance_of(hit);
    const float kept = air_transmission(distance, light);
    const float sky = mirrored(hit);
    return End{light_on_road(hit.x, hit.y, light) * (kept * (1 - 0.6F * sky)),
               light.horizon * (kept * 0.55F * sky + 1 - kept)};
  };
  const End left = end_at(static_cast<std::size_t>(node));
  const End right = end_at(static_cast<std::size_t>(node) + 1);
  const int count = std::min(kSegment, scene_->width_ - node * kSegment);
  const LinearColour factor_step = (right.factor - left.factor) / static_cast<float>(kSegment);
  const LinearColour extra_step = (right.extra - left.extra) / static_cast<float>(kSegment);
  LinearColour factor = left.factor;
  LinearColour extra = left.extra;
  for (int i = 0; i < count; ++i) {
    pixels[i] = albedo[i] * factor + extra;
    factor += factor_step;
    extra += extra_step;
  }
}

Footprint ImageRowPainter::footprint(std::size_t node) const {
  return {std::abs(far_[node].way - near_[node].way),
          std::abs(place(node + 1).lateral - place(node).lateral) / kSegment};
}

RoadPlace ImageRowPainter::place(std::size_t node) const {
  return {(far_[node].way + near_[node].way) / 2, (far_[node].lateral + near_[node].lateral) / 2};
}

void ImageRowPainter::paint_ground(LinearColour* pixels) {
  const auto shows_ground = [this](std::size_t i) { return near_[i].ground && near_[i + 1].ground; };
  for (std::size_t i = 0; i + 1 < near_.size(); ++i) {
    if (!shows_ground(i)) continue;
    scene_->surface_.shade(place(i), place(i + 1), footprint(i), kSegment, &albedo_[i * kSegment]);
  }
  scene_->paint_.lay({&far_, &near_}, coverage_, albedo_.data());
  for (std::size_t i = 0; i + 1 < near_.size(); ++i) {
    if (!shows_ground(i)) continue;
    LinearColour* const albedo = &albedo_[i * kSegment];
    scene_->shade_.lay(place(i), place(i + 1), footprint(i), kSegment, albedo);
    light_segment(static_cast<int>(i), albedo, pixels + i * kSegment);
  }
}

void ImageRowPainter::paint(int v, LinearColour* pixels) {
  cast(v);
  const auto is_ground = [](const GroundHit& hit) { return hit.ground; };
  if (!std::all_of(near_.begin(), near_.end(), is_ground)) scene_->backdrop_.draw_row(v, pixels);
  if (std::any_of(near_.begin(), near_.end(), is_ground)) {
    paint_ground(pixels);
    scene_->on_road_.draw_row(v, coverage_, pixels);
  }
  scene_->faces_.draw_row(v, coverage_, pixels);
}

}  // namespace lanefuse
