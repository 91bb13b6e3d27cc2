// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_plane_alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace lanefuse {
namespace {

constexpr int kCell = RoadPlaneWarp::kCell;
constexpr float kCellPixels = kCell * kCell;
/// Neighbouring pixels err alike (blocks of the video's compression, interpolation): so many count as one.
constexpr double kPixelsAlike = 25;

using Matrix7 = Eigen::Matrix<double, PlaneMotion::kSize, PlaneMotion::kSize>;
using Vector7 = Eigen::Matrix<double, PlaneMotion::kSize, 1>;

cv::Mat as_mat(const NumberImage& image) {
  // OpenCV has no view of constant pixels; nothing is written through this one.
  return {image.height, image.width, CV_32F, const_cast<float*>(image.values.data())};
}

bool inside(const NumberImage& image, const Eigen::Vector2f& place) {
  return place.x() >= 0 && place.y() >= 0 && place.x() < static_cast<float>(image.width - 1) &&
         place.y() < static_cast<float>(image.height - 1);
}

/// Value and gradient between four pixels.
struct Sample {
  float value;
  float along;
  float down;
};

Sample sample(const NumberImage& image, float x, float y) {
  const int u = static_cast<int>(x);
  const int v = static_cast<int>(y);
  const float a = x - static_cast<float>(u);
  const float b = y - static_cast<float>(v);
  const float* upper = image.row(v) + u;
  const float* lower = upper + image.width;
  const float top = upper[0] + a * (upper[1] - upper[0]);
  const float bottom = lower[0] + a * (lower[1] - lower[0]);
  const float along = (1 - b) * (upper[1] - upper[0]) + b * (lower[1] - lower[0]);
  return {top + b * (bottom - top), along, bottom - top};
}

/// The places before of one cell's corners: upper left, upper right, lower left, lower right.
using Corners = std::array<Eigen::Vector2f, 4>;

/// The corners' places of one cell, if the image before holds all of them.
std::optional<Corners> corners_of(const NumberImage& before, const std::vector<RoadPlaneWarp::Node>& nodes,
                                  int columns, const Eigen::Vector2i& cell) {
  const RoadPlaneWarp::Node* upper = &nodes[static_cast<std::size_t>(cell.y() * (columns + 1) + cell.x())];
  const RoadPlaneWarp::Node* lower = upper + columns + 1;
  if (!upper[0].on_road || !upper[1].on_road || !lower[0].on_road || !lower[1].on_road) return {};
  const Corners corners{upper[0].before, upper[1].before, lower[0].before, lower[1].before};
  const bool all = std::all_of(corners.begin(), corners.end(),
                               [&](const Eigen::Vector2f& place) { return inside(before, place); });
  return all ? std::optional(corners) : std::nullopt;
}

/// Calls visit(column, row, x, y) for each pixel of a cell and its place in the image before.
template <typename Visit>
void for_each_pixel(const Corners& corners, Visit visit) {
  for (int j = 0; j < kCell; ++j) {
    const float b = static_cast<float>(j) / kCell;
    const Eigen::Vector2f first = corners[0] + b * (corners[2] - corners[0]);
    const Eigen::Vector2f step = (corners[1] + b * (corners[3] - corners[1]) - first) / kCell;
    for (int i = 0; i < kCell; ++i) {
      visit(i, j, first.x() + static_cast<float>(i) * step.x(), first.y() + static_cast<float>(i) * step.y());
    }
  }
}

CellMatch match_cell(const NumberImage& before, const NumberImage& now, int left, int top,
                     const Corners& corners) {
  CellMatch match;
  match.seen = true;
  float square_now = 0;
  float square_before = 0;
  float product = 0;
  for_each_pixel(corners, [&](int i, int j, float x, float y) {
    const float pixel = now.row(top + j)[left + i];
    const Sample old = sample(before, x, y);
    const float difference = pixel - old.value;
    square_now += pixel * pixel;
    square_before += old.value * old.value;
    product += pixel * old.value;
    match.curvature(0, 0) += old.along * old.along;
    match.curvature(0, 1) += old.along * old.down;
    match.curvature(1, 1) += old.down * old.down;
    match.slope += difference * Eigen::Vector2f(old.along, old.down);
  });
  match.curvature(1, 0) = match.curvature(0, 1);
  match.energy = square_now / kCellPixels;
  match.residual = std::max(0.0F, square_now - 2 * product + square_before) / kCellPixels;
  match.correlation = product / std::sqrt(std::max(square_now * square_before, 1e-9F));
  return match;
}

/// What all cells say of the motion, and how large their differences are.
struct Evidence {
  Matrix7 information = Matrix7::Zero();
  Vector7 slope = Vector7::Zero();
};

Evidence evidence(const std::vector<CellMatch>& matches,
                  const std::vector<RoadPlaneWarp::Jacobian>& jacobians, double least_weight) {
  double variance = 0;
  double weights = 0;
  const auto weight_of = [least_weight](const CellMatch& match) {
    const double fit = std::max(0.0F, match.correlation);
    return std::max(least_weight, fit * fit);
  };
  for (const CellMatch& match : matches) {
    if (!match.has_texture()) continue;
    variance += weight_of(match) * static_cast<double>(match.residual);
    weights += weight_of(match);
  }
  Evidence all;
  if (weights == 0) return all;
  const double noise = kPixelsAlike * std::max(variance / weights, 1e-3);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].has_texture()) continue;
    const double weight = weight_of(matches[i]) / noise;
    const RoadPlaneWarp::Jacobian& jacobian = jacobians[i];
    all.information += weight * jacobian.transpose() * matches[i].curvature.cast<double>() * jacobian;
    all.slope += weight * jacobian.transpose() * matches[i].slope.cast<double>();
  }
  return all;
}

}  // namespace

