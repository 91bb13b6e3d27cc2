// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/camera_trial.hpp"

#include <memory>
#include <vector>

#include "simulation/camera_body.hpp"
#include "simulation/camera_image_model.hpp"
#include "simulation/drive_road.hpp"
#include "simulation/image_truth.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_suite.hpp"
#include "simulation/traffic.hpp"

namespace lanefuse {
namespace {

/// One camera of the car, with what looks through it.
struct TrialCamera {
  CameraImageModel model;
  LaneCamera lane_camera;
  CameraModel lens;
  std::int64_t ticks = 1;  ///< of kTick from image to image

  TrialCamera(const CameraImageModel::Setup& setup, const SensorPreset& preset,
              const std::shared_ptr<BodyMotion>& body, const RenderConfig& render,
              const LaneCameraConfig& config)
      : model(setup, preset.camera_pose, body, render),
        lane_camera(setup.sensor, config),
        lens(*setup.sensor.camera),
        ticks(std::lround(1 / (setup.hz * to_seconds(kTick)))) {}

  /// Takes an image, if one is due, and hands what was seen in it to `judge`.
  template <class Judge>
  void look(const Scene& scene, std::int64_t tick, std::span<const TrackedObject> others, Judge judge) {
    if (tick % ticks != 0) return;
    std::vector<Measurement> measured;
    model.observe(scene, measured);
    const CameraMotion motion{scene.ego.speed, scene.ego.yaw_rate,
                              scene.ego.speed * to_seconds(kTick) * static_cast<double>(ticks)};
    for (const Measurement& measurement : measured) {
      const auto* image = std::get_if<CameraImage>(&measurement);
      if (!image) continue;
      const LaneCamera::Seen seen = lane_camera.process(*image, motion, others);
      judge(ImageTruth(scene, lens, model.true_mounting_of_last()), seen);
    }
  }
};

/// The car's object list, as the preset's fusion hands it over, without its latency.
std::vector<TrackedObject> look_around(ObjectListModel& model, const Scene& scene) {
  std::vector<Measurement> measured;
  model.observe(scene, measured);
  const auto* list = measured.empty() ? nullptr : std::get_if<ObjectList>(&measured.front());
  return list ? list->objects : std::vector<TrackedObject>();
}

}  // namespace

CameraTrialFigures& CameraTrialFigures::operator+=(const CameraTrialFigures& other) {
  images += other.images;
  refused += other.refused;
  markings += other.markings;
  serial += other.serial;
  high += other.high;
  return *this;
}

CameraTrialFigures run_trial(const CameraTrial& trial, const std::function<void(double)>& progress) {
  const SensorPreset preset = nominal_preset();
  const DriveRoad there = drive_road({}, trial.road, trial.km, preset.road, trial.seed);
  Traffic traffic(there.road, nominal_traffic(preset), there.start, trial.seed);
  const auto body = std::make_shared<BodyMotion>(trial.seed);
  RenderConfig render;
  render.conditions = trial.conditions;
  render.seed = trial.seed;
  TrialCamera serial(serial_camera_setup(preset), preset, body, render, trial.camera);
  TrialCamera high(high_resolution_camera_setup(preset), preset, body, render, trial.camera);
  ObjectListModel object_list(preset, trial.seed);
  const std::int64_t object_ticks = std::lround(1 / (object_list.hz() * to_seconds(kTick)));
  std::vector<TrackedObject> objects;
  CameraTrialFigures figures;
  for (std::int64_t tick = 0;; ++tick) {
    const Scene scene = traffic.scene(kSimulationStart + tick * kTick);
    const double done = (scene.ego.station - there.start) / (trial.km * 1000);
    if (done >= 1) break;
    progress(done);
    if (trial.objects && tick % object_ticks == 0) objects = look_around(object_list, scene);
    const bool settled = static_cast<double>(tick) * to_seconds(kTick) >= trial.settle_s;
    const auto count = [&figures](const TrialCamera& camera) {
      ++figures.images;
      if (camera.lane_camera.view().fault != ImageFault::none) ++figures.refused;
    };
    serial.look(scene, tick, objects, [&](const ImageTruth& truth, const LaneCamera::Seen& seen) {
      if (!settled) return;
      count(serial);
      judge_lane(scene, truth, seen.lane, figures.serial);
      judge_pose(truth, serial.lane_camera.view(), figures.serial);
      if (!trial.objects)
        judge_vehicles(truth.vehicles(), serial.lane_camera.view().vehicles, figures.serial);
    });
    high.look(scene, tick, objects, [&](const ImageTruth& truth, const LaneCamera::Seen& seen) {
      if (!settled) return;
      count(high);
      judge_pose(truth, high.lane_camera.view(), figures.high);
      if (!trial.objects) judge_vehicles(truth.vehicles(), high.lane_camera.view().vehicles, figures.high);
      const std::span<const Feature> features =
          seen.markings ? std::span<const Feature>(seen.markings->features) : std::span<const Feature>();
      judge_markings(scene, truth, high.lens.intrinsics(), high.lane_camera.view(), features,
                     figures.markings);
    });
    traffic.advance(to_seconds(kTick));
  }
  return figures;
}

}  // namespace lanefuse
