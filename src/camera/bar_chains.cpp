// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/bar_chains.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNone = 1e9;
constexpr double kWidthRatio = 0.35;     ///< [ln] one sigma between bars of one piece of paint
constexpr double kContrastRatio = 0.45;  ///< [ln]
constexpr double kCostMax = 9;
constexpr double kCurvatureSigma = 1.0 / 1500;  ///< [1/m] of roads
constexpr double kHeadingFloor = 0.001;         ///< [rad]
constexpr double kHeadingJitter = 0.015;        ///< [rad] by which a chain's next step may turn, one sigma
constexpr double kRowShare = 0.29;              ///< of a row: sigma of where paint that ends within it lies

/// Variance of a bar's place across [m^2]: its noise, and what paint that ends within the row shifts it.
double place_variance(const RoadBar& bar) {
  const double slanted = bar.per_pixel(1, 1) * kRowShare * bar.row_height;
  return bar.y_sigma * bar.y_sigma + slanted * slanted;
}

/// A straight line through weighted points, by its sums.
struct LineSums {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  void add(double weight, double at_x, double at_y) {
    w += weight;
    x += weight * at_x;
    y += weight * at_y;
    xx += weight * at_x * at_x;
    xy += weight * at_x * at_y;
  }
  [[nodiscard]] double spread() const { return xx - x * x / w; }
  [[nodiscard]] double slope() const { return (xy - x * y / w) / spread(); }
};

}  // namespace

void BarChains::index_rows(const std::vector<RoadBar>& bars, int plans) {
  row_begin_.assign(static_cast<std::size_t>(plans) + 1, static_cast<int>(bars.size()));
  for (std::size_t i = bars.size(); i-- > 0;)
    row_begin_[static_cast<std::size_t>(bars[i].plan)] = static_cast<int>(i);
  for (std::size_t p = static_cast<std::size_t>(plans); p-- > 0;) {
    row_begin_[p] = std::min(row_begin_[p], row_begin_[p + 1]);
  }
}

double BarChains::cost(const RoadBar& nearer, const RoadBar& farther, int nearer_index) const {
  const double dx = farther.x - nearer.x;
  const double dy = farther.y - nearer.y;
  if (!(dx > 0)) return kNone;
  const double variance = place_variance(nearer) + place_variance(farther);
  const double limit = config_.heading_max + farther.x / config_.radius_min;
  const double beyond = std::abs(dy) - limit * dx;
  if (beyond > 0 && beyond * beyond > 4 * variance) return kNone;
  const auto i = static_cast<std::size_t>(nearer_index);
  // A chain of some bars knows where it leads; a single bar leads somewhere along the road.
  const double spread = dx * (lengths_[i] >= 3 ? kHeadingJitter : limit / 2);
  const double off = dy - slopes_[i] * dx;
  const double way = off * off / (spread * spread + variance);
  if (way > kCostMax) return kNone;
  const double width = std::log(farther.width / nearer.width) / kWidthRatio;
  const double contrast = std::log(farther.bar.contrast / nearer.bar.contrast) / kContrastRatio;
  const int skipped = farther.plan - nearer.plan - 1;
  return way + (width * width + contrast * contrast) / 2 + 0.5 * skipped;
}

BarChains::Candidate BarChains::best_nearer(const std::vector<RoadBar>& bars, int index) const {
  const RoadBar& bar = bars[static_cast<std::size_t>(index)];
  Candidate best{-1, kNone};
  double least = kCostMax;
  for (int plan = bar.plan - 1; plan >= 0; --plan) {
    const int begin = row_begin_[static_cast<std::size_t>(plan)];
    const int end = row_begin_[static_cast<std::size_t>(plan) + 1];
    for (int i = begin; i < end; ++i) {
      const RoadBar& nearer = bars[static_cast<std::size_t>(i)];
      if (nearer.next >= 0) continue;
      const double cost_here = cost(nearer, bar, i);
      if (cost_here < least) {
        least = cost_here;
        best = {i, cost_here};
      }
    }
    if (begin < end && bar.plan - plan > config_.rows_skipped &&
        bar.x - bars[static_cast<std::size_t>(begin)].x > config_.reach) {
      break;
    }
    if (bar.plan - plan > 8) break;
  }
  return best;
}

