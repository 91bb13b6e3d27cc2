// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_row.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

ImageScene::ImageScene(const View& view, const RenderConfig& config, const ImageLight& light,
                       const SurfaceTextures& textures)
    : time_(view.scene.time),
      width_(view.camera.intrinsics().width),
      light_(seen_through(light, view.scene.visibility)),
      road_(view.scene, kBehind, GroundRays::kGroundEnd + 60),
      rays_(view.camera, view.mounting, road_),
      surface_(view.scene, road_, textures, light.asphalt, config.texture),
      paint_(view.scene, road_, textures, {light.paint, config.wear, config.texture}),
      backdrop_(rays_, view.camera.intrinsics(), light_, textures.wear,
                view.scene.ego.world_from_vehicle.heading) {
  ImageFaces shadows(view.camera, view.mounting, light_);
  ImageFaces faces(view.camera, view.mounting, light_);
  for (const SceneVehicle& vehicle : view.scene.vehicles) {
    if (std::abs(vehicle.station - view.scene.ego.station) > GroundRays::kGroundEnd) continue;
    add_vehicle_shadow(vehicle, view.scene, shadows);
    add_vehicle(vehicle, view.scene, faces);
  }
  add_guard_rails(view.scene, road_, faces);
  add_trees(view.scene, road_, config.seed, faces);
  shadows_ = std::move(shadows).sorted();
  faces_ = std::move(faces).sorted();
}

ImageRowPainter::ImageRowPainter(const ImageScene& scene)
    : scene_(&scene), coverage_(scene.width_), albedo_(static_cast<std::size_t>(scene.width_ + kSegment)) {}

void ImageRowPainter::cast(int v) {
  if (near_row_ == v - 1) {
    far_.swap(near_);
  } else {
    scene_->rays_.cast(v - 0.5, far_);
  }
  scene_->rays_.cast(v + 0.5, near_);
  near_row_ = v;
}

/// Light on the road, what it mirrors, and the air before it: exact at the segment's ends.
void ImageRowPainter::light_segment(int node, const Colour* albedo, Colour* pixels) const {
  const ImageLight& light = scene_->light_;
  struct End {
    Colour factor;
    Colour extra;
  };
  const auto end_at = [&](std::size_t i) {
    const GroundHit& hit = near_[i];
    const double distance = distance_of(hit);
    const float kept = air_transmission(distance, light);
    const auto grazing = static_cast<float>(std::exp(-18.0 / std::max(distance, 1.0)));
    const float mirrored = light.mirror * grazing;
    return End{light_on_road(hit.x, hit.y, light) * (kept * (1 - 0.6F * mirrored)),
               light.horizon * (kept * 0.55F * mirrored + 1 - kept)};
  };
  const End left = end_at(static_cast<std::size_t>(node));
  const End right = end_at(static_cast<std::size_t>(node) + 1);
  const int count = std::min(kSegment, scene_->width_ - node * kSegment);
  const Colour factor_step = (right.factor - left.factor) / static_cast<float>(kSegment);
  const Colour extra_step = (right.extra - left.extra) / static_cast<float>(kSegment);
  Colour factor = left.factor;
  Colour extra = left.extra;
  for (int i = 0; i < count; ++i) {
    pixels[i] = albedo[i] * factor + extra;
    factor += factor_step;
    extra += extra_step;
  }
}

void ImageRowPainter::paint_ground(Colour* pixels) {
  const auto place = [this](std::size_t i) {
    return RoadPlace{(far_[i].way + near_[i].way) / 2, (far_[i].lateral + near_[i].lateral) / 2};
  };
  const auto nodes = static_cast<int>(near_.size());
  for (int node = 0; node + 1 < nodes; ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (!near_[i].ground || !near_[i + 1].ground) continue;
    const RoadPlace from = place(i);
    const RoadPlace to = place(i + 1);
    const Footprint footprint{std::abs(far_[i].way - near_[i].way),
                              std::abs(to.lateral - from.lateral) / kSegment};
    scene_->surface_.shade(from, to, footprint, kSegment, &albedo_[i * kSegment]);
  }
  scene_->paint_.lay({&far_, &near_}, coverage_, albedo_.data());
  for (int node = 0; node + 1 < nodes; ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (!near_[i].ground || !near_[i + 1].ground) continue;
    light_segment(node, &albedo_[i * kSegment], pixels + i * kSegment);
  }
}

void ImageRowPainter::paint(int v, Colour* pixels) {
  cast(v);
  const bool all_ground =
      std::all_of(near_.begin(), near_.end(), [](const GroundHit& hit) { return hit.ground; });
  const bool any_ground =
      std::any_of(near_.begin(), near_.end(), [](const GroundHit& hit) { return hit.ground; });
  if (!all_ground) scene_->backdrop_.draw_row(v, pixels);
  if (any_ground) {
    paint_ground(pixels);
    for (const Face& shadow : scene_->shadows_) draw_row(shadow, v, coverage_, pixels);
  }
  for (const Face& face : scene_->faces_) draw_row(face, v, coverage_, pixels);
}

}  // namespace lanefuse
