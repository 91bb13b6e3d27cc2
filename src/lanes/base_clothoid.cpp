// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/base_clothoid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

constexpr double kMadToSigma =
    1.4826;  ///< median absolute deviation to standard deviation, for normal residuals
constexpr double kScatterFloor = 0.003;  ///< [rad] of a feature's heading: what calibration leaves
constexpr double kSlopeFloor = 1e-4;     ///< no scatter is taken to be smaller: exact data has no outliers
constexpr double kMaxHeading =
    0.35;  ///< [rad] beyond this a feature is no lane's, and the cubic does not hold

/// The row of the slope's regression: y'(x) = theta0 + c0 x + c1 x^2 / 2.
Eigen::Vector3d slope_row(double x) { return {1, x, x * x / 2}; }

/// The same for the position beyond its offset: y(x) - y0 = theta0 x + c0 x^2 / 2 + c1 x^3 / 6.
Eigen::Vector3d position_row(double x) { return {x, x * x / 2, x * x * x / 6}; }

Clothoid shaped(const Eigen::Vector3d& shape) { return {0, shape[0], shape[1], shape[2]}; }

}  // namespace

bool BaseClothoidFit::considered(const Feature& feature) const {
  return feature.x > config_.range_begin && feature.x < config_.range_end && std::isfinite(feature.y) &&
         std::abs(feature.heading) < kMaxHeading && feature.confidence > 0;
}

Eigen::Vector3d BaseClothoidFit::prior_weights() const {
  const double curvature = config_.curvature_sigma;
  const double rate = config_.curvature_rate_sigma;
  return {0, scatter_ / (curvature * curvature), scatter_ / (rate * rate)};
}

std::optional<Eigen::Vector3d> BaseClothoidFit::solve(std::span<const Feature> features) {
  normal_ = prior_weights().asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (roles_[i] != FitRole::inlier) continue;
    const Eigen::Vector3d row = slope_row(features[i].x);
    normal_ += features[i].confidence * row * row.transpose();
    right += features[i].confidence * tangents_[i] * row;
    ++count;
  }
  if (count < config_.min_features) return std::nullopt;
  return normal_.ldlt().solve(right);
}

bool BaseClothoidFit::cut_outliers(std::span<const Feature> features, const Eigen::Vector3d& shape) {
  residuals_.clear();
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (roles_[i] == FitRole::unused) continue;
    residuals_.push_back(std::abs(tangents_[i] - slope_row(features[i].x).dot(shape)));
  }
  const auto middle = residuals_.begin() + static_cast<std::ptrdiff_t>(residuals_.size() / 2);
  sorted_ = residuals_;
  const auto median = sorted_.begin() + (middle - residuals_.begin());
  std::nth_element(sorted_.begin(), median, sorted_.end());
  const double cut = std::max(config_.outlier_cut * kMadToSigma * *median, kSlopeFloor);
  bool changed = false;
  std::size_t r = 0;
  for (FitRole& role : roles_) {
    if (role == FitRole::unused) continue;
    const FitRole now = residuals_[r++] > cut ? FitRole::outlier : FitRole::inlier;
    changed |= now != role;
    role = now;
  }
  return changed;
}

std::optional<BaseClothoid> BaseClothoidFit::fit(std::span<const Feature> features) {
  const double sigma = config_.heading_sigma_deg * std::numbers::pi / 180;
  scatter_ = config_.correlation * sigma * sigma;
  roles_.assign(features.size(), FitRole::unused);
  tangents_.resize(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!considered(features[i])) continue;
    roles_[i] = FitRole::inlier;
    tangents_[i] = std::tan(features[i].heading);
  }
  std::optional<Eigen::Vector3d> shape = solve(features);
  for (int i = 0; i < config_.max_iterations; ++i) {
    if (!shape) return std::nullopt;
    const bool changed = cut_outliers(features, *shape);
    scatter_ = scatter(features, *shape);
    shape = solve(features);
    // Twice at least: the first fit did not know how much the data is worth against the prior, nor did its
    // scatter.
    if (!changed && i > 0) break;
  }
  if (!shape) return std::nullopt;
  scatter_ = scatter(features, *shape);
  return BaseClothoid{shaped(*shape), scatter_ * normal_.inverse()};
}

double BaseClothoidFit::scatter(std::span<const Feature> features, const Eigen::Vector3d& shape) const {
  double sum = kScatterFloor * kScatterFloor;
  double count = 1;
  double weight = 0;
  double correlation = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (roles_[i] != FitRole::inlier) continue;
    const double residual = tangents_[i] - slope_row(features[i].x).dot(shape);
    sum += features[i].confidence * residual * residual;
    ++count;
    const bool tracked = features[i].track_id != kNoTrack;
    weight += features[i].confidence;
    correlation += features[i].confidence * (tracked ? config_.track_correlation : config_.correlation);
  }
  return correlation / weight * sum / count;
}

std::optional<BaseClothoid> BaseClothoidFit::refine(std::span<const Feature> features,
                                                    std::span<const int> group, int groups) {
  assert(group.size() == features.size() && roles_.size() == features.size());
  const double heading_sigma = config_.heading_sigma_deg * std::numbers::pi / 180;
  // In units of one heading: a position counts (heading sigma / position sigma)^2.
  const double position_weight = std::pow(heading_sigma / config_.position_sigma, 2);
  Eigen::Matrix3d normal = prior_weights().asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  offsets_.assign(static_cast<std::size_t>(groups), OffsetTerms{});
  std::size_t count = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (roles_[i] == FitRole::unused) continue;
    const Feature& feature = features[i];
    if (roles_[i] == FitRole::inlier) {
      const Eigen::Vector3d row = slope_row(feature.x);
      normal += feature.confidence * row * row.transpose();
      right += feature.confidence * tangents_[i] * row;
    }
    if (group[i] < 0) continue;
    const Eigen::Vector3d row = position_row(feature.x);
    const double weight = feature.confidence * position_weight;
    OffsetTerms& offset = offsets_[static_cast<std::size_t>(group[i])];
    normal += weight * row * row.transpose();
    right += weight * feature.y * row;
    offset.course += weight * row;
    offset.weight += weight;
    offset.right += weight * feature.y;
    ++count;
  }
  if (count < config_.min_features) return std::nullopt;
  // No two offsets share a term, so each is eliminated by itself.
  for (const OffsetTerms& offset : offsets_) {
    const double weight = offset.weight + 1e-9;
    normal -= offset.course * offset.course.transpose() / weight;
    right -= offset.course * (offset.right / weight);
  }
  const Eigen::LDLT<Eigen::Matrix3d> factor(normal);
  const Eigen::Vector3d shape = factor.solve(right);
  return BaseClothoid{shaped(shape), scatter(features, shape) * factor.solve(Eigen::Matrix3d::Identity())};
}

}  // namespace lanefuse
