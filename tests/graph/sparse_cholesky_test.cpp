// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/sparse_cholesky.hpp"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace lanefuse {
namespace {

/// A symmetric positive definite matrix of 3x3 blocks, in which those blocks that are neighbours are not
/// zero.
struct BlockMatrix {
  std::vector<std::vector<std::uint32_t>> neighbours;
  Eigen::MatrixXd numbers;
};

BlockMatrix make_matrix(unsigned seed, std::uint32_t blocks, std::uint32_t ties) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  const auto any_block = [&] { return static_cast<std::uint32_t>(random() % blocks); };
  BlockMatrix matrix{std::vector<std::vector<std::uint32_t>>(blocks),
                     Eigen::MatrixXd::Zero(3 * blocks, 3 * blocks)};
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    matrix.neighbours[a].push_back(b);
    matrix.neighbours[b].push_back(a);
    Eigen::Matrix3d block;
    for (int i = 0; i < 9; ++i) block(i / 3, i % 3) = number();
    matrix.numbers.block<3, 3>(3 * a, 3 * b) = block;
    matrix.numbers.block<3, 3>(3 * b, 3 * a) = block.transpose();
  };
  for (std::uint32_t i = 0; i + 1 < blocks; ++i) join(i, i + 1);
  for (std::uint32_t i = 0; i < ties; ++i) join(any_block(), any_block());
  matrix.numbers.diagonal() = matrix.numbers.cwiseAbs().rowwise().sum().array() + 0.1;
  return matrix;
}

void fill(SparseCholesky& factor, const Supernodes& shape, const BlockMatrix& matrix) {
  std::fill(factor.values().begin(), factor.values().end(), 0.0);
  for (std::uint32_t a = 0; a < matrix.neighbours.size(); ++a) {
    for (std::uint32_t b = 0; b < matrix.neighbours.size(); ++b) {
      const Eigen::Matrix3d block = matrix.numbers.block<3, 3>(3 * a, 3 * b);
      const std::uint32_t row = shape.turns()[a], column = shape.turns()[b];
      if (row < column || block.isZero(0)) continue;
      const std::size_t place = shape.locate(row, column);
      const std::size_t stride = shape.panels()[shape.panel_of(column)].height();
      for (std::size_t i = 0; i < 9; ++i) {
        factor.values()[place + i / 3 * stride + i % 3] =
            block(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3));
      }
    }
  }
}

TEST(SparseCholesky, SolvesWhatADenseFactorisationSolves) {
  // From a chain to a matrix whose factor is all but full; the last is wide enough for products of panels.
  const std::pair<std::uint32_t, std::uint32_t> shapes[] = {{1, 0}, {2, 0}, {40, 0}, {60, 30}, {120, 400}};
  for (const auto& [blocks, ties] : shapes) {
    SCOPED_TRACE(blocks);
    const BlockMatrix matrix = make_matrix(blocks, blocks, ties);
    Supernodes shape;
    shape.analyse(matrix.neighbours);
    SparseCholesky factor;
    factor.prepare(shape);
    for (int repeat = 0; repeat < 2; ++repeat) {  // numbers of an earlier factorisation must not matter
      fill(factor, shape, matrix);
      ASSERT_TRUE(factor.factor());
    }
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(3 * blocks, -1, 2);
    const Eigen::VectorXd rhs = matrix.numbers * expected;
    Eigen::VectorXd x(rhs.size());
    for (std::uint32_t b = 0; b < blocks; ++b) x.segment<3>(3 * shape.turns()[b]) = rhs.segment<3>(3 * b);
    factor.solve(x);
    for (std::uint32_t b = 0; b < blocks; ++b) {
      EXPECT_TRUE(x.segment<3>(3 * shape.turns()[b]).isApprox(expected.segment<3>(3 * b), 1e-9)) << b;
    }
  }
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
  BlockMatrix matrix = make_matrix(5, 50, 20);
  matrix.numbers(30, 30) = -1;
  Supernodes shape;
  shape.analyse(matrix.neighbours);
  SparseCholesky factor;
  factor.prepare(shape);
  fill(factor, shape, matrix);
  EXPECT_FALSE(factor.factor());
}

TEST(Supernodes, AChainFillsLittle) {
  const BlockMatrix chain = make_matrix(6, 1000, 0);
  Supernodes shape;
  shape.analyse(chain.neighbours);
  EXPECT_LT(shape.value_count(), 9U * 6 * 1000);
}

}  // namespace
}  // namespace lanefuse
