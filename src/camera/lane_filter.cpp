// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

using State = LaneState;

double sign_of(Side side) { return side == Side::left ? 1 : -1; }

/// Tukey's biweight: one in the middle, zero from `edge` on.
double biweight(double squared, double edge_squared) {
  const double rest = 1 - squared / edge_squared;
  return rest > 0 ? rest * rest : 0;
}

/// (y0, theta0, c0, c1) of one edge as a function of the state.
Eigen::Matrix<double, 4, State::kSize> edge_jacobian(Side side) {
  Eigen::Matrix<double, 4, State::kSize> jacobian = Eigen::Matrix<double, 4, State::kSize>::Zero();
  jacobian(0, State::kOffset) = 1;
  jacobian(0, State::kWidth) = sign_of(side) / 2;
  jacobian(1, State::kHeading) = 1;
  jacobian(2, State::kCurvature) = 1;
  jacobian(3, State::kCurvatureRate) = 1;
  return jacobian;
}

/// The variance that a number that forgets with `tau` gains in `step`.
double wandered(double sigma, double tau, double step) {
  return sigma * sigma * (1 - std::exp(-2 * step / tau));
}

}  // namespace

Clothoid LaneState::edge(const Vector& state, Side side) {
  return {state[kOffset] + sign_of(side) * state[kWidth] / 2, state[kHeading], state[kCurvature],
          state[kCurvatureRate]};
}

std::optional<EdgeResidual> edge_residual(const RoadSight& sight, const RoadSight::Ray& ray, Side side,
                                          const LaneState::Vector& state) {
  const auto landing = sight.landing(ray, state[State::kPitch], state[State::kVerticalCurvature]);
  if (!landing) return {};
  const Clothoid edge = State::edge(state, side);
  const double x = landing->place.x();
  const double slope = edge.slope(x);
  // How far a change of the landing place moves it away from the edge.
  const auto across = [slope](const Eigen::Vector2d& change) { return change.y() - slope * change.x(); };
  const double metres = landing->place.y() - edge.y(x);
  const double per_column = across(landing->per_column);
  // Columns count to the right: places move to the left's opposite.
  if (!(per_column < 0)) return {};
  EdgeResidual residual;
  residual.pixels = metres / per_column;
  residual.metres_per_pixel = -per_column;
  residual.distance = x;
  State::RowVector& j = residual.jacobian;
  j[State::kOffset] = 1;
  j[State::kWidth] = sign_of(side) / 2;
  j[State::kHeading] = x;
  j[State::kCurvature] = x * x / 2;
  j[State::kCurvatureRate] = x * x * x / 6;
  j[State::kPitch] = -across(landing->per_pitch);
  j[State::kVerticalCurvature] = -across(landing->per_vertical_curvature);
  j[State::kDrift] = 0;
  j /= per_column;
  return residual;
}

void LaneFilter::predict(double seconds, double speed, double yaw_rate) {
  const double way = std::max(0.0, speed * seconds);
  const double turn = yaw_rate * seconds;
  State::Matrix move = State::Matrix::Identity();
  move(State::kOffset, State::kHeading) = way;
  move(State::kOffset, State::kCurvature) = way * way / 2;
  move(State::kOffset, State::kCurvatureRate) = way * way * way / 6;
  move(State::kOffset, State::kDrift) = way;
  move(State::kHeading, State::kCurvature) = way;
  move(State::kHeading, State::kCurvatureRate) = way * way / 2;
  const double rate_kept = std::exp(-way / config_.curvature_rate_length);
  move(State::kCurvature, State::kCurvatureRate) = way;
  move(State::kCurvatureRate, State::kCurvatureRate) = rate_kept;
  move(State::kPitch, State::kPitch) = std::exp(-seconds / config_.pitch_tau);
  move(State::kVerticalCurvature, State::kVerticalCurvature) =
      std::exp(-way / config_.vertical_curvature_length);
  const auto walked = [](double walk, double step) { return walk * walk * step; };
  State::Vector noise;
  noise[State::kOffset] = walked(config_.offset_walk, seconds);
  noise[State::kWidth] = walked(config_.width_walk, seconds);
  noise[State::kHeading] = walked(config_.heading_walk, seconds);
  noise[State::kCurvature] = walked(config_.curvature_walk, way / 100);
  noise[State::kCurvatureRate] = wandered(config_.curvature_rate_sigma, config_.curvature_rate_length, way);
  noise[State::kPitch] = wandered(config_.pitch_sigma, config_.pitch_tau, seconds);
  noise[State::kVerticalCurvature] =
      wandered(config_.vertical_curvature_sigma, config_.vertical_curvature_length, way);
  noise[State::kDrift] = walked(config_.drift_walk, seconds);
  lanefuse::predict<State::kSize>(state_, move, noise.asDiagonal().toDenseMatrix());
  state_.mean[State::kOffset] -= way * turn / 2;
  state_.mean[State::kHeading] -= turn;
}

void LaneFilter::correct_pose(double pitch, double yaw, double height_ratio) {
  state_.mean[State::kPitch] -= pitch;
  state_.mean[State::kHeading] += yaw;
  state_.mean[State::kDrift] -= yaw;
  state_.mean[State::kOffset] *= height_ratio;
  state_.mean[State::kWidth] *= height_ratio;
}

void LaneFilter::cross_marking(Side side, double marking_width) {
  constexpr double kWidthSigma = 0.2;  // [m] by which neighbouring lanes differ
  const double outward = sign_of(side);
  State::Matrix move = State::Matrix::Identity();
  move(State::kOffset, State::kWidth) = outward;
  state_.mean[State::kOffset] += outward * (state_.mean[State::kWidth] + marking_width);
  state_.covariance = (move * state_.covariance * move.transpose()).eval();
  // The new width moves the middle by its half.
  State::Vector by_width = State::Vector::Zero();
  by_width[State::kWidth] = kWidthSigma;
  by_width[State::kOffset] = outward * kWidthSigma / 2;
  state_.covariance += by_width * by_width.transpose();
}

