// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace lanefuse {

/// A normal distribution over N numbers: what every Kalman filter of the project carries.
template <int N>
struct Gaussian {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Identity();
};

/// A measurement's surprise: z - h(x) and its covariance S.
template <int M>
struct Innovation {
  Eigen::Matrix<double, M, 1> residual;
  Eigen::Matrix<double, M, M> covariance;

  /// Squared Mahalanobis distance, chi-square distributed with M degrees of freedom if all is well.
  [[nodiscard]] double distance_squared() const { return residual.dot(covariance.llt().solve(residual)); }
};

/// x <- F x, P <- F P F' + Q.
template <int N>
void predict(Gaussian<N>& state, const Eigen::Matrix<double, N, N>& transition,
             const Eigen::Matrix<double, N, N>& process_noise) {
  state.mean = transition * state.mean;
  state.covariance = transition * state.covariance * transition.transpose() + process_noise;
}

/// The innovation of `measurement` = H x + noise(R); for a nonlinear h pass the residual z - h(x) and H at x.
template <int N, int M>
Innovation<M> innovation(const Gaussian<N>& state, const Eigen::Matrix<double, M, 1>& residual,
                         const Eigen::Matrix<double, M, N>& jacobian,
                         const Eigen::Matrix<double, M, M>& noise) {
  return {residual, jacobian * state.covariance * jacobian.transpose() + noise};
}

/// Joseph's form keeps the covariance symmetric and positive, whatever the rounding.
template <int N, int M>
void update(Gaussian<N>& state, const Eigen::Matrix<double, M, 1>& residual,
            const Eigen::Matrix<double, M, N>& jacobian, const Eigen::Matrix<double, M, M>& noise) {
  using StateMatrix = Eigen::Matrix<double, N, N>;
  const Innovation<M> surprise = innovation<N, M>(state, residual, jacobian, noise);
  const Eigen::Matrix<double, N, M> gain =
      surprise.covariance.llt().solve(jacobian * state.covariance).transpose();
  state.mean += gain * residual;
  const StateMatrix keep = StateMatrix::Identity() - gain * jacobian;
  state.covariance = (keep * state.covariance * keep.transpose() + gain * noise * gain.transpose()).eval();
}

}  // namespace lanefuse
