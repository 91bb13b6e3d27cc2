// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "road/gaussian_state.hpp"

namespace lanefuse::testing {

/// The same numbers by the textbook: each operation is a new state F x + m with covariance F P F' + Q.
struct Dense {
  Eigen::VectorXd mean = Eigen::VectorXd(0);
  Eigen::MatrixXd covariance = Eigen::MatrixXd(0, 0);

  [[nodiscard]] int size() const { return static_cast<int>(mean.size()); }
  [[nodiscard]] Eigen::MatrixXd identity() const { return Eigen::MatrixXd::Identity(size(), size()); }
  [[nodiscard]] Eigen::VectorXd vector_of(const SparseRow& row) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(size());
    for (const auto& [index, value] : row) result[index] += value;
    return result;
  }
  void map(const Eigen::MatrixXd& by) {
    mean = (by * mean).eval();
    covariance = (by * covariance * by.transpose()).eval();
  }
  void append(const Eigen::VectorXd& from, double offset, double noise) {
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(size() + 1, size());
    by.topRows(size()) = identity();
    by.bottomRows(1) = from.transpose();
    map(by);
    mean[size() - 1] += offset;
    covariance(size() - 1, size() - 1) += noise;
  }
  void remove(int first, int count) {
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(size() - count, size());
    by.topLeftCorner(first, first).setIdentity();
    by.bottomRightCorner(size() - first - count, size() - first - count).setIdentity();
    map(by);
  }
  void shift(int first, int count, const SparseRow& from, double noise) {
    Eigen::MatrixXd move = identity();
    for (int k = first; k + 1 < first + count; ++k) move.row(k) = identity().row(k + 1);
    map(move);
    Eigen::MatrixXd last = identity();
    last.row(first + count - 1) = vector_of(from).transpose();
    map(last);
    covariance(first + count - 1, first + count - 1) += noise;
  }
  void transform(int first, int count, const SparseRow& change, double mean_change) {
    Eigen::MatrixXd by = identity();
    for (int i = first; i < first + count; ++i) by.row(i) += vector_of(change).transpose();
    covariance = (by * covariance * by.transpose()).eval();
    mean.segment(first, count).array() += mean_change;
  }
  void decay(int i, double keep, double sigma) {
    Eigen::MatrixXd by = identity();
    by(i, i) = keep;
    map(by);
    covariance(i, i) += (1 - keep * keep) * sigma * sigma;
  }
  void update(const Eigen::VectorXd& row, double residual, double noise) {
    const double variance = row.dot(covariance * row) + noise;
    const Eigen::VectorXd gain = covariance * row / variance;
    mean += gain * residual;
    covariance = ((identity() - gain * row.transpose()) * covariance).eval();
  }
};

}  // namespace lanefuse::testing
