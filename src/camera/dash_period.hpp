// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "camera/camera_model.hpp"
#include "camera/image.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct DashPeriodConfig {
  double expected = 12;    ///< [m] from one dash's begin to the next one's
  double tolerance = 0.2;  ///< the period is looked for within expected (1 +- tolerance)
  double ahead = 7;        ///< [m] ahead of the camera, where the road is looked at
  double half_width = 8;   ///< [m] to either side
};

struct DashPeriod {
  double period = 0;  ///< [m] of the way as it was handed in
  double sigma = 0;   ///< [m]
  double drift = 0;   ///< how much longer the second half's period is than the first half's, as a share
};

/// Measures at what way the dashes of lane markings come again: they are painted at known distances, so that
/// the period in driven metres tells how wrong the measure of the way is.
class DashPeriodMeter {
 public:
  DashPeriodMeter(const CameraIntrinsics& intrinsics, const DashPeriodConfig& config);

  /// One image and the way [m] driven until then; the way must not fall.
  void add(const ImageView& image, const CameraPose& pose, double way);

  /// The period over all images; nothing where no period stands out.
  [[nodiscard]] std::optional<DashPeriod> measure() const;

 private:
  CameraModel camera_;
  DashPeriodConfig config_;
  int columns_;                        ///< of lateral places
  std::vector<std::uint8_t> paint_;    ///< columns_ a step of the way, 1: a narrow bright bar
  std::optional<std::int64_t> first_;  ///< steps of the way where paint_ begins

  struct Peak {
    double period = 0;
    double coherence = 0;  ///< the share of the columns' variance that has this period; of perfect dashes .27
  };
  [[nodiscard]] std::optional<Peak> peak(std::size_t begin, std::size_t end) const;
};

}  // namespace lanefuse
