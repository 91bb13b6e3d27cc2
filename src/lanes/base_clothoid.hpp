// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/clothoid.hpp"
#include "core/feature.hpp"
#include "lanes/lane_model_config.hpp"

namespace lanefuse {

/// What became of a feature in the fit.
enum class FitRole : char { unused = 0, inlier = 1, outlier = 2 };

/// The road's course: theta0, c0, c1 of the base clothoid; its lateral offset is 0.
struct BaseClothoid {
  Clothoid clothoid;
  /// of (theta0, c0, c1)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// Fits the base clothoid to the headings of the fused features by robust weighted linear least squares
/// [IROS16, sec. II-F]: theta0, c0 and c1 are linear in the *tangent* of the heading, the derivative of
/// eq. 11. The features' confidences are the weights; residuals far outside the median are cut, and the fit
/// is repeated until no feature changes sides.
class BaseClothoidFit {
 public:
  explicit BaseClothoidFit(const BaseClothoidConfig& config) : config_(config) {}

  /// Nothing where too few features are left. `roles()` tells what became of each.
  std::optional<BaseClothoid> fit(std::span<const Feature> features);

  /// Fits headings and positions together: feature i lies on boundary `group[i]` (0 .. groups-1), or on none
  /// (-1). Better than headings alone, since a position error does not grow with the distance; not the
  /// paper's. Starts from the inliers of the last fit().
  std::optional<BaseClothoid> refine(std::span<const Feature> features, std::span<const int> group,
                                     int groups);

  [[nodiscard]] std::span<const FitRole> roles() const { return roles_; }

 private:
  [[nodiscard]] bool considered(const Feature& feature) const;
  [[nodiscard]] Eigen::Vector3d prior_weights() const;
  std::optional<Eigen::Vector3d> solve(std::span<const Feature> features);
  /// Variance of a fully confident feature's slope about the fit, times the features that count as one.
  [[nodiscard]] double scatter(std::span<const Feature> features, const Eigen::Vector3d& shape) const;
  bool cut_outliers(std::span<const Feature> features, const Eigen::Vector3d& shape);

  const BaseClothoidConfig& config_;
  std::vector<FitRole> roles_;
  std::vector<double> tangents_;  ///< of the headings of the features considered
  /// What ties a boundary's offset to the course in the joint fit.
  struct OffsetTerms {
    Eigen::Vector3d course = Eigen::Vector3d::Zero();
    double weight = 0;
    double right = 0;
  };
  std::vector<double> residuals_;
  std::vector<double> sorted_;        ///< scratch
  std::vector<OffsetTerms> offsets_;  ///< scratch: by group
  double scatter_ = 0;                ///< of the current fit; weighs the data against the prior
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
};

}  // namespace lanefuse
