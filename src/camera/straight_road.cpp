// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/straight_road.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "camera/bright_bars.hpp"

namespace lanefuse {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kNearestSlope = 0.2;  ///< [camera heights] of a marking beside the camera
constexpr double kFurthestSlope = 3;   ///< [camera heights]

/// right = offset + slope * down
struct Line {
  double offset = 0;
  double slope = 0;
  [[nodiscard]] double at(double down) const { return offset + slope * down; }
};

Line fit(const Points& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Eigen::Vector2d& p : points) {
    n += 1;
    x += p.y();
    y += p.x();
    xx += p.y() * p.y();
    xy += p.y() * p.x();
  }
  const double slope = (n * xy - x * y) / std::max(n * xx - x * x, 1e-12);
  return {(y - slope * x) / n, slope};
}

/// A stripe of paint, or of anything else that is bright.
struct Stripe {
  Line line;
  double middle = 0;       ///< down over depth
  double slope_sigma = 0;  ///< of its line
  int rows = 0;
};

/// Nothing for what is anything but straight.
std::optional<Stripe> stripe_of(std::span<const BrightBar> chain, const CameraModel& camera) {
  Points points;
  for (const BrightBar& bar : chain) {
    points.push_back(camera.direction({bar.middle(), static_cast<double>(bar.row)}));
  }
  Stripe stripe{fit(points), 0, 0, static_cast<int>(points.size())};
  double error = 0;
  for (const Eigen::Vector2d& p : points) {
    stripe.middle += p.y() / stripe.rows;
    error += std::pow(p.x() - stripe.line.at(p.y()), 2) / stripe.rows;
  }
  constexpr double kLargestError = 1.5;  // [px]
  const double px = 1 / camera.intrinsics().fx;
  const double length = std::abs(points.back().y() - points.front().y());
  if (std::sqrt(error) > kLargestError * px || !(length > 0)) return {};
  stripe.slope_sigma = px * std::sqrt(12.0 / stripe.rows) / length;
  return stripe;
}

/// Long chains in pieces: near the horizon they lead astray.
std::vector<Stripe> stripes_of(const std::vector<BrightBar>& bars, const CameraModel& camera) {
  constexpr std::size_t kFewestRows = 6;
  constexpr std::size_t kMostRows = 60;
  std::vector<Stripe> stripes;
  for (const std::vector<BrightBar>& chain : chain_bars(bars, kFewestRows)) {
    const std::size_t pieces = (chain.size() + kMostRows - 1) / kMostRows;
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t begin = chain.size() * i / pieces;
      const std::size_t end = chain.size() * (i + 1) / pieces;
      if (const auto stripe = stripe_of(std::span(chain).subspan(begin, end - begin), camera)) {
        stripes.push_back(*stripe);
      }
    }
  }
  return stripes;
}

/// How well a stripe's line runs through `vanishing`, in [0, 1]; one that hardly has a direction does not.
double agreement(const Stripe& stripe, const Eigen::Vector2d& vanishing, const StraightRoadConfig& config) {
  constexpr double kSlack = 0.004;   // [rad]: the lens, the road
  constexpr double kVaguest = 0.03;  // [rad]
  const double down = stripe.middle - vanishing.y();
  const double sigma = stripe.slope_sigma * down;
  if (down < config.nearest_horizon || sigma > kVaguest) return 0;
  const double miss = stripe.line.at(vanishing.y()) - vanishing.x();
  return std::max(0.0, 1 - miss * miss / (9 * (sigma * sigma + kSlack * kSlack))) * kSlack /
         std::hypot(sigma, kSlack);
}

/// The slope from the vanishing point to a stripe, in camera heights to the side.
double slope_from(const Eigen::Vector2d& vanishing, const Stripe& stripe) {
  return (stripe.line.at(stripe.middle) - vanishing.x()) / (stripe.middle - vanishing.y());
}

/// How much paint there is to run to `vanishing`, on the side where there is less of it: whatever stands
/// beside the road votes for one side alone.
double score_of(const std::vector<Stripe>& stripes, const Eigen::Vector2d& vanishing,
                const StraightRoadConfig& config) {
  double left = 0;
  double right = 0;
  for (const Stripe& stripe : stripes) {
    const double rows = stripe.rows * agreement(stripe, vanishing, config);
    if (rows <= 0) continue;
    const double slope = slope_from(vanishing, stripe);
    if (!(std::abs(slope) > kNearestSlope && std::abs(slope) < kFurthestSlope)) continue;
    (slope < 0 ? left : right) += rows;
  }
  return left * right;
}

