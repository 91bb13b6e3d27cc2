// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/clothoid.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// Where a feature comes from. The order is part of the recording format: only append.
enum class Source : std::uint8_t {
  serial_camera = 0,           ///< SMC: the ego lane's markings, tracked
  high_resolution_camera = 1,  ///< HRC: marking features, untracked
  objects = 2,                 ///< other vehicles as witnesses of their lane
  ego_path = 3,                ///< the car's own motion as a witness of its lane
  vehicle_to_vehicle = 4,      ///< paths that other cars report
  user = 5,                    ///< anything that a user's own source brings
};
inline constexpr int kSourceCount = 6;
const char* to_string(Source source);

/// Which boundary of its lane a feature witnesses; `none` where the sensor cannot know (a painted bar).
enum class Side : std::uint8_t { none = 0, left = 1, right = 2 };

enum class MarkingType : std::uint8_t { unknown = 0, solid = 1, dashed = 2, road_edge = 3, guard_rail = 4 };
enum class MarkingColour : std::uint8_t { unknown = 0, white = 1, yellow = 2 };
const char* to_string(MarkingType type);
const char* to_string(MarkingColour colour);

/// What is known about the paint itself.
struct MarkingEvidence {
  MarkingType type = MarkingType::unknown;
  MarkingColour colour = MarkingColour::unknown;
  friend bool operator==(const MarkingEvidence&, const MarkingEvidence&) = default;
};

inline constexpr std::int64_t kNoTrack = -1;

/// Which line of the road a measurement truly is of, where a simulation says so. Never recorded; no estimator
/// looks at it but a benchmark's oracle, which shows what perfect association would give.
using LineLabel = std::int32_t;
inline constexpr LineLabel kNoLabel = -1;  ///< nobody says
inline constexpr LineLabel kNoLine = -2;   ///< of no line: an outlier

/// The generic lane feature [IROS16, eq. 1]: f = [x, y, theta, c, Sigma], in the vehicle frame at its set's
/// stamp.
///
/// `track_id` and `side` let the fusion tie features of one witness together (width and smoothing edges)
/// without knowing any sensor.
struct Feature {
  double x = 0;           ///< [m] forward
  double y = 0;           ///< [m] left
  double heading = 0;     ///< theta [rad]
  double confidence = 0;  ///< c in [0, 1]
  /// Sigma of (x, y, theta) in the vehicle frame, symmetric positive definite [m^2, m rad, rad^2].
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  std::int64_t track_id = kNoTrack;  ///< the tracked thing that bears witness, or kNoTrack
  Source source = Source::user;
  Side side = Side::none;
  MarkingEvidence marking;
  bool changing_lane = false;  ///< its witness is between two lanes: nothing is smooth along its trail
  LineLabel label = kNoLabel;
};

/// Which boundary of the ego lane a serial camera's clothoid describes, with what the camera knows of it.
struct ClothoidMeasurement {
  Clothoid clothoid;  ///< the marking's centre line (in a raw SerialLane: its inner edge)
  /// Covariance of (y0, theta0, c0, c1), symmetric positive semi-definite.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  double range_begin = 0;  ///< [m] valid from here
  double range_end = 0;    ///< [m] valid to here
  double confidence = 1;   ///< in [0, 1]
  Side side = Side::none;
  MarkingEvidence marking;
  std::optional<double> marking_width = {};  ///< [m] of the paint, where the camera measured it
  LineLabel label = kNoLabel;
};

/// An error that all features of one frame share: they lean together, and are not independent.
struct SharedError {
  enum class Kind : std::uint8_t { pitch = 0, yaw = 1, lateral_growing_with_range = 2 };
  Kind kind = Kind::pitch;
  double sigma = 0;  ///< [rad] for pitch and yaw; [m] at 100 m for the last
};

/// The distance between a witness's left and right feature, as far as it is known [IROS16, sec. II-E4].
struct LaneWidth {
  double mean = 3.5;                 ///< w [m]; 3.5 m is the usual width on German motorways
  double standard_deviation = 0.25;  ///< [m]
};

enum class SourceStatus : std::uint8_t { ok = 0, degraded = 1, unavailable = 2 };

/// One source's word at one moment: F_i of the paper's Fig. 1.
struct FeatureSet {
  Source source = Source::user;
  std::uint32_t sensor_id = 0;
  Time measured_at{};  ///< the vehicle frame of this instant is the frame of everything below
  SourceStatus status = SourceStatus::ok;
  std::vector<Feature> features;
  /// A tracked lane hands over its clothoids whole; each estimator takes them as suits it.
  std::vector<ClothoidMeasurement> clothoids;
  /// Only for witnesses with a left and a right feature.
  std::optional<LaneWidth> lane_width;
  std::optional<SharedError> shared_error;
};

}  // namespace lanefuse
