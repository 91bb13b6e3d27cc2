// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/clothoid.hpp"
#include "core/feature.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// A boundary sampled at one distance, with the lateral uncertainty that its clothoid carries there.
struct BoundaryPoint {
  double x = 0;
  double y = 0;
  double sigma = 0;  ///< one standard deviation across [m]
  /// The protection level: the error across stays inside this [m], but for a rate that docs/road.md states. 0
  /// where the estimator vouches for none.
  double protection = 0;
};

inline constexpr double kPointSpacing = 2.0;  ///< [m] between the sampled points

/// An estimated edge of a lane: the centre line of its marking, in the vehicle frame at the estimate's time.
struct Boundary {
  std::uint64_t id = 0;  ///< stays through the ego car's lane changes
  Clothoid clothoid;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (y0, theta0, c0, c1)
  double range_begin = 0;                                ///< [m] the estimate speaks from here
  double range_end = 0;                                  ///< [m] to here
  double confidence = 0;                                 ///< in [0, 1]
  MarkingEvidence marking;
  std::array<std::uint16_t, kSourceCount> support{};  ///< fused features behind it in this cycle, a source
  /// Every kPointSpacing from range_begin to range_end: what the boundary *is*. The clothoid says the same as
  /// well as one cubic can; in sharp bends only these points follow the road.
  std::vector<BoundaryPoint> points;
};

/// Where the boundary is at x [m]: between its points, else (beyond their ends, or without any) on its
/// clothoid.
double lateral_at(const Boundary& boundary, double x);
/// The lateral sigma there: between the points, else the clothoid's.
double sigma_at(const Boundary& boundary, double x);
/// The protection level there, between the points. 0, nothing vouched for, beyond them and beside a point
/// that has none.
double protection_at(const Boundary& boundary, double x);

/// A lane's middle at one distance, halfway between its boundaries along y.
struct LanePoint {
  double x = 0;
  double y = 0;
  double heading = 0;      ///< [rad]
  double curvature = 0;    ///< [1/m]
  double width = 0;        ///< [m] across, between the centres of the markings
  double sigma = 0;        ///< of the middle, across [m]
  double width_sigma = 0;  ///< [m]
};

inline constexpr double kLanePointSpacing = 10.0;  ///< [m] between the points of a lane's middle

/// A lane lies between two boundaries. Its neighbours are named by lane id.
struct Lane {
  std::uint64_t id = 0;
  std::uint64_t left_boundary = 0;
  std::uint64_t right_boundary = 0;
  std::optional<std::uint64_t> left_lane;
  std::optional<std::uint64_t> right_lane;
  double range_begin = 0;         ///< [m] both of its boundaries speak from here
  double range_end = 0;           ///< [m] to here
  double confidence = 0;          ///< the lesser of its boundaries' [0, 1]
  double availability = 0;        ///< share of the last 10 s in which it was there to 60 m
  std::vector<LanePoint> centre;  ///< every kLanePointSpacing from range_begin to range_end
};

enum class EstimateStatus : std::uint8_t { ok = 0, degraded = 1, invalid = 2 };
enum class StatusReason : std::uint8_t {
  none = 0,
  warming_up = 1,           ///< too few features seen so far
  no_motion = 2,            ///< no odometry for this instant: nothing can be moved along
  no_ego_lane = 3,          ///< lanes, but none that the car is in
  source_silent = 4,        ///< a source that was there is not
  solver_failed = 5,        ///< the graph could not be solved; the window was kept as it was
  no_road_course = 6,       ///< too few features for a base clothoid; the lanes are predicted
  image_fault = 7,          ///< a camera's images cannot be believed: black, cut off, frozen
  camera_bumped = 8,        ///< a camera has moved in its mounting and is being learned anew
  sensor_inconsistent = 9,  ///< an object sensor contradicts itself or the others and is left out
};
const char* to_string(EstimateStatus status);
const char* to_string(StatusReason reason);

/// What became of the inputs: used + rejected + dropped is all that came in.
struct InputAccounting {
  std::uint64_t used = 0;
  std::uint64_t rejected = 0;  ///< not believed: impossible values
  std::uint64_t dropped = 0;   ///< too late, twice, or of no source that this run uses

  InputAccounting& operator+=(const InputAccounting& other) {
    used += other.used;
    rejected += other.rejected;
    dropped += other.dropped;
    return *this;
  }
  friend bool operator==(const InputAccounting&, const InputAccounting&) = default;
};

/// What a cycle says about the road: every boundary it sees, from left to right, and the lanes between them.
struct LaneEstimate {
  Time time{};
  EstimateStatus status = EstimateStatus::invalid;
  StatusReason reason = StatusReason::warming_up;
  double speed = 0;                  ///< [m/s] the motion that the cycle assumed
  double yaw_rate = 0;               ///< [rad/s]
  std::vector<Boundary> boundaries;  ///< sorted by decreasing lateral offset
  std::vector<Lane> lanes;           ///< from left to right
  std::array<SourceStatus, kSourceCount> sources{};
  InputAccounting inputs;       ///< of this cycle
  std::uint32_t witnesses = 0;  ///< vehicles ahead that bore witness of their lanes in this cycle
};

/// The lane that the origin of the vehicle frame is in, or null. Derived, never stored: lanes keep their
/// identity while the car changes between them.
const Lane* ego_lane(const LaneEstimate& estimate);
const Lane* find_lane(const LaneEstimate& estimate, std::uint64_t id);
const Boundary* find_boundary(const LaneEstimate& estimate, std::uint64_t id);

/// Points every kPointSpacing on the boundary's clothoid over its valid range, with the clothoid's lateral
/// sigma.
void sample_points(Boundary& boundary);

/// Inside views of a cycle, for pictures and for those who debug: never needed to use the lanes.
struct FusedFeature {
  Feature feature;
  bool in_base_fit = false;    ///< took part in the road course
  bool outlier = false;        ///< was cut from the road course as an outlier
  std::uint64_t boundary = 0;  ///< the boundary it was grouped to, 0 for none
};

/// One switchable smoothing edge [IROS16, sec. II-E4], between two features of one track's side.
struct SwitchState {
  std::int64_t track_id = kNoTrack;
  Side side = Side::none;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< vehicle frame
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double value = 1;  ///< s in [0, 1]; below one half the edge is off: this vehicle changed lane
};

struct GraphSize {
  std::uint32_t poses = 0;
  std::uint32_t features = 0;
  std::uint32_t edges = 0;
};

/// Which stages of a cycle are timed, in the order in which they run.
enum class Stage : std::uint8_t { sources = 0, association = 1, solve = 2, lane_model = 3 };
inline constexpr int kStageCount = 4;
const char* to_string(Stage stage);

struct DebugView {
  std::vector<FusedFeature> features;
  std::vector<SwitchState> switches;
  std::optional<Clothoid> base_clothoid;
  GraphSize graph;
};

}  // namespace lanefuse
