// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/ground_view.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/odometry_model.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"
#include "simulation/serial_lane_tracker.hpp"

namespace lanefuse {

/// A serial camera's lane detection [IROS16, sec. II-B]: points on the inner edges of the ego lane's two
/// markings, tracked inside the camera, which hands over two clothoids. How far it sees changes from frame to
/// frame, and now and then a frame brings nothing. A marking of which it sees nothing for a while is left
/// out. It does not measure how wide the paint is. Its clothoids are labelled with the lines beside the car.
class SerialCameraModel final : public SensorModel {
 public:
  SerialCameraModel(const SensorPreset& preset, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  SerialCameraPreset preset_;
  CameraPosePreset pose_;
  Random random_;
  OdometryModel odometry_;  ///< the buses' scale and bias, heard by the camera with white noise of its own
  GroundView view_;
  SerialLaneTracker tracker_;
  int lane_ = -1;           ///< that the last frame was taken in
  double left_unseen_ = 0;  ///< [s] since it saw a point of the left marking
  double right_unseen_ = 0;

  void move_tracker(const Scene& scene);
  double draw_range();
  [[nodiscard]] double spacing(double x) const;
  std::vector<SerialLaneTracker::Point> detect(const Scene& scene, double range);
  void detect_edge(const Scene& scene, const LineOfSight& sight, Side side, double range,
                   std::vector<SerialLaneTracker::Point>& points);
  [[nodiscard]] ClothoidMeasurement hand_over(const Scene& scene, Side side, double range) const;
};

}  // namespace lanefuse
