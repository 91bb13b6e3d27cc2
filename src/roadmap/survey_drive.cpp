// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_drive.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLeastConfidence = 0.3;
constexpr double kLongestHole = 3600;   ///< [s] between two fixes
constexpr double kLargestSigma = 0.15;  ///< [m] of an offset: beyond it the camera has not settled

void append(const std::optional<ClothoidMeasurement>& seen, Side side, const SerialLane& lane,
            std::vector<SeenMarking>& markings) {
  if (!seen || !is_plausible(*seen) || seen->confidence < kLeastConfidence) return;
  SeenMarking marking{lane.stamp.measured_at,
                      side,
                      seen->clothoid,
                      seen->covariance(0, 0),
                      seen->marking_width.value_or(lane.marking_width.value_or(0)),
                      seen->marking};
  if (marking.variance > kLargestSigma * kLargestSigma) return;
  marking.line.lateral_offset += (side == Side::left ? 0.5 : -0.5) * marking.paint_width;
  markings.push_back(marking);
}

}  // namespace

std::vector<SeenMarking> markings_of(const SerialLane& lane) {
  std::vector<SeenMarking> markings;
  append(lane.left, Side::left, lane, markings);
  append(lane.right, Side::right, lane, markings);
  return markings;
}

TrackSmoother::Fix vehicle_fix(const GnssInsFix& fix, const GeoFrame& frame, const Rig& rig) {
  const GeoOrigin there{fix.latitude / kDegree, fix.longitude / kDegree, fix.height};
  const Eigen::Vector3d place = frame.local(there);
  const Pose2 map_from_sensor{place.x(), place.y(), wrap_angle(fix.heading + frame.convergence(there))};
  const SensorDescription* sensor = rig.find(fix.stamp.sensor_id);
  const Mounting mounting = sensor ? sensor->mounting : Mounting{};
  const Pose2 vehicle_from_sensor{mounting.x, mounting.y, mounting.yaw};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = fix.position_covariance.topLeftCorner<2, 2>();
  covariance(2, 2) = fix.heading_sigma * fix.heading_sigma;
  return {fix.stamp.measured_at, map_from_sensor * vehicle_from_sensor.inverse(), covariance,
          place.z() - mounting.z};
}

SurveyRecorder::SurveyRecorder(std::string name, const GeoFrame& frame, Rig rig, const SurveyConfig& config)
    : frame_(frame), rig_(std::move(rig)), config_(config) {
  drive_.name = std::move(name);
}

void SurveyRecorder::add_fix(const GnssInsFix& fix) {
  // A millisecond's grace, as clocks jitter.
  if (fix.stamp.measured_at + std::chrono::milliseconds(1) < next_fix_) return;
  next_fix_ = fix.stamp.measured_at + from_seconds(config_.fix_period);
  smoother_.add(vehicle_fix(fix, frame_, rig_));
}

void SurveyRecorder::add(const Measurement& measurement) {
  if (implausible(measurement)) return;
  if (const auto* motion = std::get_if<VehicleMotion>(&measurement)) smoother_.add(*motion);
  if (const auto* fix = std::get_if<GnssInsFix>(&measurement)) add_fix(*fix);
  if (const auto* lane = std::get_if<SerialLane>(&measurement)) {
    for (const SeenMarking& marking : markings_of(*lane)) drive_.markings.push_back(marking);
  }
}

SurveyedDrive SurveyRecorder::finish() {
  // Nodes are laid through holes: a clock that was set during the drive must not lay them for years.
  const double hole = to_seconds(smoother_.longest_hole());
  if (hole > kLongestHole) {
    throw input_error(drive_.name, fmt::format("has no GNSS/INS fix for {:.0f} s", hole),
                      "cut the drive in two there");
  }
  drive_.track = smoother_.smooth();
  if (drive_.track.empty()) {
    throw input_error(drive_.name, "holds no GNSS/INS fixes along with odometry",
                      "this needs drives with /in/gnss_ins, as of simulate --gnss-ins");
  }
  std::stable_sort(drive_.markings.begin(), drive_.markings.end(),
                   [](const SeenMarking& a, const SeenMarking& b) { return a.time < b.time; });
  const bool seen = std::any_of(drive_.markings.begin(), drive_.markings.end(), [this](const auto& marking) {
    return pose_at(drive_.track, marking.time).has_value();
  });
  if (!seen) {
    throw input_error(drive_.name, "holds no marking of a serial camera where there are fixes",
                      "this needs drives with /in/serial_camera");
  }
  return std::move(drive_);
}

}  // namespace lanefuse
