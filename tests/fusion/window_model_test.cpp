// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/fusion_drive.hpp"

namespace lanefuse {
namespace {

/// An edge by names that no renumbering changes: the x of its vertices, which are all different, the y of its
/// measurement, and the value that its switch was given (0 for none).
struct NamedEdge {
  EdgeKind kind;
  double from, to, name, switch_value;
  friend bool operator==(const NamedEdge&, const NamedEdge&) = default;
  friend bool operator<(const NamedEdge& a, const NamedEdge& b) {
    return std::tie(a.kind, a.from, a.to, a.name) < std::tie(b.kind, b.from, b.to, b.name);
  }
};

/// The window beside a naive model of it: lists by name that are filtered, and never renumbered.
class WindowAndModel {
 public:
  void drive(double metres) {
    car_ += metres;
    time_ += from_seconds(0.1);
    window_.advance(time_, {car_, 0, 0});
    if (keyframes_.empty() || car_ - keyframes_.back() >= config_.keyframe_distance)
      keyframes_.push_back(car_);
  }

  void see(double ahead, double late_s) {
    const double x = car_ + ahead + 1e-6 * name_++;
    ids_.push_back(window_.add_feature({x, 0, 0}, time_));
    features_.push_back(x);
    measure(ids_.size() - 1, late_s);
  }

  void measure(std::size_t which, double late_s) {
    if (ids_.empty()) return;
    which %= ids_.size();
    const VertexId keyframe = window_.nearest_keyframe(time_ - from_seconds(late_s));
    const double from = window_.graph().vertices[keyframe].pose.x;
    window_.add_measurement({keyframe, ids_[which], {0, ++name_, 0}},
                            {EdgeKind::measurement, Source::objects, 1});
    std::erase_if(edges_, [&](const NamedEdge& e) {
      return e.kind == EdgeKind::measurement && e.from == from && e.to == features_[which];
    });
    edges_.push_back({EdgeKind::measurement, from, features_[which], name_, 0});
  }

  void tie(std::size_t a, std::size_t b, EdgeKind kind) {
    if (ids_.empty()) return;
    a %= ids_.size();
    b %= ids_.size();
    const bool known = std::any_of(edges_.begin(), edges_.end(), [&](const NamedEdge& e) {
      const bool reverse = e.from == features_[b] && e.to == features_[a] && kind == EdgeKind::smoothing;
      return e.kind == kind && ((e.from == features_[a] && e.to == features_[b]) || reverse);
    });
    window_.add_tie({ids_[a], ids_[b], {0, ++name_, 0}}, {kind, Source::objects});
    if (a == b || known) return;
    NamedEdge edge{kind, features_[a], features_[b], name_, 0};
    if (kind == EdgeKind::smoothing) window_.graph().switches.back().value = edge.switch_value = name_;
    edges_.push_back(edge);
  }

  void prune() {
    const auto new_ids = window_.prune(time_, {car_, 0, 0});
    std::vector<VertexId> ids;
    std::vector<double> features;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const double ahead = features_[i] - car_;
      const bool stays = ahead > -config_.drop_behind && ahead < config_.drop_beyond;
      RC_ASSERT((new_ids[ids_[i]] != SlidingWindow::kForgotten) == stays);
      if (!stays) continue;
      ids.push_back(new_ids[ids_[i]]);
      features.push_back(features_[i]);
    }
    ids_ = ids;
    features_ = features;
    const auto has_feature = [&](double x) {
      return std::find(features_.begin(), features_.end(), x) != features_.end();
    };
    std::erase_if(edges_, [&](const NamedEdge& e) {
      return !has_feature(e.to) || (e.kind != EdgeKind::measurement && !has_feature(e.from));
    });
    std::erase_if(keyframes_, [&](double x) {
      const auto holds = [&](const NamedEdge& e) { return e.kind == EdgeKind::measurement && e.from == x; };
      return x != keyframes_.back() && std::none_of(edges_.begin(), edges_.end(), holds);
    });
  }

  void compare() const {
    const PoseGraph& graph = window_.graph();
    for (std::size_t i = 0; i < ids_.size(); ++i) RC_ASSERT(graph.vertices[ids_[i]].pose.x == features_[i]);
    RC_ASSERT(window_.feature_count() == features_.size());
    RC_ASSERT(window_.keyframe_count() == keyframes_.size());
    std::vector<NamedEdge> named;
    std::vector<std::pair<double, double>> chain;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const Edge& e = graph.edges[i];
      const double from = graph.vertices[e.from].pose.x;
      const double to = graph.vertices[e.to].pose.x;
      if (window_.origin(i).kind == EdgeKind::odometry) {
        chain.emplace_back(from, to);
        RC_ASSERT(std::abs(e.measurement.x - (to - from)) < 1e-9);
        continue;
      }
      const double value = e.switch_index == kNoSwitch ? 0 : graph.switches.at(e.switch_index).value;
      named.push_back({window_.origin(i).kind, from, to, e.measurement.y, value});
    }
    std::sort(chain.begin(), chain.end());
    RC_ASSERT(chain == links());
    std::sort(named.begin(), named.end());
    auto expected = edges_;
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(named == expected);
    const auto smoothing = testing::edges_of(window_, EdgeKind::smoothing).size();
    RC_ASSERT(graph.switches.size() == smoothing);
  }

 private:
  [[nodiscard]] std::vector<std::pair<double, double>> links() const {
    std::vector<std::pair<double, double>> result;
    for (std::size_t k = 1; k < keyframes_.size(); ++k) result.emplace_back(keyframes_[k - 1], keyframes_[k]);
    return result;
  }

  FusionConfig config_;
  SlidingWindow window_{config_};
  double car_ = 0;
  Time time_ = from_nanoseconds(0);
  double name_ = 1;
  std::vector<VertexId> ids_;     ///< of the features
  std::vector<double> features_;  ///< beside ids_: their names
  std::vector<double> keyframes_;
  std::vector<NamedEdge> edges_;
};

RC_GTEST_PROP(SlidingWindow, KeepsEdgesAndSwitchesAttachedThroughRenumbering, ()) {
  WindowAndModel both;
  both.drive(0);
  const int steps = *rc::gen::inRange(1, 120);
  for (int i = 0; i < steps; ++i) {
    const auto a = static_cast<std::size_t>(*rc::gen::inRange(0, 50));
    const auto b = static_cast<std::size_t>(*rc::gen::inRange(0, 50));
    switch (*rc::gen::inRange(0, 6)) {
      case 0:
        both.drive(static_cast<double>(a % 8));
        break;
      case 1:
        both.see(static_cast<double>(a) - 4, 0.01 * static_cast<double>(b));
        break;
      case 2:
        both.measure(a, 0.01 * static_cast<double>(b));
        break;
      case 3:
        both.tie(a, b, EdgeKind::smoothing);
        break;
      case 4:
        both.tie(a, b, EdgeKind::width);
        break;
      default:
        both.prune();
        both.compare();
    }
  }
  both.prune();
  both.compare();
}

}  // namespace
}  // namespace lanefuse
