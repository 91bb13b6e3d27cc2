// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// A plain video and what is known of its camera and its car's motion.
struct VideoImport {
  std::filesystem::path video;
  std::filesystem::path camera;                 ///< its camera.yaml
  std::optional<double> speed;                  ///< [m/s] throughout
  std::optional<std::filesystem::path> motion;  ///< a table, see MotionTable
  /// [m] between the begins of two dashes as painted, where the road's markings are dashed so regularly that
  /// the scale of the speed can be taken from them, and the camera's height, which is the same scale.
  std::optional<double> dash_period;
  int jpeg_quality = 95;  ///< in [1, 100]
};

/// The ids of the sensors in an imported video.
inline constexpr std::uint32_t kVideoOdometry = 1;
inline constexpr std::uint32_t kVideoCamera = 2;

/// How the car moved, frame by frame, and how well that is known.
struct VideoMotion {
  DriveInfo info;
  Rig rig;
  double frames_per_second = 0;
  std::int64_t frames_announced = 0;           ///< by the container
  std::vector<VehicleMotion> motions;          ///< one a frame that could be decoded
  double speed_mean = 0;                       ///< [m/s]
  double speed_min = 0;                        ///< [m/s]
  double speed_max = 0;                        ///< [m/s]
  std::string scale_source;                    ///< "given", "dash period" or "camera height"
  double scale = 1;                            ///< of the speeds, over those that the camera's height gives
  double scale_sigma = 0;                      ///< relative error of all speeds together
  std::optional<double> measured_dash_period;  ///< [m] by the speeds as the camera's height gives them
  std::optional<double> scale_drift;           ///< of the second half over the first, where dashes tell
  double seen = 0;                             ///< share of frames whose road showed the motion
  std::vector<std::string> notes;              ///< what was assumed, for the user to read
};

/// Decodes the video once for its motion: as given, or from the road plane. Throws Error naming the file
/// where the video cannot be opened, holds no frame or frames of another size than the camera's, or where
/// dashes of the given period cannot be found.
VideoMotion survey_video(const VideoImport& import);

/// Decodes the video once more and hands over its motions and images in order of time.
void write_video(const VideoImport& import, const VideoMotion& motion,
                 const std::function<void(const Measurement&)>& write);

}  // namespace lanefuse
