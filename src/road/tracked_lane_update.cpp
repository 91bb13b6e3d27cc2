// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/tracked_lane_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

constexpr double kGate = 1.2;      ///< [m] from a line that is known
constexpr double kFound = 2.2;     ///< [m] from all lines: a new one
constexpr double kNear = 5;        ///< [m] where the side is compared
constexpr double kFloor = 0.03;    ///< [m] no tracked lane is better
constexpr double kUsualWay = 1.2;  ///< [m] driven between two, for which the inflation is meant
constexpr double kMostRepeats = 50;
constexpr double kRefused = 16;  ///< squared sigmas of a number of the course

double square(double x) { return x * x; }

using Vector4 = Eigen::Vector4d;
using Rows4 = Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, GaussianState::kCapacity>;

}  // namespace

std::size_t TrackedLaneUpdate::line_of(const ClothoidMeasurement& side, const Pose2& now_from_measured,
                                       RoadState& state) const {
  const Eigen::Vector2d place = now_from_measured * Eigen::Vector2d(kNear, side.clothoid.y(kNear));
  const RoadAxis::Foot foot = state.axis().project(place);
  std::size_t nearest = state.lines().size();
  double least = 1e9;
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    const KnownLine& line = state.lines()[i];
    const double away = std::abs(foot.lateral - state.offset(line, foot.place.station));
    const bool labelled = config_.association == RoadAssociation::labelled;
    if (labelled ? side.label == line.label && side.label >= 0 : away < least) {
      nearest = i;
      least = labelled ? 0 : away;
    }
  }
  if (least < kGate) return nearest;
  if (least < kFound) return state.lines().size();
  KnownLine* line = state.add_line(foot.lateral, 0.5);
  if (!line) return state.lines().size();
  line->label = side.label;
  return state.lines().size() - 1;
}

std::size_t TrackedLaneUpdate::take(const FeatureSet& set, const Pose2& now_from_measured, double moved,
                                    RoadState& state) {
  given_to_.assign(set.clothoids.size(), 0);
  const ClothoidMeasurement* left = nullptr;
  const ClothoidMeasurement* right = nullptr;
  for (const ClothoidMeasurement& clothoid : set.clothoids) {
    (clothoid.side == Side::left ? left : right) = &clothoid;
  }
  std::array<const ClothoidMeasurement*, 2> sides{left, right};
  std::array<std::size_t, 2> lines{};
  state.rebuild_axis();
  for (std::size_t i = 0; i < 2; ++i) {
    if (sides[i]) lines[i] = line_of(*sides[i], now_from_measured, state);
    if (sides[i] && lines[i] == state.lines().size()) sides[i] = nullptr;
  }
  const double inflation = square(state.noise_scale()) * config_.tracked_lane.inflation *
                           std::clamp(kUsualWay / std::max(moved, 1e-3), 0.1, kMostRepeats);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!sides[i]) continue;
    KnownLine& line = state.lines()[lines[i]];
    given_to_[static_cast<std::size_t>(sides[i] - set.clothoids.data())] = line.id;
    ++line.tracked;
    if (sides[i]->marking.type != MarkingType::unknown) line.marking.type = sides[i]->marking.type;
    if (sides[i]->marking.colour != MarkingColour::unknown) line.marking.colour = sides[i]->marking.colour;
  }
  if (sides[0] && sides[1] && lines[0] != lines[1]) {
    const KnownLine& l = state.lines()[lines[0]];
    const KnownLine& r = state.lines()[lines[1]];
    take_course(*sides[0], sides[1], now_from_measured, inflation, state, l, &r);
    const double across = std::cos(sides[0]->clothoid.heading_at(0));
    const double width = (sides[0]->clothoid.lateral_offset - sides[1]->clothoid.lateral_offset) * across;
    SparseRow row;
    state.add_offset(row, l, 0);
    state.add_offset(row, r, 0, -1);
    const double noise =
        inflation * (sides[0]->covariance(0, 0) + sides[1]->covariance(0, 0)) + square(kFloor);
    state.numbers().update(row, width - state.offset(l, 0) + state.offset(r, 0), noise);
    return 2;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (!sides[i]) continue;
    take_course(*sides[i], nullptr, now_from_measured, inflation, state, state.lines()[lines[i]], nullptr);
    return 1;
  }
  return 0;
}

void TrackedLaneUpdate::take_course(const ClothoidMeasurement& side, const ClothoidMeasurement* other,
                                    const Pose2& now_from_measured, double inflation, RoadState& state,
                                    const KnownLine& line, const KnownLine* other_line) const {
  const double end = std::clamp(side.range_end, 20.0, 62.0);
  const Vector4 distances(2, end / 3, 2 * end / 3, end);
  Vector4 measured = side.clothoid.vector();
  Eigen::Matrix4d covariance = side.covariance;
  if (other) {
    measured = (measured + other->clothoid.vector()) / 2;
    covariance = (covariance + other->covariance) / 2;
  }
  const Clothoid course = Clothoid::from_vector(measured);
  const int size = state.numbers().size();
  Rows4 rows = Rows4::Zero(4, size);
  Eigen::Matrix4d at;
  Vector4 residual;
  const double yaw = state.numbers().mean(kTrackedYaw);
  for (int i = 0; i < 4; ++i) {
    at.row(i) = lateral_jacobian(distances[i]);
    const Eigen::Vector2d seen = rotation(-yaw) * Eigen::Vector2d(distances[i], course.y(distances[i]));
    const RoadAxis::Foot foot = state.axis().project(now_from_measured * seen);
    SparseRow row;
    state.add_lateral(row, foot.place);
    state.add_offset(row, line, foot.place.station, other ? -0.5 : -1);
    if (other) state.add_offset(row, *other_line, foot.place.station, -0.5);
    row.add(kTrackedYaw, -distances[i]);
    for (const auto& [index, value] : row) rows(i, index) += value;
    const double offset =
        other ? (state.offset(line, foot.place.station) + state.offset(*other_line, foot.place.station)) / 2
              : state.offset(line, foot.place.station);
    residual[i] = foot.lateral - offset;
  }
  Eigen::Matrix4d noise = inflation * at * covariance * at.transpose();
  noise.diagonal().array() += square(kFloor);
  const Eigen::LLT<Eigen::Matrix4d> root(noise);
  if (root.info() != Eigen::Success) return;
  root.matrixL().solveInPlace(rows);
  root.matrixL().solveInPlace(residual);
  const Vector4 before = residual;
  GaussianState::Vector row(size);
  GaussianState::Vector moved = GaussianState::Vector::Zero(size);
  for (int i = 0; i < 4; ++i) {
    row = rows.row(i).transpose();
    // What the rows before have moved the state by, this row sees as well.
    const double rest = before[i] + row.dot(moved);
    const double variance = row.dot(state.numbers().times(row)) + 1;
    if (square(rest) > kRefused * variance) continue;
    moved += state.numbers().update(row, -rest, 1);
  }
}

}  // namespace lanefuse
