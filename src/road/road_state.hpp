// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/feature.hpp"
#include "core/pose2.hpp"
#include "road/gaussian_state.hpp"
#include "road/road_axis.hpp"
#include "road/road_config.hpp"

namespace lanefuse {

inline constexpr double kEverywhere = -1e9;  ///< [m] begins, as far as anyone knows, nowhere

/// A line along the road, painted or only witnessed. Its lateral offsets from the axis are numbers of the
/// state.
struct KnownLine {
  std::uint64_t id = 0;
  int first = 0;  ///< of its offsets in the state
  LineLabel label = kNoLabel;
  MarkingEvidence marking;
  double seen_at = 0;           ///< [m] driven when it was last seen
  double seen_for = 0;          ///< [m] driven in which it has been seen
  double begin = kEverywhere;   ///< [m] from the car to where it begins, where that has been seen
  double density = 6;           ///< features of paint on it in a frame, of late
  double pull = 0;              ///< frames of late in which its paint lay beside where it should be
  double traffic_on_left = 0;   ///< sightings of vehicles between it and the next line on its left
  double traffic_on_right = 0;  ///< and on its right
  std::uint16_t paint = 0;      ///< measurements of each kind in this cycle
  std::uint16_t tracked = 0;
  std::uint16_t witnessed = 0;
};

/// A vehicle that keeps to a lane; how far from its middle is a number of the state.
struct RoadVehicle {
  std::int64_t track_id = kNoTrack;
  int index = 0;
  std::uint64_t left = 0;  ///< lines of its lane
  std::uint64_t right = 0;
  bool in_lane = true;  ///< else nobody knows its lane, and both lines are the one that it is compared with
  Time seen{};
  double surprise = 0;  ///< squared, against what was expected, smoothed
};

/// What the state's numbers from the second on are.
enum RoadNumber : int {
  kHeading = 0,       ///< [rad] of the car along the axis
  kYawRateError = 1,  ///< [rad/s] by which the dead reckoning turns too fast
  kPaintYaw = 2,      ///< [rad] of the marking camera's mounting
  kPaintLean = 3,     ///< [rad] by which its latest frame leans beyond that
  kPaintPitch = 4,    ///< [1/m] pitch of its latest frame over its height
  kTrackedYaw = 5,    ///< [rad] of the lane-tracking camera's mounting
  kVehicleYaw = 6,    ///< [rad] of all vehicles' bearings
  kSpeedScale = 7,    ///< share by which the car goes further than its dead reckoning says
  kCurvatures = 8,    ///< [1/m] RoadAxis::kKnots of them
  kCrests = kCurvatures + RoadAxis::kKnots,  ///< [1/m^2] vertical curvatures over the camera's height
  kFixedNumbers = kCrests + 6
};

/// The road ahead as one normal distribution: the axis' curvature along the arc, each line's offsets from it,
/// how far each vehicle drives beside the middle of its lane, the car's heading, and what is wrong with the
/// sensors. The road stands still and the car drives: all that was ever seen of a place bears on what is said
/// of it.
class RoadState {
 public:
  static constexpr int kOffsets = 6;            ///< of a line
  static constexpr double kOffsetSpacing = 40;  ///< [m] between them
  static constexpr std::size_t kMostLines = 9;
  static constexpr std::size_t kMostVehicles = 16;

  explicit RoadState(const RoadConfig& config) : config_(config) { clear(); }

  /// Nothing is known any more.
  void clear();

  /// The car has moved: all is told from where it is now.
  void drive(const Pose2& before_from_now, double seconds);

  /// [m] driven along the road since clear().
  [[nodiscard]] double driven() const { return driven_; }

  [[nodiscard]] const GaussianState& numbers() const { return numbers_; }
  [[nodiscard]] GaussianState& numbers() { return numbers_; }
  [[nodiscard]] const RoadAxis& axis() const { return axis_; }
  /// To be called when the numbers have changed and before the axis is looked at.
  void rebuild_axis();

  [[nodiscard]] std::vector<KnownLine>& lines() { return lines_; }
  [[nodiscard]] const std::vector<KnownLine>& lines() const { return lines_; }
  [[nodiscard]] std::vector<RoadVehicle>& vehicles() { return vehicles_; }
  [[nodiscard]] const std::vector<RoadVehicle>& vehicles() const { return vehicles_; }

  /// Adds a line `offset` left of the axis, as well known as `sigma`; null where there is no room.
  KnownLine* add_line(double offset, double sigma);
  /// Adds a line that is `distance` left of a known one, all along, give or take `sigma`.
  KnownLine* add_line_beside(std::uint64_t known, double distance, double sigma);
  void remove_line(std::size_t line);
  RoadVehicle* add_vehicle(std::int64_t track_id);
  /// A vehicle in nobody knows which lane: where it is says nothing, how it moves does.
  RoadVehicle* add_stranger(std::int64_t track_id, double aside, double sigma);
  void remove_vehicle(std::size_t vehicle);
  /// By how much sensors err more than was assumed, as innovations of late show; 1 is as assumed. All noise
  /// that is the sensors' is taken so many times as large.
  [[nodiscard]] double noise_scale() const { return noise_scale_; }
  /// A measurement's innovation squared, over its variance.
  void note_surprise(double surprise);

  /// [1/m] sigma by which this road's curvature changes over one knot spacing.
  [[nodiscard]] double usual_step() const;
  /// Lets the road bend from a station on as no road behind did.
  void free_course(double station);
  /// Lets the line go its own way from a station on: its offsets there are as uncertain as `sigma`.
  void free_line(const KnownLine& line, double station, double sigma);
  [[nodiscard]] const KnownLine* find_line(std::uint64_t id) const;

  /// A line's offset and its slope at a station.
  [[nodiscard]] double offset(const KnownLine& line, double station) const;
  [[nodiscard]] double slope(const KnownLine& line, double station) const;

  /// Adds to `row` how a point's place left of the axis, `at`, changes with the numbers of axis and heading.
  void add_lateral(SparseRow& row, const RoadAxis::Place& at, double factor = 1) const;
  void add_offset(SparseRow& row, const KnownLine& line, double station, double factor = 1) const;
  /// The road's height over the plane that touches it under the car, as a share of the camera's height.
  [[nodiscard]] double relative_height(double station) const;
  void add_relative_height(SparseRow& row, double station, double factor) const;
  /// The variance of where the line is across, at a station.
  [[nodiscard]] double variance(const KnownLine& line, double station) const;

  /// [m] from the car to the first of the curvatures' and of the offsets' knots.
  [[nodiscard]] double first_knot() const { return first_knot_; }
  [[nodiscard]] double first_offset() const { return first_offset_; }

 private:
  bool stand(const Pose2& before_from_now, double seconds);
  void move_knots();
  void decay_errors(double seconds);
  [[nodiscard]] double persistence() const;
  [[nodiscard]] SparseRow next_curvature(int knot) const;
  [[nodiscard]] SparseRow next_crest(int before) const;
  [[nodiscard]] double crest_noise() const;

  RoadConfig config_;
  GaussianState numbers_;
  RoadAxis axis_;
  std::vector<KnownLine> lines_;
  std::vector<RoadVehicle> vehicles_;
  double first_knot_ = 0;
  double first_offset_ = 0;
  double driven_ = 0;
  double noise_scale_ = 1;
  double innovations_ = 0;   ///< that have been noted
  double restlessness_ = 0;  ///< [1/m^2] mean square of the curvature's steps behind
  std::uint64_t next_line_ = 1;
};

}  // namespace lanefuse
