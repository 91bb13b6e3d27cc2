// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/sparse_cholesky.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {

namespace {

using Lines = Eigen::Map<Eigen::MatrixXd>;

/// Panels up to this width are factored line by line: below it Eigen's own blocking does not pay.
constexpr std::size_t kWidestByLines = 24;
/// Multiplications from which on a product is left to Eigen.
constexpr std::size_t kLeastForProduct = 12 * 12 * 12;

/// target -= f * source
void subtract(double* __restrict target, const double* __restrict source, double f, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) target[i] -= f * source[i];
}

bool factor_by_lines(double* values, std::size_t height, std::size_t width) {
  for (std::size_t k = 0; k < width; ++k) {
    double* line = values + k * height;
    if (!(line[k] > 0)) return false;
    const double root = std::sqrt(line[k]);
    line[k] = root;
    for (std::size_t i = k + 1; i < height; ++i) line[i] /= root;
    for (std::size_t j = k + 1; j < width; ++j) {
      subtract(values + j * height + j, line + j, line[j], height - j);
    }
  }
  return true;
}

bool factor_by_blocks(double* values, Eigen::Index height, Eigen::Index width) {
  Lines panel(values, height, width);
  Eigen::Ref<Eigen::MatrixXd> own(panel.topRows(width));
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> factor(own);
  if (factor.info() != Eigen::Success) return false;
  auto below = panel.bottomRows(height - width);
  own.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
  return true;
}

bool factor_panel(double* values, std::size_t height, std::size_t width) {
  if (width <= kWidestByLines) return factor_by_lines(values, height, width);
  return factor_by_blocks(values, static_cast<Eigen::Index>(height), static_cast<Eigen::Index>(width));
}

}  // namespace

void SparseCholesky::prepare(const Supernodes& supernodes) {
  supernodes_ = &supernodes;
  values_.resize(supernodes.value_count());
}

bool SparseCholesky::factor() {
  for (const Panel& panel : supernodes_->panels()) {
    if (!factor_panel(&values_[panel.values], panel.height(), panel.width())) return false;
    update_later(panel);
  }
  return true;
}

void SparseCholesky::update_later(const Panel& panel) {
  const auto rows = supernodes_->rows(panel);
  for (std::uint32_t first = panel.columns, end = first; first < panel.count; first = end) {
    const std::uint32_t p = supernodes_->panel_of(rows[first]);
    while (end < panel.count && supernodes_->panel_of(rows[end]) == p) ++end;
    const Panel& target = supernodes_->panels()[p];
    find_runs(panel, first, target);
    const std::size_t row = 3 * std::size_t{first}, count = 3 * std::size_t{end - first};
    const bool is_small = (panel.height() - row) * count * panel.width() < kLeastForProduct;
    double* values = &values_[target.values];
    if (is_small) {
      subtract_directly(panel, row, count, values, target.height());
    } else {
      subtract_product(panel, row, count, values, target.height());
    }
  }
}

/// Where the rows of a panel, from the block `first` on, stand in a later panel.
void SparseCholesky::find_runs(const Panel& panel, std::uint32_t first, const Panel& target) {
  const auto from = supernodes_->rows(panel);
  const auto to = supernodes_->rows(target);
  runs_.clear();
  std::size_t place = from[first] - target.first;
  for (std::size_t i = first; i < panel.count; ++i, ++place) {
    const bool goes_on = i > first && to[place] == from[i];
    while (to[place] != from[i]) ++place;
    if (goes_on) {
      runs_.back().length += 3;
    } else {
      runs_.push_back({3 * i, 3 * place, 3});
    }
  }
}

