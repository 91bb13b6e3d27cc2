// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/gaussian_state.hpp"

namespace lanefuse {

int GaussianState::append(double mean, double variance) {
  assert(has_room(1));
  const int i = size_++;
  covariance_.col(i).head(size_).setZero();
  covariance_.row(i).head(size_).setZero();
  covariance_(i, i) = variance;
  mean_[i] = mean;
  return i;
}

int GaussianState::append(const SparseRow& from, double offset, double noise) {
  assert(has_room(1));
  const int i = size_;
  Vector column;
  project(from, column);
  double mean = offset;
  double own = noise;
  for (const auto& [index, value] : from) {
    mean += value * mean_[index];
    own += value * column[index];
  }
  covariance_.col(i).head(i) = column;
  covariance_.row(i).head(i) = column.transpose();
  covariance_(i, i) = own;
  mean_[i] = mean;
  ++size_;
  return i;
}

void GaussianState::remove(int first, int count) {
  const int rest = size_ - first - count;
  for (int k = 0; k < rest; ++k) {
    mean_[first + k] = mean_[first + count + k];
    covariance_.col(first + k).head(size_) = covariance_.col(first + count + k).head(size_);
  }
  for (int k = 0; k < rest; ++k) {
    covariance_.row(first + k).head(size_ - count) = covariance_.row(first + count + k).head(size_ - count);
  }
  size_ -= count;
}

void GaussianState::shift(int first, int count, const SparseRow& from, double noise) {
  for (int k = first; k + 1 < first + count; ++k) {
    mean_[k] = mean_[k + 1];
    covariance_.col(k).head(size_) = covariance_.col(k + 1).head(size_);
  }
  for (int k = first; k + 1 < first + count; ++k) {
    covariance_.row(k).head(size_) = covariance_.row(k + 1).head(size_);
  }
  const int last = first + count - 1;
  Vector column;
  project(from, column);
  double mean = 0;
  double own = noise;
  for (const auto& [index, value] : from) {
    assert(index != last);
    mean += value * mean_[index];
    own += value * column[index];
  }
  column[last] = own;
  covariance_.col(last).head(size_) = column;
  covariance_.row(last).head(size_) = column.transpose();
  mean_[last] = mean;
}

void GaussianState::decay(int i, double keep, double sigma) {
  mean_[i] *= keep;
  covariance_.col(i).head(size_) *= keep;
  covariance_.row(i).head(size_) *= keep;
  covariance_(i, i) += (1 - keep * keep) * sigma * sigma;
}

/// The same sums in the same order on both sides of the diagonal: it stays symmetric to the last bit.
void GaussianState::transform(int first, int count, const SparseRow& change, double mean_change) {
  Vector sum;
  project(change, sum);
  double own = 0;
  for (const auto& [index, value] : change) own += value * sum[index];
  for (int i = first; i < first + count; ++i) {
    covariance_.col(i).head(size_) += sum;
    covariance_.row(i).head(size_) += sum.transpose();
    mean_[i] += mean_change;
  }
  covariance_.block(first, first, count, count).array() += own;
}

void GaussianState::project(const SparseRow& row, Vector& out) const {
  out.setZero(size_);
  for (const auto& [index, value] : row) out += value * covariance_.col(index).head(size_);
}

double GaussianState::variance(const SparseRow& row) const { return covariance(row, row); }

double GaussianState::covariance(const SparseRow& a, const SparseRow& b) const {
  double sum = 0;
  for (const auto& [i, u] : a) {
    for (const auto& [j, v] : b) sum += u * v * covariance_(i, j);
  }
  return sum;
}

void GaussianState::update(const SparseRow& row, double residual, double noise) {
  Vector projected;
  project(row, projected);
  double variance = noise;
  for (const auto& [index, value] : row) variance += value * projected[index];
  update_projected(projected, residual, variance);
}

GaussianState::Vector GaussianState::update(const Vector& row, double residual, double noise) {
  const Vector projected = times(row);
  const double variance = row.dot(projected) + noise;
  update_projected(projected, residual, variance);
  return projected * (residual / variance);
}

/// u_i u_j is u_j u_i to the last bit: the covariance stays symmetric without being made so.
void GaussianState::update_projected(const Vector& projected, double residual, double innovation_variance) {
  assert(innovation_variance > 0);
  const double root = std::sqrt(innovation_variance);
  const Vector scaled = projected / root;
  mean_.head(size_) += scaled * (residual / root);
  for (int j = 0; j < size_; ++j) covariance_.col(j).head(size_) -= scaled[j] * scaled;
}

}  // namespace lanefuse
