// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Core>

namespace lanefuse {

/// One line of a Jacobian with few entries that are not zero.
class SparseRow {
 public:
  struct Entry {
    int index;
    double value;
  };

  void add(int index, double value) {
    assert(size_ < kCapacity);
    if (value != 0) entries_[static_cast<std::size_t>(size_++)] = {index, value};
  }
  void scale(double factor) {
    for (int i = 0; i < size_; ++i) entries_[static_cast<std::size_t>(i)].value *= factor;
  }
  [[nodiscard]] const Entry* begin() const { return entries_.data(); }
  [[nodiscard]] const Entry* end() const { return entries_.data() + size_; }

 private:
  static constexpr int kCapacity = 48;
  std::array<Entry, kCapacity> entries_{};
  int size_ = 0;
};

/// A normal distribution over numbers that come and go: mean and covariance in one place, without allocation.
class GaussianState {
 public:
  static constexpr int kCapacity = 96;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kCapacity, 1>;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool has_room(int count) const { return size_ + count <= kCapacity; }
  [[nodiscard]] double mean(int i) const { return mean_[i]; }
  void set_mean(int i, double value) { mean_[i] = value; }
  [[nodiscard]] double covariance(int i, int j) const { return covariance_(i, j); }
  [[nodiscard]] double variance(int i) const { return covariance_(i, i); }

  /// Appends a number that nothing else tells of; gives its index.
  int append(double mean, double variance);
  /// Appends `from` . state + offset + noise; gives its index.
  int append(const SparseRow& from, double offset, double noise);
  /// Takes `count` numbers out; those behind move up.
  void remove(int first, int count);
  /// In [first, first + count) every number takes the place before it; the last becomes `from` . state +
  /// noise, where `from` speaks of the places as they are after the move.
  void shift(int first, int count, const SparseRow& from, double noise);

  void add_noise(int i, double variance) { covariance_(i, i) += variance; }
  /// Noise that the numbers of [first, first + count) share.
  void add_shared_noise(int first, int count, double variance) {
    covariance_.block(first, first, count, count).array() += variance;
  }
  /// One step of an error that wanders about zero and forgets itself by `keep`.
  void decay(int i, double keep, double sigma);

  /// Row i becomes itself plus `change` . state, in mean and covariance, for every i in [first, first +
  /// count). `change` must not name any of them but, where count is 1, i itself.
  void transform(int first, int count, const SparseRow& change, double mean_change);

  /// covariance * row.
  void project(const SparseRow& row, Vector& out) const;
  [[nodiscard]] double variance(const SparseRow& row) const;
  [[nodiscard]] double covariance(const SparseRow& a, const SparseRow& b) const;

  /// Takes in a measurement with the prediction's error `residual` (measured minus predicted), whose Jacobian
  /// is `row`.
  void update(const SparseRow& row, double residual, double noise);
  /// The same with covariance * row and the innovation's variance already known.
  void update_projected(const Vector& projected, double residual, double innovation_variance);
  /// The same for a row with many entries; gives by how much the mean moved.
  Vector update(const Vector& row, double residual, double noise);
  /// covariance * row.
  [[nodiscard]] Vector times(const Vector& row) const {
    return covariance_.topLeftCorner(size_, size_) * row;
  }

  void clear() { size_ = 0; }

 private:
  int size_ = 0;
  Eigen::Matrix<double, kCapacity, 1> mean_;
  Eigen::Matrix<double, kCapacity, kCapacity> covariance_;
};

}  // namespace lanefuse