/// Subtracts what the panel's scalar rows from `row` on and its `rows` rows there make of each other: each of
/// those rows is a scalar column of the target. The first run holds them, the upper triangle is never read.
void SparseCholesky::subtract_directly(const Panel& panel, std::size_t row, std::size_t rows, double* target,
                                       std::size_t stride) {
  const double* source = &values_[panel.values];
  const std::size_t height = panel.height();
  std::size_t run = 0;
  for (std::size_t c = 0; c < rows; ++c) {
    while (row + c >= runs_[run].source + runs_[run].length) ++run;
    double* line = target + (runs_[run].target + row + c - runs_[run].source) * stride;
    for (std::size_t r = run; r < runs_.size(); ++r) {
      const Run& part = runs_[r];
      double* __restrict to = line + part.target;
      for (std::size_t k = 0; k < panel.width(); k += 3) {
        const double* __restrict y0 = source + k * height + part.source;
        const double* __restrict y1 = y0 + height;
        const double* __restrict y2 = y1 + height;
        const double* own = source + k * height + row + c;
        const double a0 = own[0], a1 = own[height], a2 = own[2 * height];
        for (std::size_t i = 0; i < part.length; ++i) to[i] -= y0[i] * a0 + y1[i] * a1 + y2[i] * a2;
      }
    }
  }
}

/// The same by way of a dense product, for larger pieces.
void SparseCholesky::subtract_product(const Panel& panel, std::size_t row, std::size_t rows, double* target,
                                      std::size_t stride) {
  const std::size_t height = panel.height() - row;
  if (product_.size() < height * rows) product_.resize(height * rows);
  const Eigen::Map<const Eigen::MatrixXd> lines(&values_[panel.values],
                                                static_cast<Eigen::Index>(panel.height()),
                                                static_cast<Eigen::Index>(panel.width()));
  const auto below = lines.bottomRows(static_cast<Eigen::Index>(height));
  Lines product(product_.data(), static_cast<Eigen::Index>(height), static_cast<Eigen::Index>(rows));
  product.noalias() = below * below.topRows(static_cast<Eigen::Index>(rows)).transpose();
  std::size_t run = 0;
  for (std::size_t c = 0; c < rows; ++c) {
    while (row + c >= runs_[run].source + runs_[run].length) ++run;
    double* line = target + (runs_[run].target + row + c - runs_[run].source) * stride;
    for (std::size_t r = run; r < runs_.size(); ++r) {
      subtract(line + runs_[r].target, product_.data() + c * height + runs_[r].source - row, 1,
               runs_[r].length);
    }
  }
}

Eigen::Matrix3d SparseCholesky::own_block(std::uint32_t turn) const {
  const Panel& panel = supernodes_->panels()[supernodes_->panel_of(turn)];
  const double* values = &values_[panel.values + 3 * (turn - panel.first) * (panel.height() + 1)];
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = c; r < 3; ++r) {
      own(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = values[c * panel.height() + r];
    }
  }
  return own;
}

void SparseCholesky::solve(Eigen::VectorXd& x) const {
  const auto& panels = supernodes_->panels();
  for (const Panel& panel : panels) {
    const auto rows = supernodes_->rows(panel);
    const double* line = &values_[panel.values];
    double* own = x.data() + 3 * panel.first;
    for (std::size_t k = 0; k < panel.width(); ++k, line += panel.height()) {
      own[k] /= line[k];
      subtract(own + k + 1, line + k + 1, own[k], panel.width() - k - 1);
      for (std::size_t i = panel.columns; i < panel.count; ++i) {
        for (std::size_t r = 0; r < 3; ++r) x[3 * rows[i] + r] -= line[3 * i + r] * own[k];
      }
    }
  }
  for (std::size_t p = panels.size(); p-- > 0;) {
    const Panel& panel = panels[p];
    const auto rows = supernodes_->rows(panel);
    double* own = x.data() + 3 * panel.first;
    for (std::size_t k = panel.width(); k-- > 0;) {
      const double* line = &values_[panel.values + k * panel.height()];
      double sum = own[k];
      for (std::size_t i = k + 1; i < panel.width(); ++i) sum -= line[i] * own[i];
      for (std::size_t i = panel.columns; i < panel.count; ++i) {
        for (std::size_t r = 0; r < 3; ++r) sum -= line[3 * i + r] * x[3 * rows[i] + r];
      }
      own[k] = sum / line[k];
    }
  }
}

}  // namespace lanefuse
