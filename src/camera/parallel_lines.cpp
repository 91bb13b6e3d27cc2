// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/parallel_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

constexpr double kRanges[] = {30, 50, 75, 100, 1000};  ///< [m] what is near is believed first
constexpr double kDoubts[] = {5, 3, 2, 1, 1};          ///< how much wider the outliers' scale is at first
constexpr double kPlaceSigma = 0.06;                   ///< [m] by which real lines are not parallel
constexpr double kSlopeSigma = 0.004;                  ///< [rad]
constexpr double kLanesWithin = 7;                     ///< [m] to either side
constexpr double kLengthMost = 5;                      ///< [m] of one piece that count

/// Geman and McClure's weight: what is far off hardly draws, however much of it there is.
double trust(double residual, double sigma) {
  const double r = residual / sigma;
  const double w = 1 / (1 + r * r / 9);
  return w * w;
}

/// Lanes are around the car; what is far aside is more often a wall, a fence or a field. What points at the
/// camera is more often a post or a car's side than paint.
double weight_of(const LinePiece& piece) {
  const double aside = piece.y / kLanesWithin;
  const double upright = piece.y / piece.x;
  const bool points_here =
      std::abs(upright) > 0.06 && std::abs(piece.slope - upright) < 0.3 * std::abs(upright);
  return std::min(piece.length, kLengthMost) / (1 + aside * aside) * (points_here ? 0.1 : 1);
}

/// Normal equations of a few unknowns with a prior around zero.
struct Normal {
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  explicit Normal(const Eigen::Vector4d& prior) : a(prior.array().square().inverse().matrix().asDiagonal()) {}
  void add(const Eigen::Vector4d& row, double value, double weight) {
    a.noalias() += weight * row * row.transpose();
    b.noalias() += weight * value * row;
  }
  [[nodiscard]] Eigen::Vector4d solve() const { return a.ldlt().solve(b); }
};

}  // namespace

double ParallelLines::course(double x) const {
  return x * (shape_[0] + x * (shape_[1] / 2 + x * shape_[2] / 6));
}

double ParallelLines::offset(double x, double y) const { return y / (1 + shape_[3] * x) - course(x); }

double ParallelLines::slope(double x, double y) const {
  const double f = 1 + shape_[3] * x;
  return f * (shape_[0] + x * (shape_[1] + x * shape_[2] / 2)) + shape_[3] * y / f;
}

const ParallelLines::Line* ParallelLines::nearest(double offset, double reach) const {
  const Line* best = nullptr;
  for (const Line& line : lines_) {
    const double off = std::abs(line.offset - offset);
    if (off < reach) {
      reach = off;
      best = &line;
    }
  }
  return best;
}

/// The shape from the pieces' directions alone: no one needs to know yet which piece belongs to which line.
void ParallelLines::fit_slopes(std::span<const LinePiece> pieces, double range, double doubt,
                               const Eigen::Vector4d& prior) {
  Normal normal(prior);
  for (const LinePiece& piece : pieces) {
    if (piece.x > range) continue;
    const double sigma = std::hypot(piece.slope_sigma, kSlopeSigma);
    const double residual = piece.slope - slope(piece.x, piece.y);
    const double weight = weight_of(piece) * trust(residual, doubt * sigma) / (sigma * sigma);
    normal.add({1, piece.x, piece.x * piece.x / 2, piece.y}, piece.slope, weight);
  }
  shape_ = normal.solve();
}

/// Pieces of nearly the same offset are one line.
void ParallelLines::gather(std::span<const LinePiece> pieces, double range) {
  lines_.clear();
  order_.clear();
  offsets_.resize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].x > range) continue;
    offsets_[i] = offset(pieces[i].x, pieces[i].y);
    order_.push_back(i);
  }
  std::sort(order_.begin(), order_.end(), [this](std::size_t a, std::size_t b) {
    return offsets_[a] != offsets_[b] ? offsets_[a] < offsets_[b] : a < b;
  });
  double weights = 0;
  double last = 0;
  for (const std::size_t i : order_) {
    const LinePiece& piece = pieces[i];
    const double near_weight = weight_of(piece) / (1 + piece.x / 20);
    if (lines_.empty() || offsets_[i] - last > config_.line_spacing) {
      lines_.push_back({offsets_[i], 0, piece.x, piece.x});
      weights = 0;
    }
    Line& line = lines_.back();
    weights += near_weight;
    line.offset += (offsets_[i] - line.offset) * near_weight / weights;
    line.length += piece.length;
    line.nearest = std::min(line.nearest, piece.x);
    line.farthest = std::max(line.farthest, piece.x);
    last = offsets_[i];
  }
}

/// The shape from places and directions, the lines' offsets given.
void ParallelLines::fit_places(std::span<const LinePiece> pieces, double range,
                               const Eigen::Vector4d& prior) {
  Normal normal(prior);
  for (const LinePiece& piece : pieces) {
    if (piece.x > range) continue;
    const double x = piece.x;
    const double slope_sigma = std::hypot(piece.slope_sigma, kSlopeSigma);
    const double slope_trust = trust(piece.slope - slope(x, piece.y), slope_sigma);
    normal.add({1, x, x * x / 2, piece.y}, piece.slope,
               weight_of(piece) * slope_trust / (slope_sigma * slope_sigma));
    const Line* line = nearest(offset(x, piece.y), config_.line_spacing + 0.01 * x);
    if (!line) continue;
    const double sigma = std::hypot(piece.y_sigma, kPlaceSigma);
    const double residual = piece.y - (1 + shape_[3] * x) * (line->offset + course(x));
    const double weight = weight_of(piece) * trust(residual, sigma) * slope_trust / (sigma * sigma);
    const Eigen::Vector4d row(x, x * x / 2, x * x * x / 6, x * piece.y / (1 + shape_[3] * x));
    normal.add(row, piece.y - line->offset, weight);
  }
  shape_ = normal.solve();
}

void ParallelLines::fit(std::span<const LinePiece> pieces, double stretch_sigma) {
  const Eigen::Vector4d prior(config_.heading_sigma, config_.curvature_sigma, config_.curvature_rate_sigma,
                              stretch_sigma);
  shape_.setZero();
  lines_.clear();
  for (const double range : kRanges) {
    for (const double doubt : kDoubts) fit_slopes(pieces, range, doubt, prior);
    for (int i = 0; i < 2; ++i) {
      gather(pieces, range);
      fit_places(pieces, range, prior);
    }
    gather(pieces, range);
  }
}

}  // namespace lanefuse
