// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/ladder.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace lanefuse {

namespace {

using Queue = std::set<std::pair<std::size_t, std::uint32_t>>;

std::pair<std::size_t, std::uint32_t> place_in_queue(const std::vector<LadderNode>& nodes,
                                                     std::uint32_t node) {
  return {nodes[node].ties.size() + nodes[node].poses.size(), node};
}

/// `sorted` becomes the union of itself and `more`.
void unite(std::vector<std::uint32_t>& sorted, const std::vector<std::uint32_t>& more,
           std::vector<std::uint32_t>& scratch) {
  scratch.clear();
  std::set_union(sorted.begin(), sorted.end(), more.begin(), more.end(), std::back_inserter(scratch));
  sorted.swap(scratch);
}

}  // namespace

std::vector<std::uint32_t> eliminate_ladder(std::vector<LadderNode>& nodes) {
  Queue queue;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) queue.insert(place_in_queue(nodes, i));
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> scratch;
  while (!queue.empty()) {
    const std::uint32_t gone = queue.begin()->second;
    queue.erase(queue.begin());
    order.push_back(gone);
    for (const std::uint32_t heir : nodes[gone].ties) {
      queue.erase(place_in_queue(nodes, heir));
      unite(nodes[heir].poses, nodes[gone].poses, scratch);
      unite(nodes[heir].ties, nodes[gone].ties, scratch);
      std::erase_if(nodes[heir].ties, [&](std::uint32_t tie) { return tie == gone || tie == heir; });
      queue.insert(place_in_queue(nodes, heir));
    }
  }
  return order;
}

}  // namespace lanefuse
