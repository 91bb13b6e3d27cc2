// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/gaussian_state.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The same numbers by the textbook: each operation is a new state F x + m with covariance F P F' + Q.
struct Dense {
  VectorXd mean = VectorXd(0);
  MatrixXd covariance = MatrixXd(0, 0);

  [[nodiscard]] int size() const { return static_cast<int>(mean.size()); }
  [[nodiscard]] MatrixXd identity() const { return MatrixXd::Identity(size(), size()); }
  [[nodiscard]] VectorXd vector_of(const SparseRow& row) const {
    VectorXd result = VectorXd::Zero(size());
    for (const auto& [index, value] : row) result[index] += value;
    return result;
  }
  void map(const MatrixXd& by) {
    mean = (by * mean).eval();
    covariance = (by * covariance * by.transpose()).eval();
  }
  void append(const VectorXd& from, double offset, double noise) {
    MatrixXd by = MatrixXd::Zero(size() + 1, size());
    by.topRows(size()) = identity();
    by.bottomRows(1) = from.transpose();
    map(by);
    mean[size() - 1] += offset;
    covariance(size() - 1, size() - 1) += noise;
  }
  void remove(int first, int count) {
    MatrixXd by = MatrixXd::Zero(size() - count, size());
    by.topLeftCorner(first, first).setIdentity();
    by.bottomRightCorner(size() - first - count, size() - first - count).setIdentity();
    map(by);
  }
  void shift(int first, int count, const SparseRow& from, double noise) {
    MatrixXd move = identity();
    for (int k = first; k + 1 < first + count; ++k) move.row(k) = identity().row(k + 1);
    map(move);
    MatrixXd last = identity();
    last.row(first + count - 1) = vector_of(from).transpose();
    map(last);
    covariance(first + count - 1, first + count - 1) += noise;
  }
  void transform(int first, int count, const SparseRow& change, double mean_change) {
    MatrixXd by = identity();
    for (int i = first; i < first + count; ++i) by.row(i) += vector_of(change).transpose();
    covariance = (by * covariance * by.transpose()).eval();
    mean.segment(first, count).array() += mean_change;
  }
  void decay(int i, double keep, double sigma) {
    MatrixXd by = identity();
    by(i, i) = keep;
    map(by);
    covariance(i, i) += (1 - keep * keep) * sigma * sigma;
  }
  void update(const VectorXd& row, double residual, double noise) {
    const double variance = row.dot(covariance * row) + noise;
    const VectorXd gain = covariance * row / variance;
    mean += gain * residual;
    covariance = ((identity() - gain * row.transpose()) * covariance).eval();
  }
};

/// Does everything to both, by dice.
class Twins {
 public:
  explicit Twins(std::uint64_t seed) : random_(seed, "twins") {
    for (int i = 0; i < 8; ++i) append();
  }

  void append() {
    const double mean = random_.normal(1);
    const double variance = random_.uniform(0.1, 2);
    state_.append(mean, variance);
    dense_.append(VectorXd::Zero(dense_.size()), mean, variance);
  }
  void append_from_row() {
    const SparseRow row = any_row();
    const double offset = random_.normal(1);
    const double noise = random_.uniform(0.01, 1);
    state_.append(row, offset, noise);
    dense_.append(dense_.vector_of(row), offset, noise);
  }
  void remove() {
    if (state_.size() < 10) return;
    const int count = random_.whole(1, 3);
    const int first = random_.whole(0, state_.size() - count);
    state_.remove(first, count);
    dense_.remove(first, count);
  }
  void shift() {
    const int count = random_.whole(2, 5);
    const int first = random_.whole(0, state_.size() - count);
    const SparseRow row = row_without(first + count - 1, 1);
    const double noise = random_.uniform(0.01, 1);
    state_.shift(first, count, row, noise);
    dense_.shift(first, count, row, noise);
  }
  void transform() {
    const int count = random_.whole(1, 4);
    const int first = random_.whole(0, state_.size() - count);
    const SparseRow row = row_without(first, count);
    const double mean_change = random_.normal(1);
    state_.transform(first, count, row, mean_change);
    dense_.transform(first, count, row, mean_change);
  }
  void decay() {
    const int i = random_.whole(0, state_.size() - 1);
    const double keep = random_.uniform(0.5, 1);
    state_.decay(i, keep, 0.8);
    dense_.decay(i, keep, 0.8);
  }
  void add_noise() {
    const int count = random_.whole(1, 4);
    const int first = random_.whole(0, state_.size() - count);
    state_.add_shared_noise(first, count, 0.1);
    dense_.covariance.block(first, first, count, count).array() += 0.1;
    state_.add_noise(first, 0.2);
    dense_.covariance(first, first) += 0.2;
  }
  void update() {
    const SparseRow row = any_row();
    const double residual = random_.normal(1);
    const double noise = random_.uniform(0.05, 1);
    state_.update(row, residual, noise);
    dense_.update(dense_.vector_of(row), residual, noise);
  }
  void update_with_a_full_row() {
    GaussianState::Vector row(state_.size());
    for (double& entry : row) entry = random_.normal(0.5);
    const VectorXd before = dense_.mean;
    const GaussianState::Vector moved = state_.update(row, 0.7, 0.3);
    dense_.update(row, 0.7, 0.3);
    EXPECT_LT((moved - (dense_.mean - before)).norm(), 1e-9);
  }

  void anything() {
    const int what = random_.whole(0, 11);
    if (state_.size() < 8 || (what == 0 && state_.has_room(1))) return append();
    if (what == 1 && state_.has_room(1)) return append_from_row();
    if (what == 2 || !state_.has_room(8)) return remove();
    if (what == 3) return shift();
    if (what == 4) return transform();
    if (what == 5) return decay();
    if (what == 6) return add_noise();
    if (what == 7) return update_with_a_full_row();
    update();
  }

