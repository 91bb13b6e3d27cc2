// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/random.hpp"
#include "simulation/ground_view.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// Marking features of every line on the road, frame by frame, untracked [IROS16, sec. II-B]: where there is
/// paint, it is not hidden by a vehicle, and the detector finds it. Errs by its pixels, by the paint's ragged
/// edges, by the camera's pose and the road's vertical curvature, by a lateral error that all features of a
/// frame share, and by features that are none, half of them on the guard rails, where they form lines. What
/// is wrong with places is wrong with directions: a camera that is turned sees a turned road.
///
/// It does not say solid or dashed, for one short bar does not show it. Each feature is labelled with the
/// line that it is of: kNoLine for what is no paint, and for ghosts.
class HighResolutionCameraModel final : public SensorModel {
 public:
  HighResolutionCameraModel(const SensorPreset& preset, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  HighResolutionCameraPreset preset_;
  double noise_;  ///< its errors are so many times as large as it states
  CameraPosePreset pose_;
  Random random_;
  GroundView view_;
  Wander shared_;  ///< [m] lateral at 100 m

  /// A short piece of paint, or what is taken for it.
  struct Bar {
    double station = 0;  ///< [m]
    double lateral = 0;  ///< [m]
    double turn = 0;     ///< [rad] against the road
    MarkingColour colour = MarkingColour::white;
    LineLabel label = kNoLine;  ///< whose paint it is
  };

  void observe_line(const Scene& scene, const LineOfSight& sight, int line, std::vector<Feature>& features);
  void observe_bar(const Scene& scene, const LineOfSight& sight, const Bar& place,
                   std::vector<Feature>& features);
  [[nodiscard]] std::optional<Eigen::Vector2d> see(const Eigen::Vector2d& point, double height,
                                                   const GroundView::PixelError& error) const;
  static Bar bar_of(const Road& road, int line, double station);
  Bar replace_by_outlier(const Scene& scene, double station);
  [[nodiscard]] double reach(const Scene& scene) const;
  [[nodiscard]] double detection(double x) const;
  [[nodiscard]] Eigen::Matrix3d covariance(const Feature& feature) const;
};

}  // namespace lanefuse