NumberImage road_texture(const NumberImage& brightness) {
  constexpr int kAround = 11;          // [px]
  constexpr float kLeastContrast = 4;  // grey levels
  constexpr float kMostContrast = 3;
  const cv::Mat image = as_mat(brightness);
  cv::Mat mean;
  cv::Mat square;
  cv::boxFilter(image, mean, CV_32F, {kAround, kAround});
  cv::sqrBoxFilter(image, square, CV_32F, {kAround, kAround});
  NumberImage texture(brightness.width, brightness.height);
  for (int v = 0; v < brightness.height; ++v) {
    const float* in = brightness.row(v);
    const float* local = mean.ptr<float>(v);
    const float* local_square = square.ptr<float>(v);
    float* out = texture.row(v);
    for (int u = 0; u < brightness.width; ++u) {
      const float variance = std::max(0.0F, local_square[u] - local[u] * local[u]);
      out[u] = std::clamp((in[u] - local[u]) / (std::sqrt(variance) + kLeastContrast), -kMostContrast,
                          kMostContrast);
    }
  }
  return texture;
}

NumberImage smoothed(const NumberImage& texture) {
  NumberImage smooth(texture.width, texture.height);
  cv::Mat out = as_mat(smooth);
  cv::boxFilter(as_mat(texture), out, CV_32F, {5, 5});
  return smooth;
}

std::vector<CellMatch> match_cells(const RoadPair& pair, const std::vector<RoadPlaneWarp::Node>& corners) {
  const int columns = pair.warp.columns();
  std::vector<CellMatch> matches(pair.believed.size());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (pair.believed[i] == 0) continue;
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    const auto before = corners_of(pair.before, corners, columns, {column, row});
    if (before) matches[i] = match_cell(pair.before, pair.now, column * kCell, row * kCell, *before);
  }
  return matches;
}

NumberImage plane_residual(const RoadPlaneWarp& warp, const NumberImage& before, const NumberImage& now,
                           const std::vector<RoadPlaneWarp::Node>& corners) {
  NumberImage residual(now.width, now.height);
  for (int row = 0; row < warp.rows(); ++row) {
    for (int column = 0; column < warp.columns(); ++column) {
      const auto places = corners_of(before, corners, warp.columns(), {column, row});
      if (!places) continue;
      for_each_pixel(*places, [&](int i, int j, float x, float y) {
        const int v = row * kCell + j;
        const int u = column * kCell + i;
        residual.row(v)[u] = std::abs(now.row(v)[u] - sample(before, x, y).value);
      });
    }
  }
  return residual;
}

RoadPlaneAlignment align_road_plane(const RoadPair& pair, const CameraPose& pose, const MotionGuess& guess) {
  constexpr int kIterations = 4;
  const Gaussian<PlaneMotion::kSize>& prior = guess.prior;
  const Matrix7 prior_information = prior.covariance.inverse();
  RoadPlaneAlignment result{.motion = prior, .matches = {}};
  PlaneMotion motion = guess.start;
  const std::vector<RoadPlaneWarp::Jacobian> jacobians = pair.warp.jacobians(pose, motion);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const std::vector<CellMatch> matches = match_cells(pair, pair.warp.map(pose, motion));
    const Evidence found = evidence(matches, jacobians, iteration < 2 ? 0.1 : 0.01);
    const Eigen::LDLT<Matrix7> solver(prior_information + found.information);
    motion.values += solver.solve(prior_information * (prior.mean - motion.values) + found.slope);
    result.motion.covariance = solver.solve(Matrix7::Identity());
  }
  result.matches = match_cells(pair, pair.warp.map(pose, motion));
  result.motion.mean = motion.values;
  return result;
}

}  // namespace lanefuse
