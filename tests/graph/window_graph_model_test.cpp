// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/window_graph.hpp"

namespace lanefuse {
namespace {

using Id = WindowGraph::Id;

struct ModelObservation {
  Id pose, landmark;
  std::uint64_t witness;
  Pose2 seen;
  PlanarInformation own;
};

struct ModelTie {
  Id from, to;
  std::uint32_t kind;
  double name;  ///< the y of its measurement
  friend bool operator<(const ModelTie& a, const ModelTie& b) {
    return std::tie(a.from, a.to, a.kind, a.name) < std::tie(b.from, b.to, b.kind, b.name);
  }
  friend bool operator==(const ModelTie&, const ModelTie&) = default;
};

bool is_near(double a, double b, double scale) { return std::abs(a - b) <= 1e-11 * scale; }

/// The graph beside a naive model of it: plain lists that are searched.
class GraphAndModel {
 public:
  GraphAndModel() { append(); }

  std::size_t below(std::size_t end) {
    return static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(end)));
  }

  void append() {
    const Pose2 pose{number_++, number_++, 0.1};
    const Id id = graph_.append_pose(pose, {2, 0.1, 0.2}, Eigen::Matrix3d::Identity());
    RC_ASSERT(id != WindowGraph::kNowhere);
    RC_ASSERT(std::none_of(chain_.begin(), chain_.end(), [&](const auto& p) { return p.first == id; }));
    chain_.emplace_back(id, pose);
  }

  void remove_pose() {
    const std::size_t index = below(chain_.size());
    if (index + 1 == chain_.size() || seen_from(chain_[index].first) > 0) return;
    graph_.remove_pose(index);
    chain_.erase(chain_.begin() + static_cast<std::ptrdiff_t>(index));
  }

  void add_landmark() {
    const Pose2 pose{number_++, number_++, -0.3};
    const Id id = graph_.add_landmark(pose);
    RC_ASSERT(landmarks_.emplace(id, pose).second);
  }

  void remove_landmark() {
    if (landmarks_.empty()) return;
    const Id id = any_landmark();
    graph_.remove_landmark(id);
    landmarks_.erase(id);
    std::erase_if(observations_, [&](const auto& o) { return o.landmark == id; });
    std::erase_if(ties_, [&](const auto& t) { return t.from == id || t.to == id; });
  }

  void observe() {
    if (landmarks_.empty()) return;
    const Id pose = chain_[below(chain_.size())].first;
    const Id landmark = any_landmark();
    const std::uint64_t witness = below(3);
    const Pose2 seen{number_++, number_++, 0.37 * static_cast<double>(below(17)) - 3.1};
    const double xx = 1 + static_cast<double>(below(1000));
    const double yy = 1 + static_cast<double>(below(1000));
    const PlanarInformation own{xx, 0.5 * std::sqrt(xx * yy), yy, 1 + static_cast<double>(below(5000))};
    const auto replaced = std::erase_if(observations_, [&](const auto& o) {
      return o.pose == pose && o.landmark == landmark && o.witness == witness;
    });
    RC_ASSERT(graph_.observe(pose, landmark, seen, own, witness) == (replaced == 0));
    observations_.push_back({pose, landmark, witness, seen, own});
  }

  void tie() {
    if (landmarks_.empty()) return;
    WindowGraph::Tie tie;
    tie.from = any_landmark();
    tie.to = any_landmark();
    tie.kind = static_cast<std::uint32_t>(below(2));
    tie.measurement = {0, number_++, 0.4};
    const bool symmetric = tie.kind == 1;
    const bool known = std::any_of(ties_.begin(), ties_.end(), [&](const auto& t) {
      const bool same = t.from == tie.from && t.to == tie.to;
      const bool reverse = symmetric && t.from == tie.to && t.to == tie.from;
      return t.kind == tie.kind && (same || reverse);
    });
    const Id id = graph_.add_tie(tie, Eigen::Matrix3d::Identity(), symmetric);
    RC_ASSERT((id != WindowGraph::kNone) == (tie.from != tie.to && !known));
    if (id == WindowGraph::kNone) return;
    RC_ASSERT(graph_.tie(id).switch_value == 1);
    ties_.push_back({tie.from, tie.to, tie.kind, tie.measurement.y});
  }

  void compare() const {
    compare_poses();
    compare_landmarks();
    compare_ties();
  }

 private:
  Id any_landmark() {
    return std::next(landmarks_.begin(), static_cast<std::ptrdiff_t>(below(landmarks_.size())))->first;
  }
  [[nodiscard]] std::ptrdiff_t seen_from(Id pose) const {
    return std::count_if(observations_.begin(), observations_.end(),
                         [&](const auto& o) { return o.pose == pose; });
  }

