// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// Every measurement says when it was taken, when it arrived, and which sensor of the rig gave it.
struct Stamp {
  Time measured_at{};
  Time received_at{};
  std::uint32_t sensor_id = 0;
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

/// The car's own motion, as its buses report it; whatever of it this message carries.
struct VehicleMotion {
  Stamp stamp;
  std::optional<double> speed;     ///< [m/s] forward
  std::optional<double> yaw_rate;  ///< [rad/s], counter-clockwise, bias included
  /// [m/s] at front left, front right, rear left, rear right
  std::optional<std::array<double, 4>> wheel_speeds;
};

/// What a serial camera's lane detection hands over: the ego lane's markings, tracked [IROS16, sec. II-B].
/// Its clothoids follow the *inner* edges of the paint; the serial camera's source shifts them to the centre
/// line.
struct SerialLane {
  Stamp stamp;
  std::optional<ClothoidMeasurement> left;
  std::optional<ClothoidMeasurement> right;
  std::optional<double> marking_width;  ///< [m] of the paint on both sides, where a side does not say itself
};

/// Marking features of one high-resolution image, centre of the paint, in the vehicle frame [IROS16, sec.
/// II-B].
struct MarkingFeatures {
  Stamp stamp;
  std::vector<Feature> features;
  std::optional<SharedError> shared_error;
};

/// One radar reflection in the radar's own terms.
struct RadarDetection {
  double range = 0;       ///< [m] > 0
  double bearing = 0;     ///< [rad] from the radar's x axis, counter-clockwise
  double range_rate = 0;  ///< [m/s], positive when it moves away; not corrected for the ego motion
  /// Some radars track inside: the slot that this reflection was filed under, and whether the slot was just
  /// taken anew.
  std::optional<std::int32_t> address;
  bool new_track = false;
};

struct RadarScan {
  Stamp stamp;
  std::vector<RadarDetection> detections;
};

enum class MovementState : std::uint8_t { unknown = 0, stationary = 1, moving = 2, stopped = 3 };

/// A tracked vehicle, as an object fusion gives it: the middle of its rear in the vehicle frame.
struct TrackedObject {
  std::int64_t id = 0;
  double x = 0;        ///< [m] middle of the rear
  double y = 0;        ///< [m]
  double heading = 0;  ///< [rad] relative to the ego car
  double speed = 0;    ///< [m/s] over ground, along its heading
  /// of (x, y, heading)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double length = 4.5;  ///< [m]
  double width = 1.8;   ///< [m]
  MovementState movement = MovementState::unknown;
  double existence = 1;         ///< probability in [0, 1]
  bool seen_by_radar = false;   ///< verified by at least one radar measurement
  bool seen_by_camera = false;  ///< verified by at least one camera measurement
  // What only our own tracker says:
  std::optional<Time> last_radar = {};   ///< when a radar measured it last
  std::optional<Time> last_camera = {};  ///< when a camera measured it last
  bool changing_lane = false;            ///< on its way between two lanes: no witness of either
  bool witness = false;                  ///< bore witness of its lane in this cycle
  // The lines at its lane's edges, for a benchmark's oracle: kNoLine while it is between lanes.
  LineLabel left_label = kNoLabel;
  LineLabel right_label = kNoLabel;
};

struct ObjectList {
  Stamp stamp;
  std::vector<TrackedObject> objects;
};

enum class FixKind : std::uint8_t { unknown = 0, single = 1, rtk_float = 2, rtk_fixed = 3 };
const char* to_string(FixKind kind);

/// Where a GNSS receiver with inertial sensors says that its frame is on Earth (WGS 84). For surveying roads
/// and finding a place in a map; it is no input of what estimates lanes.
struct GnssInsFix {
  Stamp stamp;
  double latitude = 0;   ///< [rad] in [-pi/2, pi/2]
  double longitude = 0;  ///< [rad] in [-pi, pi]
  double height = 0;     ///< [m] above the ellipsoid
  double heading = 0;    ///< [rad] of the x axis, counter-clockwise from the east of this place
  Eigen::Matrix3d position_covariance = Eigen::Matrix3d::Identity();  ///< [m^2] of (east, north, up)
  double heading_sigma = 0.01;                                        ///< [rad]
  FixKind kind = FixKind::unknown;
};

/// One image as its camera sent it, still compressed.
struct CameraImage {
  Stamp stamp;
  std::string format;            ///< "jpeg", "png" or "webp": what the bytes claim to be
  std::vector<std::byte> bytes;  ///< judged only when they are decoded
};

/// A vehicle's box in an image: columns and rows in pixels of the raw (distorted) image, whose camera the rig
/// describes.
struct BoxDetection {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;      ///< where its wheels stand
  double confidence = 1;  ///< in [0, 1]
};

/// The vehicles that a camera found in one image.
struct CameraBoxes {
  Stamp stamp;
  std::vector<BoxDetection> boxes;
};

/// Anything that a drive's sensors gave. The order is kept: only append.
using Measurement = std::variant<VehicleMotion, SerialLane, MarkingFeatures, RadarScan, ObjectList,
                                 GnssInsFix, CameraImage, CameraBoxes>;

const Stamp& stamp_of(const Measurement& measurement);

/// Why a measurement cannot be believed at all (not finite, a covariance that is none, a range below zero),
/// or nothing. Parts that can be judged alone, a feature or an object, are judged by their sources instead.
std::optional<std::string> implausible(const Measurement& measurement);

/// Whether every number is finite and of a size that a car's sensors can see, the confidence in [0, 1], the
/// range above zero and the covariance symmetric and positive definite (a clothoid's: semi-definite).
bool is_plausible(const Feature& feature);
bool is_plausible(const ClothoidMeasurement& measurement);
bool is_plausible(const TrackedObject& object);
bool is_plausible(const RadarDetection& detection);
bool is_plausible(const BoxDetection& box);

}  // namespace lanefuse
