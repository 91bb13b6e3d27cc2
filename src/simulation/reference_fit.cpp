// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/reference_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "simulation/evenly_spaced.hpp"

namespace lanefuse {
namespace {

constexpr double kStep = 5;                 ///< [m] of one road element
constexpr double kPreview = 60;             ///< [m] ahead that each element looks
constexpr int kSmoothing = 10;              ///< points to either side, a metre apart, that are averaged
constexpr std::size_t kLastPoints = 120;    ///< a metre apart, among which the end may be reached
constexpr double kLargestCurvature = 0.02;  ///< [1/m]

/// Each point in the middle of its neighbours; towards the ends of as many as there are on both sides.
std::vector<Eigen::Vector2d> smoothed(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> result;
  const auto count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    const int reach = std::min({kSmoothing, i, count - 1 - i});
    Eigen::Vector2d sum(0, 0);
    for (int j = i - reach; j <= i + reach; ++j) sum += points[static_cast<std::size_t>(j)];
    result.push_back(sum / (2 * reach + 1));
  }
  return result;
}

/// Drives along the points: each element turns so that the polynomial through what is ahead is followed.
class Follower {
 public:
  explicit Follower(std::vector<Eigen::Vector2d> points) : points_(std::move(points)) {
    const Eigen::Vector2d ahead = points_[std::min<std::size_t>(points_.size() - 1, 20)] - points_.front();
    start_ = pose_ = {points_.front().x(), points_.front().y(), std::atan2(ahead.y(), ahead.x())};
    start_ = pose_ = pose_ * Pose2{0, 0, coefficients(1)[0]};
    curvature_ = std::clamp(coefficients(2)[0], -kLargestCurvature, kLargestCurvature);
  }

  /// Nothing where the points turn so sharply that it loses them.
  std::optional<ReferenceLine> drive() {
    std::vector<RoadElement> elements;
    while (elements.empty() || !is_at_end()) {
      if (elements.size() >= points_.size()) return std::nullopt;
      const Eigen::Vector2d ahead = coefficients(3);
      const double wanted = curvature_ + kStep * (ahead[0] + kStep / 2 * ahead[1]);
      const double next = std::clamp(wanted, -kLargestCurvature, kLargestCurvature);
      elements.push_back({kStep, curvature_, (next - curvature_) / kStep});
      const ReferenceLine step({elements.back()}, pose_);
      pose_ = step.pose(kStep);
      curvature_ = next;
    }
    return ReferenceLine(elements, start_);
  }

 private:
  std::vector<Eigen::Vector2d> points_;
  Pose2 start_;
  Pose2 pose_;
  double curvature_ = 0;
  std::size_t nearest_ = 0;

  /// A road that turns back has its end behind it long before it is there.
  [[nodiscard]] bool is_at_end() const {
    return nearest_ + kLastPoints >= points_.size() && (pose_.inverse() * points_.back()).x() <= kStep / 2;
  }

  /// Of the terms u^n/n! and u^(n+1)/(n+1)! of the way ahead that the pose and, above the second power, the
  /// curvature do not yet explain; by least squares.
  Eigen::Vector2d coefficients(int power) {
    const Pose2 pose_from_world = pose_.inverse();
    while (nearest_ + 1 < points_.size() && (pose_from_world * points_[nearest_ + 1]).x() <= 0) ++nearest_;
    Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-9;
    Eigen::Vector2d right(0, 0);
    const double factorial = std::tgamma(power + 1);
    for (std::size_t i = nearest_; i < points_.size(); ++i) {
      const Eigen::Vector2d seen = pose_from_world * points_[i];
      if (seen.x() > kPreview) break;
      const double unit = seen.x() / kPreview;  // so that both terms are of one size
      const Eigen::Vector2d row(std::pow(unit, power) / factorial,
                                std::pow(unit, power + 1) / factorial / (power + 1));
      const double explained = power > 2 ? curvature_ * seen.x() * seen.x() / 2 : 0;
      normal += row * row.transpose();
      right += row * (seen.y() - explained);
    }
    const Eigen::Vector2d scaled = normal.ldlt().solve(right);
    return {scaled[0] / std::pow(kPreview, power), scaled[1] / std::pow(kPreview, power + 1)};
  }
};

}  // namespace

std::optional<ReferenceLine> fit_reference_line(const std::vector<Eigen::Vector2d>& points) {
  return Follower(smoothed(evenly_spaced(points, 1))).drive();
}

}  // namespace lanefuse
