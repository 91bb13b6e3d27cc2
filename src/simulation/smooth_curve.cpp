// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/smooth_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

/// Weights against jumps of the third and second differences, in samples: they decide only where there are
/// too few samples.
constexpr double kThirdDifference = 0.05;
constexpr double kSecondDifference = 1e-4;

struct Basis {
  Eigen::Vector4d value;
  Eigen::Vector4d slope;  ///< an interval
  Eigen::Vector4d bend;   ///< an interval squared
};

/// Of the uniform cubic B-spline, at the fraction `u` of an interval.
Basis basis(double u) {
  const double v = 1 - u;
  return {
      Eigen::Vector4d(v * v * v, 3 * u * u * u - 6 * u * u + 4, 3 * v * v * v - 6 * v * v + 4, u * u * u) / 6,
      Eigen::Vector4d(-v * v, 3 * u * u - 4 * u, -3 * v * v + 4 * v, u * u) / 2,
      Eigen::Vector4d(v, 3 * u - 2, 3 * v - 2, u)};
}

void add_row(Eigen::MatrixXd& normal, Eigen::Index first, const Eigen::VectorXd& row, double weight) {
  normal.block(first, first, row.size(), row.size()) += weight * row * row.transpose();
}

}  // namespace

SmoothCurve::SmoothCurve(std::span<const Sample> samples, double spacing) {
  assert(!samples.empty() && spacing > 0);
  const auto [first, last] = std::ranges::minmax(samples, {}, &Sample::at);
  const double intervals = std::max(1.0, std::ceil((last.at - first.at) / spacing));
  begin_ = first.at;
  spacing_ = std::max((last.at - first.at) / intervals, 1e-3 * spacing);
  const auto count = static_cast<Eigen::Index>(intervals) + 3;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (const Sample& sample : samples) {
    const double place = (sample.at - begin_) / spacing_;
    const double interval = std::clamp(std::floor(place), 0.0, intervals - 1);
    const Eigen::Vector4d weights = basis(place - interval).value;
    const auto knot = static_cast<Eigen::Index>(interval);
    add_row(normal, knot, weights, 1);
    right.segment<4>(knot) += sample.value * weights;
  }
  for (Eigen::Index i = 0; i + 3 < count; ++i)
    add_row(normal, i, Eigen::Vector4d(-1, 3, -3, 1), kThirdDifference);
  for (Eigen::Index i = 0; i + 2 < count; ++i)
    add_row(normal, i, Eigen::Vector3d(1, -2, 1), kSecondDifference);
  if (first.at == last.at) add_row(normal, 0, Eigen::Vector2d(1, -1), kSecondDifference);
  knots_ = normal.ldlt().solve(right);
}

/// Coefficients that rise make a curve that rises: pools neighbours that do not (adjacent violators).
void SmoothCurve::make_rising() {
  struct Pool {
    double mean;
    double count;
  };
  std::vector<Pool> pools;
  for (const double knot : knots_) {
    pools.push_back({knot, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& pool = pools.back();
      pool.mean = (pool.mean * pool.count + last.mean * last.count) / (pool.count + last.count);
      pool.count += last.count;
    }
  }
  Eigen::Index next = 0;
  for (const Pool& pool : pools) {
    for (double i = 0; i < pool.count; ++i) knots_[next++] = pool.mean;
  }
}

SmoothCurve::Place SmoothCurve::inside(double place) const {
  const double intervals = static_cast<double>(knots_.size() - 3);
  const double along = (place - begin_) / spacing_;
  const double interval = std::clamp(std::floor(along), 0.0, intervals - 1);
  const Basis weights = basis(along - interval);
  const Eigen::Vector4d knots = knots_.segment<4>(static_cast<Eigen::Index>(interval));
  return {weights.value.dot(knots), weights.slope.dot(knots) / spacing_,
          weights.bend.dot(knots) / (spacing_ * spacing_)};
}

SmoothCurve::Place SmoothCurve::at(double place) const {
  const double nearest = std::clamp(place, begin_, end());
  const Place inside = this->inside(nearest);
  if (nearest == place) return inside;
  return {inside.value + (place - nearest) * inside.slope, inside.slope, 0};
}

}  // namespace lanefuse