  void expect_same() const {
    ASSERT_EQ(state_.size(), dense_.size());
    const double scale = 1 + dense_.covariance.cwiseAbs().maxCoeff();
    for (int i = 0; i < state_.size(); ++i) {
      ASSERT_NEAR(state_.mean(i), dense_.mean[i], 1e-8 * (1 + dense_.mean.cwiseAbs().maxCoeff()));
      for (int j = 0; j < state_.size(); ++j) {
        ASSERT_NEAR(state_.covariance(i, j), dense_.covariance(i, j), 1e-8 * scale) << i << ' ' << j;
      }
    }
  }
  void expect_symmetric() const {
    for (int i = 0; i < state_.size(); ++i) {
      for (int j = 0; j < i; ++j)
        ASSERT_EQ(state_.covariance(i, j), state_.covariance(j, i)) << i << ' ' << j;
    }
  }
  void expect_positive_definite() const {
    MatrixXd covariance(state_.size(), state_.size());
    for (int i = 0; i < state_.size(); ++i) {
      for (int j = 0; j < state_.size(); ++j) covariance(i, j) = state_.covariance(i, j);
    }
    EXPECT_GT(covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
  }

  [[nodiscard]] const GaussianState& state() const { return state_; }
  [[nodiscard]] const Dense& dense() const { return dense_; }
  SparseRow any_row() { return row_without(0, 0); }

 private:
  /// A row of some entries, none of them in [first, first + count).
  SparseRow row_without(int first, int count) {
    SparseRow row;
    for (int k = 0; k < 4; ++k) {
      const int index = random_.whole(0, state_.size() - 1);
      if (index < first || index >= first + count) row.add(index, random_.normal(0.4));
    }
    return row;
  }

  Random random_;
  GaussianState state_;
  Dense dense_;
};

class GaussianStateAlgebra : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Twins twins_{GetParam()};
};

TEST_P(GaussianStateAlgebra, EachOperationIsThatOfTheTextbook) {
  for (int round = 0; round < 20; ++round) {
    for (auto operation :
         {&Twins::append, &Twins::append_from_row, &Twins::update, &Twins::shift, &Twins::transform,
          &Twins::decay, &Twins::add_noise, &Twins::remove, &Twins::update_with_a_full_row}) {
      (twins_.*operation)();
      twins_.expect_same();
    }
  }
}

TEST_P(GaussianStateAlgebra, AThousandOperationsLeaveItSymmetricAndPositiveDefinite) {
  for (int i = 0; i < 1000; ++i) {
    twins_.anything();
    twins_.expect_symmetric();
    if (::testing::Test::HasFatalFailure()) return;
  }
  twins_.expect_same();
  twins_.expect_positive_definite();
}

TEST_P(GaussianStateAlgebra, ProjectionsAreThoseOfTheFullMatrix) {
  for (int i = 0; i < 30; ++i) twins_.anything();
  const SparseRow a = twins_.any_row();
  const SparseRow b = twins_.any_row();
  const VectorXd full_a = twins_.dense().vector_of(a);
  const VectorXd full_b = twins_.dense().vector_of(b);
  const MatrixXd& covariance = twins_.dense().covariance;
  GaussianState::Vector projected;
  twins_.state().project(a, projected);
  EXPECT_LT((projected - covariance * full_a).norm(), 1e-8);
  EXPECT_LT((twins_.state().times(full_a) - covariance * full_a).norm(), 1e-8);
  EXPECT_NEAR(twins_.state().variance(a), full_a.dot(covariance * full_a), 1e-8);
  EXPECT_NEAR(twins_.state().covariance(a, b), full_a.dot(covariance * full_b), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GaussianStateAlgebra, ::testing::Range<std::uint64_t>(1, 9));

TEST(GaussianState, HasRoomForWhatItsCapacityHolds) {
  GaussianState state;
  EXPECT_TRUE(state.has_room(GaussianState::kCapacity));
  EXPECT_FALSE(state.has_room(GaussianState::kCapacity + 1));
  for (int i = 0; i < GaussianState::kCapacity; ++i) EXPECT_EQ(state.append(i, 1), i);
  EXPECT_TRUE(state.has_room(0));
  EXPECT_FALSE(state.has_room(1));
  state.remove(3, 2);
  EXPECT_TRUE(state.has_room(2));
  EXPECT_EQ(state.mean(3), 5);
  state.clear();
  EXPECT_TRUE(state.has_room(GaussianState::kCapacity));
}

TEST(GaussianState, ANewNumberIsIndependentOfWhatStoodInItsPlace) {
  GaussianState state;
  state.append(1, 1);
  SparseRow same;
  same.add(0, 1);
  state.append(same, 0, 0.1);
  EXPECT_GT(state.covariance(0, 1), 0.9);
  state.remove(1, 1);
  state.append(2, 3);
  EXPECT_EQ(state.covariance(0, 1), 0);
  EXPECT_EQ(state.variance(1), 3);
}

TEST(SparseRow, EntriesOfOneIndexAddUp) {
  SparseRow row;
  row.add(2, 1.5);
  row.add(2, 0.5);
  row.add(1, 0);
  EXPECT_EQ(std::distance(row.begin(), row.end()), 2) << "zeros take no place";
  row.scale(2);
  GaussianState state;
  for (int i = 0; i < 3; ++i) state.append(0, 1);
  EXPECT_DOUBLE_EQ(state.variance(row), 16);
}

}  // namespace
}  // namespace lanefuse
