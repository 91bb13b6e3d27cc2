// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/edge_chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace lanefuse {
namespace {

/// Neighbours draw their common edge twice, now and then some decimetres apart (US-101: 0.39 m).
constexpr double kSameEdge = 0.5;  // [m]
constexpr double kSameEnd = 0.5;   // [m]
constexpr std::size_t kProbes = 32;

double distance_to(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d from = line[i - 1].head<2>();
    const Eigen::Vector2d along = line[i].head<2>() - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - from - share * along).norm());
  }
  return nearest;
}

/// Every so many of one line's points lie on the other.
bool lies_on(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& line) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kProbes);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (distance_to(line, points[i].head<2>()) > kSameEdge) return false;
  }
  return true;
}

bool is_same(const StripEdge& a, const StripEdge& b) {
  if (a.points == b.points) return true;
  const auto near = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return (p - q).head<2>().norm() <= kSameEnd;
  };
  return near(a.points.front(), b.points.front()) && near(a.points.back(), b.points.back()) &&
         lies_on(a.points, b.points) && lies_on(b.points, a.points);
}

double bend_between(const StripEdge& before, const StripEdge& after) {
  const Eigen::Vector2d a = (before.points.back() - before.points[before.points.size() - 2]).head<2>();
  const Eigen::Vector2d b = (after.points[1] - after.points.front()).head<2>();
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// Which of several things belong together, as a forest over their numbers.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::size_t of(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(b)] = of(a); }

 private:
  std::vector<std::size_t> parent_;
};

std::size_t slot(std::size_t strip, StripSide side) { return 2 * strip + static_cast<std::size_t>(side); }

}  // namespace

EdgeChains::EdgeChains(const std::vector<LaneStrip>& strips) : strips_(strips), edge_of_(2 * strips.size()) {
  std::iota(edge_of_.begin(), edge_of_.end(), 0);
  share_between_neighbours();
  number_edges();
  link();
}

std::size_t EdgeChains::edge_of(std::size_t strip, StripSide side) const {
  return edge_of_[slot(strip, side)];
}

void EdgeChains::share_between_neighbours() {
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (strips_[i].right_strip) share(i, *strips_[i].right_strip);
    if (strips_[i].left_strip) share(*strips_[i].left_strip, i);
  }
}

/// The right edge of the one is the left edge of the other, as the one on the left draws it.
void EdgeChains::share(std::size_t left_strip, std::size_t right_strip) {
  const std::size_t here = slot(left_strip, StripSide::right);
  const std::size_t there = slot(right_strip, StripSide::left);
  if (left_strip == right_strip || edge_of_[here] != here || edge_of_[there] != there) return;
  if (!is_same(strips_[left_strip].edge(StripSide::right), strips_[right_strip].edge(StripSide::left)))
    return;
  edge_of_[there] = here;
}

void EdgeChains::number_edges() {
  std::vector<std::size_t> number(edge_of_.size());
  for (std::size_t i = 0; i < edge_of_.size(); ++i) {
    if (edge_of_[i] != i) continue;
    number[i] = shapes_.size();
    shapes_.push_back(&strips_[i / 2].edges[i % 2]);
  }
  users_.assign(shapes_.size(), 0);
  for (std::size_t& edge : edge_of_) {
    edge = number[edge];
    ++users_[edge];
  }
  next_.resize(shapes_.size());
  previous_.resize(shapes_.size());
}

std::vector<EdgeChains::Link> EdgeChains::possible_links() const {
  std::vector<Link> links;
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    for (const std::size_t successor : strips_[i].successors) {
      for (const StripSide side : {StripSide::left, StripSide::right}) {
        const std::size_t from = edge_of(i, side);
        const std::size_t to = edge_of(successor, side);
        const double gap = (shape(from).points.back() - shape(to).points.front()).head<2>().norm();
        if (from != to && gap <= kSameEnd) links.push_back({from, to, bend_between(shape(from), shape(to))});
      }
    }
  }
  return links;
}

/// Each edge runs on in one other at most: where it could run on in several, in the straightest. No chain is
/// closed to a ring.
void EdgeChains::link() {
  std::vector<Link> links = possible_links();
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return std::tie(a.bend, a.from, a.to) < std::tie(b.bend, b.from, b.to);
  });
  Groups chains(size());
  for (const Link& link : links) {
    if (next_[link.from] || previous_[link.to] || chains.of(link.from) == chains.of(link.to)) continue;
    next_[link.from] = link.to;
    previous_[link.to] = link.from;
    chains.join(link.from, link.to);
  }
}

std::size_t EdgeChains::first_of_chain(std::size_t edge) const {
  while (previous_[edge]) edge = *previous_[edge];
  return edge;
}

void EdgeChains::cut_after(std::size_t edge) {
  previous_[*next_[edge]].reset();
  next_[edge].reset();
}

}  // namespace lanefuse
