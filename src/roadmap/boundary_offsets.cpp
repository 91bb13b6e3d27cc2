// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/boundary_offsets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kStep = 2.0;               // [m] between rows at most
constexpr double kSearchStep = 5.0;         // [m]
constexpr double kOffsetTolerance = 0.002;  // [m]
constexpr double kHeightTolerance = 0.005;  // [m]
constexpr double kBackwards = 0.05;         // [m] that noise may go back
constexpr double kFarthest = 200;           // [m] beside the reference line

double ahead_of(const Pose2& pose, const Eigen::Vector2d& point) {
  return (point - pose.position()).dot(Eigen::Vector2d(std::cos(pose.heading), std::sin(pose.heading)));
}

double nearest_sample(const PlanView& plan, const Eigen::Vector2d& point) {
  double nearest = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (double station = 0; station <= plan.end(); station += kSearchStep) {
    const double here = (plan.pose(station).position() - point).norm();
    if (here >= distance) continue;
    distance = here;
    nearest = station;
  }
  return nearest;
}

/// The station at which the point is square to the line, searched from a near one on.
double station_beside(const PlanView& plan, const Eigen::Vector2d& point, double station) {
  for (int round = 0; round < 60; ++round) {
    const double step = ahead_of(plan.pose(station), point);
    station += step;
    if (std::abs(step) < 1e-7) break;
  }
  return station;
}

}  // namespace

BoundaryOffsets::BoundaryOffsets(const MapBoundary& boundary, const PlanView& plan,
                                 const std::string& place) {
  project(boundary, plan, fmt::format("{}, boundary {}", place, boundary.id));
  bends_ = bends_of(&Row::offset, kOffsetTolerance);
}

void BoundaryOffsets::project(const MapBoundary& boundary, const PlanView& plan, const std::string& place) {
  double station = nearest_sample(plan, boundary.points.front().head<2>());
  double arc_length = 0;
  const auto add = [&](const Eigen::Vector3d& point, double step) {
    arc_length += step;
    station = station_beside(plan, point.head<2>(), station);
    const Pose2 pose = plan.pose(station);
    const Eigen::Vector2d beside = pose.inverse() * Eigen::Vector2d(point.head<2>());
    const bool turned_back = !rows_.empty() && station < rows_.back().station - kBackwards;
    if (turned_back || std::abs(beside.x()) > 0.01 || std::abs(beside.y()) > kFarthest) {
      throw input_error(place, "does not run beside its road's reference line",
                        "OpenDRIVE cannot tell such a road; write Lanelet2 or GeoJSON");
    }
    if (rows_.empty() || station > rows_.back().station + 1e-6) {
      rows_.push_back({station, beside.y(), point.z(), arc_length});
    }
    station += step;  // a guess for the next
  };
  add(boundary.points.front(), 0);
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    const Eigen::Vector3d& from = boundary.points[i - 1];
    const Eigen::Vector3d step = boundary.points[i] - from;
    const int parts = std::max(1, static_cast<int>(std::ceil(step.norm() / kStep)));
    for (int part = 1; part <= parts; ++part) add(from + step * part / parts, step.norm() / parts);
  }
}

double BoundaryOffsets::value(double at, double Row::*by, double Row::*what) const {
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), at,
                                      [by](double v, const Row& row) { return v < row.*by; });
  if (after == rows_.begin()) return rows_.front().*what;
  if (after == rows_.end()) return rows_.back().*what;
  const Row& from = *(after - 1);
  const double share = (at - from.*by) / ((*after).*by - from.*by);
  return from.*what + share * ((*after).*what - from.*what);
}

double BoundaryOffsets::offset(double station) const { return value(station, &Row::station, &Row::offset); }
double BoundaryOffsets::height(double station) const { return value(station, &Row::station, &Row::height); }
double BoundaryOffsets::station_of(double arc_length) const {
  return value(arc_length, &Row::arc_length, &Row::station);
}

std::vector<double> BoundaryOffsets::height_bends() const { return bends_of(&Row::height, kHeightTolerance); }

/// From each bend as far as a straight piece stays within the tolerance of all rows it passes.
std::vector<double> BoundaryOffsets::bends_of(double Row::*what, double tolerance) const {
  std::vector<double> bends = {rows_.front().station};
  std::size_t from = 0;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    const double run = rows_[i].station - rows_[from].station;
    const double rise = rows_[i].*what - rows_[from].*what;
    if (rise / run < lowest || rise / run > highest) {
      from = i - 1;
      bends.push_back(rows_[from].station);
      lowest = -std::numeric_limits<double>::infinity();
      highest = std::numeric_limits<double>::infinity();
    }
    const double span = rows_[i].station - rows_[from].station;
    const double climb = rows_[i].*what - rows_[from].*what;
    lowest = std::max(lowest, (climb - tolerance) / span);
    highest = std::min(highest, (climb + tolerance) / span);
  }
  bends.push_back(rows_.back().station);
  return bends;
}

}  // namespace lanefuse
