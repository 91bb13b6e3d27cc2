// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_acquisition.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr std::size_t kMostRays = 600;
constexpr double kRowSpacing = 1.05;
constexpr double kPaint = 0.12;  ///< [m] usual width of a marking

// What is tried: the camera's pitch off its pose, the lane's heading and curvature.
constexpr double kPitchStep = 0.006;
constexpr int kPitchSteps = 3;
constexpr double kHeadingStep = 0.009;
constexpr int kHeadingSteps = 7;
constexpr double kCurvatureStep = 6e-4;
constexpr int kCurvatureSteps = 3;

}  // namespace

LaneAcquisition::LaneAcquisition(const LaneAcquisitionConfig& config) : config_(config) {
  rays_.reserve(kMostRays);
  votes_.reserve(kMostRays);
}

void LaneAcquisition::collect(const EdgeScene& scene) {
  rays_.clear();
  int last_row = scene.image.height;
  for (double x = config_.nearest; x <= config_.farthest; x *= kRowSpacing) {
    const auto left = scene.sight->pixel({x, config_.reach}, 0, 0);
    const auto right = scene.sight->pixel({x, -config_.reach}, 0, 0);
    const auto middle = scene.sight->pixel({x, 0}, 0, 0);
    if (!left || !right || !middle) continue;
    BarQuery query;
    query.row = static_cast<int>(std::lround(middle->y()));
    if (query.row < 0 || query.row >= last_row) continue;
    last_row = query.row;
    const double pixels_per_metre = (right->x() - left->x()) / (2 * config_.reach);
    query.left = std::max(0, static_cast<int>(left->x()));
    query.right = std::min(scene.image.width - 1, static_cast<int>(right->x()));
    query.narrowest = std::max(1.0, 0.08 * pixels_per_metre - 1);
    query.widest = 0.35 * pixels_per_metre + 4;
    query.contrast = config_.contrast_min;
    for (const PaintBar& bar : finder_.find(scene.image, query)) {
      const double column = (bar.left + bar.right) / 2;
      if (is_hidden(scene.vehicles, column, query.row)) continue;
      if (rays_.size() == kMostRays) return;
      rays_.push_back(scene.sight->ray({column, query.row}));
    }
  }
}

void LaneAcquisition::land(const RoadSight& sight, double pitch) {
  votes_.clear();
  for (const RoadSight::Ray& ray : rays_) {
    const auto landing = sight.landing(ray, pitch, 0);
    if (!landing || landing->place.x() > 1.3 * config_.farthest) continue;
    votes_.push_back({static_cast<float>(landing->place.x()), static_cast<float>(landing->place.y()), 1.0F});
  }
}

LaneAcquisition::Pair LaneAcquisition::best_pair(double heading, double curvature) {
  bins_.fill(0);
  const auto slope = static_cast<float>(heading);
  const auto bend = static_cast<float>(curvature / 2);
  const auto scale = static_cast<float>(1 / bin_width());
  for (const Vote& vote : votes_) {
    // Shared between two bins, so that a peak does not depend on where the bins begin.
    const float place = (vote.y - vote.x * (slope + bend * vote.x)) * scale + kBins / 2.0F - 0.5F;
    if (!(place >= 0) || !(place < kBins - 1)) continue;
    const int bin = static_cast<int>(place);
    const float part = place - static_cast<float>(bin);
    bins_[static_cast<std::size_t>(bin)] += vote.weight * (1 - part);
    bins_[static_cast<std::size_t>(bin) + 1] += vote.weight * part;
  }
  const auto votes_at = [this](int i) {
    return static_cast<double>(bins_[static_cast<std::size_t>(i)] + bins_[static_cast<std::size_t>(i) + 1]);
  };
  const auto place_of = [this](int i) { return (i + 1 - kBins / 2.0) * bin_width(); };
  Pair best;
  for (int i = kBins / 2; i < kBins - 1; ++i) {
    if (votes_at(i) < config_.votes_min) continue;
    const int nearest = static_cast<int>((config_.lane_width_min + kPaint) / bin_width());
    const int farthest = static_cast<int>((config_.lane_width_max + kPaint) / bin_width());
    for (int j = std::max(0, i - farthest); j <= std::min(i - nearest, kBins / 2); ++j) {
      if (votes_at(j) < config_.votes_min) continue;
      const double width = place_of(i) - place_of(j) - kPaint;
      const double unusual = (width - 3.5) / 0.8;
      const double score = std::sqrt(votes_at(i) * votes_at(j)) * std::exp(-0.5 * unusual * unusual);
      if (score > best.score) best = {score, place_of(i), place_of(j)};
    }
  }
  return best;
}

std::optional<Gaussian<LaneState::kSize>> LaneAcquisition::find(const EdgeScene& scene) {
  collect(scene);
  Pair best;
  Gaussian<LaneState::kSize> found;
  for (int p = -kPitchSteps; p <= kPitchSteps; ++p) {
    land(*scene.sight, p * kPitchStep);
    for (int h = -kHeadingSteps; h <= kHeadingSteps; ++h) {
      for (int c = -kCurvatureSteps; c <= kCurvatureSteps; ++c) {
        Pair pair = best_pair(h * kHeadingStep, c * kCurvatureStep);
        // Of equals the least surprising.
        pair.score *= 1 - 0.01 * std::abs(p) - 0.005 * std::abs(h) - 0.01 * std::abs(c);
        if (pair.score <= best.score) continue;
        best = pair;
        found.mean.setZero();
        found.mean[LaneState::kHeading] = h * kHeadingStep;
        found.mean[LaneState::kCurvature] = c * kCurvatureStep;
        found.mean[LaneState::kPitch] = p * kPitchStep;
      }
    }
  }
  if (best.score < config_.votes_min) return {};
  found.mean[LaneState::kOffset] = (best.left + best.right) / 2;
  found.mean[LaneState::kWidth] = best.left - best.right - kPaint;
  LaneState::Vector sigma;
  sigma << 0.15, 0.25, 0.008, 5e-4, 5e-6, 0.006, 4e-5, 0.02;
  found.covariance = sigma.cwiseAbs2().asDiagonal();
  return found;
}

}  // namespace lanefuse
