// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "camera/image.hpp"
#include "camera/neighbour_markings.hpp"
#include "core/feature.hpp"
#include "core/time.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

enum class LaneTrackStatus : std::uint8_t {
  lost = 0,       ///< no lane in sight; it is looked for anew in every image
  acquiring = 1,  ///< a lane was found, but has not proved itself yet: nothing is handed over
  tracking = 2,
};
const char* to_string(LaneTrackStatus status);

/// The ego lane in one image.
struct LaneTrack {
  Time measured_at{};
  LaneTrackStatus status = LaneTrackStatus::lost;
  /// The inner edges of the markings, in the vehicle frame; only while tracking, and only sides that were
  /// seen. Their covariance counts in the uncertainty of the pitch and of the camera's pose.
  std::optional<ClothoidMeasurement> left;
  std::optional<ClothoidMeasurement> right;
  std::optional<double> left_marking_width;   ///< [m] of the paint
  std::optional<double> right_marking_width;  ///< [m]
  double lateral_offset = 0;                  ///< [m] of the lane's middle, positive to the left
  double width = 0;                           ///< [m] between the inner edges
  double width_sigma = 0;                     ///< [m]
  double heading = 0;                         ///< [rad] of the lane at x = 0
  double curvature = 0;                       ///< [1/m]
  double pitch = 0;                           ///< [rad] of this image, added to that of the pose handed in
  double pitch_sigma = 0;                     ///< [rad]
  double vertical_curvature = 0;              ///< [1/m] positive where the road rises
  double vertical_curvature_sigma = 0;        ///< [1/m]
  double range = 0;                           ///< [m] up to where a marking was seen without a larger gap
  double quality = 0;                         ///< in [0, 1]: how much of the expected paint was seen
  bool lane_changed = false;                  ///< the car crossed a marking: this is another lane than before
  std::optional<NeighbourWidth> left_neighbour;
  std::optional<NeighbourWidth> right_neighbour;
  std::vector<SearchWindow> windows;
};

struct LaneTrackerConfig {
  double nearest = 5;          ///< [m] of the first search window
  double farthest = 95;        ///< [m] of the last one
  double spacing = 1.045;      ///< ratio of the distances of neighbouring windows; at least one row apart
  double gate = 3.2;           ///< [sigma] half width of a window, and beyond which an edge is an outlier
  double pixel_noise = 0.6;    ///< [px] of an edge
  double paint_noise = 0.015;  ///< [m] how straight paint is
  double marking_width_min = 0.08;         ///< [m]
  double marking_width_max = 0.35;         ///< [m]
  double lane_width_min = 2.5;             ///< [m]
  double lane_width_max = 4.5;             ///< [m]
  double contrast_min = 7;                 ///< [grey levels] of paint against the road on both of its sides
  double pitch_sigma = 0.010;              ///< [rad] of the body's pitch around its mean
  double pitch_tau = 0.4;                  ///< [s]
  double vertical_curvature_sigma = 4e-5;  ///< [1/m]
  double vertical_curvature_length = 100;  ///< [m] over which it changes
};

/// The serial camera's lane tracker [IROS16, sec. II-B; Meis 2010]: an iterated extended Kalman filter over
/// the ego lane's offset, width, heading, curvature and its rate, the pitch of the image and the vertical
/// curvature of the road, that looks for the inner edges of the two markings in windows as wide as its own
/// uncertainty, finds the lane from scratch, and follows the car into another lane.
///
/// Same input, same output; no allocation once warm.
class LaneTracker {
 public:
  explicit LaneTracker(const CameraIntrinsics& intrinsics, const LaneTrackerConfig& config = {});
  ~LaneTracker();
  LaneTracker(LaneTracker&&) noexcept;
  LaneTracker& operator=(LaneTracker&&) noexcept;

  struct Input {
    ImageView image;  ///< of the size of the intrinsics
    Time time{};
    CameraPose pose;                       ///< best guess; the pitch of this very image is not in it
    double speed = 0;                      ///< [m/s]
    double yaw_rate = 0;                   ///< [rad/s]
    std::span<const VehicleBox> vehicles;  ///< what hides the road
  };
  /// Images come in order of time. The result stays valid until the next call.
  const LaneTrack& track(const Input& input);
  [[nodiscard]] const LaneTrack& last() const;
  void reset();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace lanefuse
