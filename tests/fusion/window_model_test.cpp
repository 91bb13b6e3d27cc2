// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/window_view.hpp"

namespace lanefuse {
namespace {

using Id = SlidingWindow::Id;
using testing::EdgeKind;
using testing::WindowView;

/// An edge by names that no slot's next owner shares: the x of its vertices, which are all different, the y
/// of its measurement, and the value that its switch was given (0 for none).
struct NamedEdge {
  EdgeKind kind;
  double from, to, name, switch_value;
  friend bool operator==(const NamedEdge&, const NamedEdge&) = default;
  friend bool operator<(const NamedEdge& a, const NamedEdge& b) {
    return std::tie(a.kind, a.from, a.to, a.name) < std::tie(b.kind, b.from, b.to, b.name);
  }
};

/// The window beside a naive model of it: lists by name that are filtered.
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
    ids_.push_back(window_.add_feature({x, 0, 0}, time_).value());
    features_.push_back(x);
    measure(ids_.size() - 1, late_s);
  }

  void measure(std::size_t which, double late_s) {
    if (ids_.empty()) return;
    which %= ids_.size();
    const Id keyframe = window_.nearest_keyframe(time_ - from_seconds(late_s));
    const double from = window_.graph().pose(keyframe).x;
    const bool is_first =
        window_.add_measurement(keyframe, ids_[which], {0, ++name_, 0}, {1, 0, 1, 1}, {Source::objects, 1});
    const auto replaced = std::erase_if(edges_, [&](const NamedEdge& e) {
      return e.kind == EdgeKind::measurement && e.from == from && e.to == features_[which];
    });
    RC_ASSERT(is_first == (replaced == 0));
    edges_.push_back({EdgeKind::measurement, from, features_[which], name_, 0});
  }

  void tie(std::size_t a, std::size_t b, TieKind tie_kind) {
    if (ids_.empty()) return;
    a %= ids_.size();
    b %= ids_.size();
    const EdgeKind kind = tie_kind == TieKind::width ? EdgeKind::width : EdgeKind::smoothing;
    const bool known = std::any_of(edges_.begin(), edges_.end(), [&](const NamedEdge& e) {
      const bool reverse = e.from == features_[b] && e.to == features_[a] && kind == EdgeKind::smoothing;
      return e.kind == kind && ((e.from == features_[a] && e.to == features_[b]) || reverse);
    });
    window_.add_tie(tie_kind, {ids_[a], ids_[b], {0, ++name_, 0}}, {});
    if (a == b || known) return;
    NamedEdge edge{kind, features_[a], features_[b], name_, 0};
    // The newest of a feature's ties comes first.
    if (kind == EdgeKind::smoothing)
      window_.graph().set_switch(window_.graph().first_tie(ids_[a]), edge.switch_value = name_);
    edges_.push_back(edge);
  }

  void prune() {
    window_.prune(time_, {car_, 0, 0});
    std::vector<Id> ids;
    std::vector<double> features;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const double ahead = features_[i] - car_;
      const bool stays = ahead > -config_.drop_behind && ahead < config_.drop_beyond;
      RC_ASSERT(window_.graph().is_alive(ids_[i]) == stays);
      if (!stays) continue;
      ids.push_back(ids_[i]);
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
    const WindowView view(window_);
    const PoseGraph& graph = view.graph();
    for (std::size_t i = 0; i < ids_.size(); ++i)
      RC_ASSERT(window_.graph().landmark(ids_[i]).x == features_[i]);
    RC_ASSERT(window_.feature_count() == features_.size());
    RC_ASSERT(window_.keyframe_count() == keyframes_.size());
    std::vector<NamedEdge> named;
    std::vector<std::pair<double, double>> chain;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const Edge& e = graph.edges[i];
      const double from = graph.vertices[e.from].pose.x;
      const double to = graph.vertices[e.to].pose.x;
      if (view.origin(i).kind == EdgeKind::odometry) {
        chain.emplace_back(from, to);
        RC_ASSERT(std::abs(e.measurement.x - (to - from)) < 1e-9);
        continue;
      }
      const double value = e.switch_index == kNoSwitch ? 0 : graph.switches.at(e.switch_index).value;
      named.push_back({view.origin(i).kind, from, to, e.measurement.y, value});
    }
    std::sort(chain.begin(), chain.end());
    RC_ASSERT(chain == links());
    std::sort(named.begin(), named.end());
    auto expected = edges_;
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(named == expected);
    const auto smoothing = view.edges_of(EdgeKind::smoothing).size();
    RC_ASSERT(graph.switches.size() == smoothing);
    RC_ASSERT(window_.edge_count() == graph.edges.size());
    RC_ASSERT(graph.edges.size() == chain.size() + named.size());
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
  std::vector<Id> ids_;           ///< of the features
  std::vector<double> features_;  ///< beside ids_: their names
  std::vector<double> keyframes_;
  std::vector<NamedEdge> edges_;
};

RC_GTEST_PROP(SlidingWindow, KeepsIdsEdgesAndSwitchesThroughAllForgetting, ()) {
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
        both.tie(a, b, TieKind::smoothing);
        break;
      case 4:
        both.tie(a, b, TieKind::width);
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