  void compare_poses() const {
    RC_ASSERT(graph_.chain().size() == chain_.size());
    RC_ASSERT(graph_.steps().size() == chain_.size());
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      RC_ASSERT(graph_.chain()[k] == chain_[k].first);
      RC_ASSERT(graph_.pose(chain_[k].first) == chain_[k].second);
      RC_ASSERT(graph_.observations_from(chain_[k].first) == seen_from(chain_[k].first));
    }
    RC_ASSERT(graph_.pose(WindowGraph::kNowhere) == Pose2{});
  }

  void compare_landmarks() const {
    RC_ASSERT(graph_.landmark_count() == landmarks_.size());
    RC_ASSERT(graph_.observation_count() == observations_.size());
    for (Id id = 0; id < graph_.landmark_slots(); ++id) {
      RC_ASSERT(graph_.is_alive(id) == (landmarks_.count(id) == 1));
      if (!graph_.is_alive(id)) continue;
      RC_ASSERT(graph_.landmark(id) == landmarks_.at(id));
      compare_observations(id);
    }
  }

  void compare_observations(Id landmark) const {
    std::vector<std::tuple<Id, std::uint64_t, double, double, double>> found, expected;
    std::size_t blocks = 0;
    for (Id id = graph_.first_block(landmark); id != WindowGraph::kNone; id = graph_.block(id).next) {
      const WindowGraph::Block& block = graph_.block(id);
      ++blocks;
      for (std::size_t k = 0; k < 4; ++k) {
        if (block.pose[k] != WindowGraph::kNowhere) {
          found.emplace_back(block.pose[k], block.witness[k], block.x[k], block.y[k], block.heading[k]);
        } else {
          RC_ASSERT(block.mean[k] == 0 && block.half[k] == 0 && block.cross[k] == 0);
          RC_ASSERT(block.heading_information[k] == 0);
        }
      }
    }
    PlanarInformation sum;
    for (const ModelObservation& o : observations_) {
      if (o.landmark != landmark) continue;
      expected.emplace_back(o.pose, o.witness, o.seen.x, o.seen.y, o.seen.heading);
      sum.xx += o.own.xx;
      sum.xy += o.own.xy;
      sum.yy += o.own.yy;
      sum.heading += o.own.heading;
    }
    RC_ASSERT(graph_.observation_count(landmark) == expected.size());
    RC_ASSERT(blocks == (expected.size() + 3) / 4);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(found == expected);
    const PlanarInformation& own = graph_.observed_information(landmark);
    const double scale = 1 + sum.xx + sum.yy + sum.heading + 1e4;  // what was replaced leaves its rounding
    RC_ASSERT(is_near(own.xx, sum.xx, scale) && is_near(own.xy, sum.xy, scale));
    RC_ASSERT(is_near(own.yy, sum.yy, scale) && is_near(own.heading, sum.heading, scale));
  }

  void compare_ties() const {
    RC_ASSERT(graph_.tie_count() == ties_.size());
    auto expected = ties_;
    std::sort(expected.begin(), expected.end());
    std::vector<ModelTie> all;
    for (Id id = 0; id < graph_.tie_slots(); ++id) {
      const WindowGraph::Tie& tie = graph_.tie(id);
      if (graph_.is_tie(id)) all.push_back({tie.from, tie.to, tie.kind, tie.measurement.y});
    }
    std::sort(all.begin(), all.end());
    RC_ASSERT(all == expected);
    for (const auto& [landmark, pose] : landmarks_) {
      std::vector<ModelTie> linked, own;
      for (Id id = graph_.first_tie(landmark); id != WindowGraph::kNone;) {
        const WindowGraph::Tie& tie = graph_.tie(id);
        linked.push_back({tie.from, tie.to, tie.kind, tie.measurement.y});
        RC_ASSERT(linked.size() <= expected.size());
        id = graph_.next_tie(tie, landmark);
      }
      for (const ModelTie& t : expected) {
        if (t.from == landmark || t.to == landmark) own.push_back(t);
      }
      std::sort(linked.begin(), linked.end());
      RC_ASSERT(linked == own);
    }
  }

  WindowGraph graph_;
  std::vector<std::pair<Id, Pose2>> chain_;
  std::map<Id, Pose2> landmarks_;
  std::vector<ModelObservation> observations_;
  std::vector<ModelTie> ties_;
  double number_ = 1;
};

RC_GTEST_PROP(WindowGraph, IsWhatANaiveModelOfItIs, ()) {
  GraphAndModel both;
  const int steps = *rc::gen::inRange(1, 200);
  for (int i = 0; i < steps; ++i) {
    switch (both.below(12)) {
      case 0:
        both.append();
        break;
      case 1:
        both.remove_pose();
        break;
      case 2:
      case 3:
        both.add_landmark();
        break;
      case 4:
        both.remove_landmark();
        break;
      case 5:
      case 6:
        both.tie();
        break;
      default:
        both.observe();
    }
    if (i % 10 == 0) both.compare();
  }
  both.compare();
}

}  // namespace
}  // namespace lanefuse
