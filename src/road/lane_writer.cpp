// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/lane_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace lanefuse {
namespace {

constexpr double kNarrowest = 2.2;  ///< [m] lane
constexpr double kWidest = 5.2;
constexpr double kShortest = 8;      ///< [m]
constexpr double kShoulder = 0.9;    ///< of the usual width: narrower is none that is driven on
constexpr double kDriven = 5;        ///< sightings of vehicles that make it one
constexpr double kUsualWidth = 3.6;  ///< [m]
constexpr double kSortAt = 30;       ///< [m] ahead, where lines are put in order
constexpr double kStep = 2.5;        ///< [m] of arc between the places that are written
constexpr double kSigmaStep = 10;    ///< [m] of arc between the sigmas
constexpr double kFitRange = 110;    ///< [m] up to which the clothoid must fit

double square(double x) { return x * x; }

}  // namespace

void LaneWriter::clear() {
  known_lanes_.clear();
  next_lane_ = 1;
}

void LaneWriter::write(const RoadState& state, LaneEstimate& estimate) {
  from_left_.clear();
  for (const KnownLine& line : state.lines()) from_left_.push_back(&line);
  std::sort(from_left_.begin(), from_left_.end(), [&](const KnownLine* a, const KnownLine* b) {
    // Where both are: a line that begins ahead may begin on another.
    const double at = std::max({kSortAt, a->begin + kSortAt, b->begin + kSortAt});
    const double at_a = state.offset(*a, at);
    const double at_b = state.offset(*b, at);
    return at_a > at_b || (at_a == at_b && a->id < b->id);
  });
  for (Boundary& old : estimate.boundaries) spare_points_.push_back(std::move(old.points));
  estimate.boundaries.clear();
  for (const KnownLine* line : from_left_) {
    Boundary& boundary = estimate.boundaries.emplace_back();
    if (!spare_points_.empty()) {
      boundary.points.swap(spare_points_.back());
      spare_points_.pop_back();
    }
    write_boundary(state, *line, boundary);
  }
  write_lanes(state, estimate);
}

void LaneWriter::write_boundary(const RoadState& state, const KnownLine& line, Boundary& boundary) {
  boundary.id = line.id;
  boundary.marking = line.marking;
  boundary.confidence = 1 - std::exp(-(line.seen_for + 5) / 30);
  boundary.support[static_cast<std::size_t>(Source::high_resolution_camera)] = line.paint;
  boundary.support[static_cast<std::size_t>(Source::serial_camera)] = line.tracked;
  boundary.support[static_cast<std::size_t>(Source::objects)] = line.witnessed;
  write_points(state, line, boundary);
  fit_clothoid(state, line, boundary);
}

double LaneWriter::sigma_of(const RoadState& state, const KnownLine& line, double station) const {
  const double of_height = config_.height_error * state.offset(line, station);
  const double of_bends = 1 + config_.bend_doubt * state.usual_step();
  const double of_state = of_bends * std::max(0.0, state.variance(line, station));
  return config_.sigma_scale * std::sqrt(of_state + square(of_height));
}

void LaneWriter::write_points(const RoadState& state, const KnownLine& line, Boundary& boundary) {
  boundary.points.clear();
  const RoadAxis& axis = state.axis();
  double x = 0;
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  double sigma_before = 0;
  double sigma = sigma_of(state, line, 0);
  double sigma_after = sigma;
  double sigma_at = -kSigmaStep;
  for (double station = -10; station <= RoadAxis::kEnd - kStep; station += kStep) {
    if (station >= 0 && station >= sigma_at + kSigmaStep) {
      sigma_at = station;
      sigma_before = sigma_after;
      sigma_after = sigma_of(state, line, station + kSigmaStep);
      if (station == 0) sigma_before = sigma;
    }
    const RoadAxis::Place place = axis.at(station);
    const Eigen::Vector2d point = place.point + state.offset(line, station) * place.normal();
    const double fraction = station < 0 ? 0 : (station - sigma_at) / kSigmaStep;
    sigma = station < 0 ? sigma : sigma_before + fraction * (sigma_after - sigma_before);
    if (station > -10) {
      for (; x <= point.x() && x <= config_.range_max; x += kPointSpacing) {
        if (x < before.x()) continue;
        const double f = (x - before.x()) / (point.x() - before.x());
        if (sigma > config_.sigma_max) break;
        if (x < line.begin) continue;
        boundary.points.push_back(
            {x, before.y() + f * (point.y() - before.y()), sigma, config_.protection * sigma});
      }
      if (sigma > config_.sigma_max || x > config_.range_max) break;
    }
    before = point;
  }
  boundary.range_begin = boundary.points.empty() ? 0 : boundary.points.front().x;
  boundary.range_end = boundary.points.empty() ? -1 : boundary.points.back().x;
}