Eigen::Vector2d vote_for_vanishing(const std::vector<Stripe>& stripes, const StraightRoadConfig& config) {
  constexpr double kStep = 0.004;
  const int steps = static_cast<int>(config.largest_angle / kStep);
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double best_score = 0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Eigen::Vector2d candidate(j * kStep, i * kStep);
      const double score = score_of(stripes, candidate, config);
      if (score > best_score) {
        best_score = score;
        best = candidate;
      }
    }
  }
  return best;
}

/// The stripes whose lines have about the same slope; those far below the vanishing point know it best.
struct SlopeBin {
  double rows = 0;
  double weight = 0;
  double sum = 0;

  void add(const SlopeBin& other) {
    rows += other.rows;
    weight += other.weight;
    sum += other.sum;
  }
};

/// The slope nearest to straight ahead, on one side, of which a third as much is seen as of that side's most
/// seen one.
std::optional<double> nearest_line(const std::vector<Stripe>& stripes, const Eigen::Vector2d& vanishing,
                                   double side, const StraightRoadConfig& config) {
  constexpr double kBin = 0.1;
  std::array<SlopeBin, static_cast<std::size_t>((kFurthestSlope - kNearestSlope) / kBin) + 2> bins{};
  for (const Stripe& stripe : stripes) {
    if (agreement(stripe, vanishing, config) <= 0) continue;
    const double slope = slope_from(vanishing, stripe);
    if (!(side * slope > kNearestSlope && side * slope < kFurthestSlope)) continue;
    const double weight = stripe.rows * std::pow(stripe.middle - vanishing.y(), 2);
    bins[static_cast<std::size_t>((side * slope - kNearestSlope) / kBin)].add(
        {static_cast<double>(stripe.rows), weight, weight * slope});
  }
  // Two bins at a time: a line's stripes may lie on either side of a bin's end.
  double most = 0;
  for (std::size_t i = 0; i + 1 < bins.size(); ++i) {
    bins[i].add(bins[i + 1]);
    most = std::max(most, bins[i].rows);
  }
  const double enough = std::max<double>(config.fewest_rows, most / 3);
  for (std::size_t i = 0; i + 1 < bins.size(); ++i) {
    if (bins[i].rows >= enough && bins[i].rows >= bins[i + 1].rows) return bins[i].sum / bins[i].weight;
  }
  return {};
}

Points near(const Line& line, const Points& points, double horizon, double gate) {
  Points found;
  for (const Eigen::Vector2d& p : points) {
    if (p.y() > horizon && std::abs(p.x() - line.at(p.y())) < gate) found.push_back(p);
  }
  return found;
}

bool is_long(const Points& points, int fewest) {
  constexpr double kShortest = 0.05;  // down over depth
  if (points.size() < static_cast<std::size_t>(fewest)) return false;
  const auto [first, last] = std::minmax_element(points.begin(), points.end(),
                                                 [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return last->y() - first->y() > kShortest;
}

/// Fits both lines anew to what is near them, nearer from time to time.
std::optional<StraightRoadView> refine(const Points& points, Line left, Line right, double focal,
                                       const StraightRoadConfig& config) {
  StraightRoadView view;
  for (const double gate_px : {12.0, 8.0, 5.0, 3.0, 2.5, 2.5}) {
    const double turn = right.slope - left.slope;
    if (!(turn > 0.3)) return {};
    const double down = (left.offset - right.offset) / turn;
    view.vanishing = {left.at(down), down};
    if (!(view.vanishing.cwiseAbs().maxCoeff() <= config.largest_angle)) return {};
    const double horizon = down + config.nearest_horizon;
    view.left = near(left, points, horizon, gate_px / focal);
    view.right = near(right, points, horizon, gate_px / focal);
    if (!is_long(view.left, config.fewest_rows) || !is_long(view.right, config.fewest_rows)) return {};
    left = fit(view.left);
    right = fit(view.right);
  }
  view.left_slope = left.slope;
  view.right_slope = right.slope;
  return view;
}

}  // namespace

std::optional<StraightRoadView> find_straight_road(const ImageView& image, const CameraModel& camera,
                                                   const StraightRoadConfig& config) {
  const std::vector<BrightBar> bars = find_bright_bars(image, config.contrast);
  Points points;
  for (const BrightBar& bar : bars) {
    points.push_back(camera.direction({bar.middle(), static_cast<double>(bar.row)}));
  }
  const std::vector<Stripe> stripes = stripes_of(bars, camera);
  const Eigen::Vector2d vanishing = vote_for_vanishing(stripes, config);
  const auto left = nearest_line(stripes, vanishing, -1, config);
  const auto right = nearest_line(stripes, vanishing, 1, config);
  if (!left || !right) return {};
  const auto through = [&](double slope) { return Line{vanishing.x() - slope * vanishing.y(), slope}; };
  return refine(points, through(*left), through(*right), camera.intrinsics().fx, config);
}

}  // namespace lanefuse