double LaneFilter::noise(const EdgeResidual& residual) const {
  const double paint = config_.paint_noise / residual.metres_per_pixel;
  return config_.pixel_noise * config_.pixel_noise + paint * paint;
}

State::Vector LaneFilter::best_start(const RoadSight& sight, std::span<const EdgeMeasurement> edges) const {
  const double variance = state_.covariance(State::kPitch, State::kPitch);
  // What would be left of the covariance if the pitch were known.
  const State::Vector by_pitch = state_.covariance.col(State::kPitch);
  const State::Matrix rest = state_.covariance - by_pitch * by_pitch.transpose() / variance;
  constexpr double kTolerance = 4;  // [px]
  constexpr double kLoosened = 6;   // [sigma^2]
  std::array<double, kMostEdges> tolerances{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto expected = edge_residual(sight, edges[i].ray, edges[i].side, state_.mean);
    if (!expected) continue;
    const double scatter = expected->jacobian * rest * expected->jacobian.transpose();
    tolerances[i] = kTolerance * kTolerance + kLoosened * (scatter + noise(*expected));
  }
  constexpr int kSteps = 10;      // to either side
  constexpr double kReach = 3.5;  // [sigma]
  State::Vector best = state_.mean;
  double best_score = -1;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double shift = kReach * i / kSteps;
    // A pitch that is off says how the rest is off, too.
    const State::Vector state = state_.mean + shift / std::sqrt(variance) * by_pitch;
    std::array<double, 2> scores{};
    std::array<double, 2> in_window{};
    int window = -1;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const EdgeMeasurement& edge = edges[k];
      if (edge.window != window) {
        for (std::size_t s = 0; s < 2; ++s) scores[s] += std::exchange(in_window[s], 0.0);
        window = edge.window;
      }
      const auto residual = edge_residual(sight, edge.ray, edge.side, state);
      if (!residual) continue;
      double& score = in_window[edge.side == Side::left ? 0 : 1];
      score = std::max(score, edge.confidence * biweight(residual->pixels * residual->pixels, tolerances[k]));
    }
    for (std::size_t s = 0; s < 2; ++s) scores[s] += in_window[s];
    // One marking alone fits any pitch, with a heading to match: what fits both counts twice. Of equals the
    // one that surprises less.
    const double score =
        (scores[0] + scores[1] + 2 * std::sqrt(scores[0] * scores[1])) * (1 - 0.02 * shift * shift);
    if (score > best_score) {
      best_score = score;
      best = state;
    }
  }
  return best;
}

namespace {

/// One window's likeliest edge at the present estimate.
struct Chosen {
  int measurement = -1;
  double squared = 0;  ///< residual over sigma, squared
  double noise = 1;
  EdgeResidual residual;
};

}  // namespace

void LaneFilter::update(const RoadSight& sight, std::span<const EdgeMeasurement> edges, Fit& fit) {
  fit = {};
  assert(edges.size() <= fit.inlier.size());
  const State::Vector prior = state_.mean;
  const State::Matrix prior_information = state_.covariance.llt().solve(State::Matrix::Identity());
  State::Vector mean = best_start(sight, edges);
  State::Matrix information = prior_information;
  constexpr std::array<double, 6> kLoosened = {6, 3, 2, 1.3, 1, 1};  // the gate, iteration by iteration
  for (const double loosened : kLoosened) {
    information = prior_information;
    State::Vector gradient = prior_information * (prior - mean);
    const double edge_squared = std::pow(config_.gate * loosened, 2);
    fit = {};
    double weight_sum = 0;
    const auto take = [&](const Chosen& chosen) {
      const double weight = chosen.measurement < 0 ? 0 : biweight(chosen.squared, edge_squared);
      if (weight <= 0) return;
      const EdgeMeasurement& edge = edges[static_cast<std::size_t>(chosen.measurement)];
      const double precision = weight * edge.confidence / chosen.noise;
      information.noalias() += precision * chosen.residual.jacobian.transpose() * chosen.residual.jacobian;
      gradient.noalias() += precision * chosen.residual.pixels * chosen.residual.jacobian.transpose();
      fit.mean_square += weight * chosen.squared;
      weight_sum += weight;
      ++fit.inliers[edge.side == Side::left ? 0 : 1];
      fit.inlier[static_cast<std::size_t>(chosen.measurement)] = true;
    };
    Chosen chosen;
    int window = -1;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].window != window) {
        take(chosen);
        chosen = {};
        window = edges[i].window;
      }
      const auto residual = edge_residual(sight, edges[i].ray, edges[i].side, mean);
      if (!residual) continue;
      const double variance = noise(*residual);
      const double squared = residual->pixels * residual->pixels / variance;
      if (chosen.measurement >= 0 && chosen.squared <= squared) continue;
      chosen = {static_cast<int>(i), squared, variance, *residual};
    }
    take(chosen);
    mean += information.llt().solve(gradient);
    if (weight_sum > 0) fit.mean_square /= weight_sum;
  }
  state_.mean = mean;
  state_.covariance = information.llt().solve(State::Matrix::Identity());
}

Eigen::Matrix4d LaneFilter::edge_covariance(Side side) const {
  const auto jacobian = edge_jacobian(side);
  return jacobian * state_.covariance * jacobian.transpose();
}

}  // namespace lanefuse