void BarChains::join(std::vector<RoadBar>& bars, int nearer, int farther) {
  RoadBar& from = bars[static_cast<std::size_t>(nearer)];
  RoadBar& to = bars[static_cast<std::size_t>(farther)];
  from.next = farther;
  to.previous = nearer;
  lengths_[static_cast<std::size_t>(farther)] = lengths_[static_cast<std::size_t>(nearer)] + 1;
  // The slope over the last few metres.
  int back = nearer;
  for (int i = 0; i < 6 && bars[static_cast<std::size_t>(back)].previous >= 0; ++i) {
    back = bars[static_cast<std::size_t>(back)].previous;
  }
  const RoadBar& begin = bars[static_cast<std::size_t>(back)];
  const double dx = to.x - begin.x;
  const double variance = (place_variance(begin) + place_variance(to)) / (dx * dx);
  // Near the car a lone bar's best guess is straight ahead.
  const double prior = config_.heading_max / 2;
  const double slope = (to.y - begin.y) / dx;
  slopes_[static_cast<std::size_t>(farther)] = slope * prior * prior / (prior * prior + variance);
}

void BarChains::head(std::vector<RoadBar>& bars, const BarChain& chain) const {
  for (int i = chain.first; i >= 0; i = bars[static_cast<std::size_t>(i)].next) {
    RoadBar& bar = bars[static_cast<std::size_t>(i)];
    const double base = config_.heading_base + config_.heading_base_growth * bar.x;
    LineSums sums;
    const auto add = [&](int at) {
      const RoadBar& other = bars[static_cast<std::size_t>(at)];
      if (std::abs(other.x - bar.x) > base) return false;
      const double shifted = other.per_pixel(1, 1) * other.row_sigma;
      const double variance = other.y_sigma * other.y_sigma + shifted * shifted;
      sums.add(1 / variance, other.x - bar.x, other.y - bar.y);
      return true;
    };
    for (int at = i; at >= 0 && add(at);) at = bars[static_cast<std::size_t>(at)].previous;
    for (int at = bar.next; at >= 0 && add(at);) at = bars[static_cast<std::size_t>(at)].next;
    if (chain.count >= 2 && sums.spread() > 0) {
      bar.heading = std::atan(sums.slope());
      // At a chain's end the fit looks to one side only, where the road may have turned.
      const double aside = sums.x / sums.w;
      bar.heading_sigma = std::hypot(1 / std::sqrt(sums.spread()), aside * kCurvatureSigma, kHeadingFloor);
    } else {
      bar.heading_sigma = kNone;
    }
  }
}

void BarChains::collect(std::vector<RoadBar>& bars) {
  chains_.clear();
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (bars[i].previous >= 0) continue;
    BarChain chain{static_cast<int>(i), static_cast<int>(i), 0, 0};
    for (int at = chain.first; at >= 0; at = bars[static_cast<std::size_t>(at)].next) {
      bars[static_cast<std::size_t>(at)].chain = static_cast<int>(chains_.size());
      chain.last = at;
      ++chain.count;
    }
    chain.length = bars[static_cast<std::size_t>(chain.last)].x - bars[i].x;
    chains_.push_back(chain);
  }
}

/// The cheapest pairs of the row first, each nearer bar used once.
void BarChains::join_row(std::vector<RoadBar>& bars, int begin, int end) {
  wanted_.clear();
  for (int i = begin; i < end; ++i) wanted_.push_back(best_nearer(bars, i));
  for (;;) {
    const auto best =
        std::min_element(wanted_.begin(), wanted_.end(),
                         [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    if (best == wanted_.end() || best->nearer < 0) return;
    const int farther = begin + static_cast<int>(best - wanted_.begin());
    if (bars[static_cast<std::size_t>(best->nearer)].next >= 0) {
      *best = best_nearer(bars, farther);
      continue;
    }
    join(bars, best->nearer, farther);
    *best = {-1, kNone};
  }
}

const std::vector<BarChain>& BarChains::link(std::vector<RoadBar>& bars, int plans) {
  index_rows(bars, plans);
  slopes_.assign(bars.size(), 0);
  lengths_.assign(bars.size(), 1);
  for (int plan = 1; plan < plans; ++plan) {
    const int begin = row_begin_[static_cast<std::size_t>(plan)];
    const int end = row_begin_[static_cast<std::size_t>(plan) + 1];
    join_row(bars, begin, end);
  }
  collect(bars);
  return chains_;
}

void BarChains::measure_headings(std::vector<RoadBar>& bars) const {
  for (const BarChain& chain : chains_) head(bars, chain);
}

}  // namespace lanefuse
