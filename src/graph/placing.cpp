// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/placing.hpp"

#include <algorithm>
#include <deque>

namespace lanefuse {

namespace {

class Placing {
 public:
  Placing(PoseGraph& graph, std::vector<bool> placed) : graph_(graph), placed_(std::move(placed)) {
    for (VertexId v = 0; v < placed_.size(); ++v) {
      if (graph.vertices[v].fixed) placed_[v] = true;
    }
  }

  /// Follows edges from all that is placed, in the order in which vertices were reached.
  void spread(const std::vector<const Edge*>& edges);

  [[nodiscard]] std::optional<VertexId> unplaced() const {
    const auto lost = std::find(placed_.begin(), placed_.end(), false);
    if (lost == placed_.end()) return std::nullopt;
    return static_cast<VertexId>(lost - placed_.begin());
  }

 private:
  bool follow(const Edge& edge, VertexId known);

  PoseGraph& graph_;
  std::vector<bool> placed_;
};

/// Places the other end of the edge, unless it has a place.
bool Placing::follow(const Edge& edge, VertexId known) {
  const VertexId other = known == edge.from ? edge.to : edge.from;
  if (placed_[other]) return false;
  const Pose2 step = known == edge.from ? edge.measurement : edge.measurement.inverse();
  graph_.vertices[other].pose = graph_.vertices[known].pose * step;
  placed_[other] = true;
  return true;
}

void Placing::spread(const std::vector<const Edge*>& edges) {
  std::vector<std::vector<const Edge*>> edges_of(placed_.size());
  for (const Edge* edge : edges) {
    edges_of[edge->from].push_back(edge);
    edges_of[edge->to].push_back(edge);
  }
  std::deque<VertexId> front;
  for (VertexId v = 0; v < placed_.size(); ++v) {
    if (placed_[v]) front.push_back(v);
  }
  for (; !front.empty(); front.pop_front()) {
    const VertexId known = front.front();
    for (const Edge* edge : edges_of[known]) {
      if (follow(*edge, known)) front.push_back(known == edge->from ? edge->to : edge->from);
    }
  }
}

}  // namespace

std::optional<VertexId> place_along_edges(PoseGraph& graph, const std::vector<std::int64_t>& ids,
                                          std::vector<bool> placed) {
  Placing placing(graph, std::move(placed));
  if (!placing.unplaced()) return std::nullopt;
  std::vector<const Edge*> all;
  std::vector<const Edge*> chain;
  for (const Edge& edge : graph.edges) {
    all.push_back(&edge);
    const auto [low, high] = std::minmax({ids[edge.from], ids[edge.to]});
    if (low + 1 == high) chain.push_back(&edge);
  }
  placing.spread(chain);
  placing.spread(all);
  return placing.unplaced();
}

}  // namespace lanefuse
