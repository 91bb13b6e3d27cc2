// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "camera/camera_model.hpp"
#include "camera/image_health.hpp"
#include "camera/lane_tracker.hpp"
#include "camera/marking_extractor.hpp"
#include "camera/online_calibration.hpp"
#include "camera/vehicle_detector.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

struct LaneCameraConfig {
  ImageHealthConfig health;
  LaneTrackerConfig tracker;
  MarkingExtractorConfig markings;
  VehicleDetectorConfig vehicles;
  OnlineCalibrationConfig calibration;
  bool detect_vehicles = true;      ///< in the image itself, to keep markings off them
  double body_pitch_sigma = 0.005;  ///< [rad] of an image whose lane is not tracked
};

/// How the car has moved, as an image of it needs to know.
struct CameraMotion {
  double speed = 0;           ///< [m/s] when the image was taken
  double yaw_rate = 0;        ///< [rad/s]
  double distance_moved = 0;  ///< [m] since the image before
};

/// A camera, from its images to what smart cameras send: the ego lane tracked as clothoids (serial camera)
/// and marking features of all lanes (high-resolution camera) [IROS16, sec. II-B]. A camera of the kind
/// `camera` gives both. Learns how it stands over the road while the car drives.
///
/// Same images, same results. Reads no clock and no file.
class LaneCamera {
 public:
  /// `sensor` must have a lens; throws a configuration Error where that is none.
  LaneCamera(const SensorDescription& sensor, const LaneCameraConfig& config = {});

  struct Seen {
    std::optional<SerialLane> lane;
    std::optional<MarkingFeatures> markings;
    CameraBoxes boxes;  ///< the vehicles found in the image itself
  };
  /// Images come in order of measuring. `others` are vehicles known from elsewhere, where the vehicle frame
  /// is that of the image: they hide the road, too. Of an image that cannot be believed nothing is seen;
  /// view() says why.
  Seen process(const CameraImage& image, const CameraMotion& motion,
               std::span<const TrackedObject> others = {});

  /// The same for an image that has been decoded and judged sound already.
  Seen process(const ImageView& image, const Stamp& stamp, const CameraMotion& motion,
               std::span<const TrackedObject> others = {});

  /// The last image in pixels.
  [[nodiscard]] const CameraView& view() const { return view_; }

  void reset();

 private:
  SensorDescription sensor_;
  LaneCameraConfig config_;
  CameraModel model_;
  ImageHealth health_;
  VehicleDetector vehicles_;
  LaneTracker tracker_;
  MarkingExtractor markings_;
  OnlineCalibration calibration_;
  CameraView view_;
  std::optional<Time> last_image_;
  double last_pitch_ = 0;  ///< [rad] of the last image's, relative to the calibration's

  [[nodiscard]] CameraPose pose_with(double pitch) const;
  CameraBoxes find_vehicles(const ImageView& image, const Stamp& stamp, const CameraMotion& motion,
                            double seconds);
  void hide_others(std::span<const TrackedObject> others);
  void believe(const LaneTrack& track);
  [[nodiscard]] SerialLane serial_lane(const LaneTrack& track, const Stamp& stamp) const;
  [[nodiscard]] MarkingFeatures marking_features(const ImageView& image, const Stamp& stamp,
                                                 const CameraMotion& motion);
};

}  // namespace lanefuse