void LaneWriter::fit_clothoid(const RoadState& state, const KnownLine& line, Boundary& boundary) const {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const BoundaryPoint& point : boundary.points) {
    if (point.x > kFitRange) break;
    // In lengths of 100 m, so that the four numbers are of one size.
    const double u = point.x / 100;
    const Eigen::Vector4d powers(1, u, u * u, u * u * u);
    const double weight = 1 / square(0.02 + 0.1 * u * u) * (point.x == 0 ? 100 : 1);
    normal += weight * powers * powers.transpose();
    right += weight * point.y * powers;
  }
  normal.diagonal().array() += 1e-6;
  const Eigen::Vector4d fit = normal.ldlt().solve(right);
  boundary.clothoid = {fit[0], fit[1] / 100, 2 * fit[2] / 1e4, 6 * fit[3] / 1e6};
  constexpr std::array kAt{0.0, 35.0, 70.0, 105.0};  // [m] where the clothoid's covariance is the line's
  std::array<SparseRow, 4> rows;
  Eigen::Matrix4d vandermonde;
  for (int i = 0; i < 4; ++i) {
    const double at = kAt[static_cast<std::size_t>(i)];
    state.add_lateral(rows[static_cast<std::size_t>(i)], state.axis().at(at), -1);
    state.add_offset(rows[static_cast<std::size_t>(i)], line, at);
    vandermonde.row(i) = lateral_jacobian(at);
  }
  Eigen::Matrix4d places;
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) {
      places(i, j) = places(j, i) =
          state.numbers().covariance(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::Matrix4d inverse = vandermonde.inverse();
  const Eigen::Matrix4d covariance =
      config_.sigma_scale * config_.sigma_scale * inverse * places * inverse.transpose();
  boundary.covariance = (covariance + covariance.transpose()) / 2;
}

/// Where both boundaries speak and are as far apart as a lane is wide: the longest such stretch.
LaneWriter::Stretch LaneWriter::lane_stretch(const Boundary& left, const Boundary& right) {
  Stretch longest;
  Stretch here;
  std::size_t r = 0;
  for (const BoundaryPoint& point : left.points) {
    while (r < right.points.size() && right.points[r].x < point.x) ++r;
    const bool both = r < right.points.size() && right.points[r].x == point.x;
    const double width = both ? point.y - right.points[r].y : 0;
    if (width < kNarrowest || width > kWidest) {
      here = {};
      continue;
    }
    if (here.end < here.begin) here.begin = point.x;
    here.end = point.x;
    if (here.end - here.begin > longest.end - longest.begin) longest = here;
  }
  return longest;
}

/// An outermost lane that is narrower than the others and that nobody has ever driven on is a shoulder, or
/// the gap between the edge and a guard rail that shines.
bool LaneWriter::is_shoulder(const RoadState& state, std::size_t left, double usual_width) const {
  const KnownLine& a = *from_left_[left];
  const KnownLine& b = *from_left_[left + 1];
  const bool outermost = left == 0 || left + 2 == from_left_.size();
  const double at = std::max({10.0, a.begin, b.begin});
  const double width = state.offset(a, at) - state.offset(b, at);
  return outermost && width < kShoulder * usual_width && b.traffic_on_left < kDriven;
}

double LaneWriter::usual_width(const RoadState& state) const {
  // That of the lane that the car is in, or of the one next to that.
  double width = kUsualWidth;
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < from_left_.size(); ++i) {
    const double left = state.offset(*from_left_[i], 0);
    const double right = state.offset(*from_left_[i + 1], 0);
    const double aside = std::abs(left + right) / 2;
    if (left - right < kNarrowest || left - right > kWidest || aside > nearest) continue;
    nearest = aside;
    width = left - right;
  }
  return width;
}

void LaneWriter::write_lanes(const RoadState& state, LaneEstimate& estimate) {
  estimate.lanes.clear();
  const double usual = usual_width(state);
  for (std::size_t b = 0; b + 1 < estimate.boundaries.size(); ++b) {
    const Boundary& left = estimate.boundaries[b];
    const Boundary& right = estimate.boundaries[b + 1];
    const Stretch stretch = lane_stretch(left, right);
    if (stretch.end - stretch.begin < kShortest || is_shoulder(state, b, usual)) continue;
    Lane lane;
    lane.id = lane_id(left.id, right.id);
    lane.left_boundary = left.id;
    lane.right_boundary = right.id;
    lane.range_begin = stretch.begin;
    lane.range_end = stretch.end;
    if (!estimate.lanes.empty() && estimate.lanes.back().right_boundary == lane.left_boundary) {
      lane.left_lane = estimate.lanes.back().id;
      estimate.lanes.back().right_lane = lane.id;
    }
    estimate.lanes.push_back(std::move(lane));
  }
  keep_what_bounds(estimate);
  std::erase_if(known_lanes_, [&](const KnownLane& lane) {
    return !find_boundary(estimate, lane.left) || !find_boundary(estimate, lane.right);
  });
}

/// A boundary speaks where it bounds a lane; a line that bounds none is paint, and no boundary.
void LaneWriter::keep_what_bounds(LaneEstimate& estimate) {
  for (Boundary& boundary : estimate.boundaries) {
    double begin = 1e9;
    double end = -1e9;
    for (const Lane& lane : estimate.lanes) {
      if (lane.left_boundary != boundary.id && lane.right_boundary != boundary.id) continue;
      begin = std::min(begin, lane.range_begin);
      end = std::max(end, lane.range_end);
    }
    std::erase_if(boundary.points,
                  [&](const BoundaryPoint& point) { return point.x < begin || point.x > end; });
    boundary.range_begin = begin;
    boundary.range_end = end;
    if (boundary.points.empty()) spare_points_.push_back(std::move(boundary.points));
  }
  std::erase_if(estimate.boundaries,
                [](const Boundary& boundary) { return boundary.range_end < boundary.range_begin; });
}

std::uint64_t LaneWriter::lane_id(std::uint64_t left, std::uint64_t right) {
  const auto known = std::find_if(known_lanes_.begin(), known_lanes_.end(), [&](const KnownLane& lane) {
    return lane.left == left && lane.right == right;
  });
  if (known != known_lanes_.end()) return known->id;
  known_lanes_.push_back({left, right, next_lane_});
  return next_lane_++;
}

}  // namespace lanefuse
