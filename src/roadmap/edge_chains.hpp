// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "roadmap/lane_strips.hpp"

namespace lanefuse {

/// The edges of all strips, each once though two neighbours share it, and which of them runs on in which.
class EdgeChains {
 public:
  explicit EdgeChains(const std::vector<LaneStrip>& strips);

  /// The edge on that side of a strip, by its number. The numbers have no order.
  [[nodiscard]] std::size_t edge_of(std::size_t strip, StripSide side) const;
  [[nodiscard]] std::optional<std::size_t> next(std::size_t edge) const { return next_[edge]; }
  [[nodiscard]] std::optional<std::size_t> previous(std::size_t edge) const { return previous_[edge]; }
  /// How many strips have this edge.
  [[nodiscard]] int users(std::size_t edge) const { return users_[edge]; }
  [[nodiscard]] std::size_t size() const { return users_.size(); }
  /// The edge's points and styles.
  [[nodiscard]] const StripEdge& shape(std::size_t edge) const { return *shapes_[edge]; }
  /// The first edge of the chain that holds this one.
  [[nodiscard]] std::size_t first_of_chain(std::size_t edge) const;
  /// The edge and the one after it run on no longer.
  void cut_after(std::size_t edge);

 private:
  struct Link {
    std::size_t from = 0;
    std::size_t to = 0;
    double bend = 0;  ///< [rad] between the two edges
  };

  void share_between_neighbours();
  void share(std::size_t left_strip, std::size_t right_strip);
  void number_edges();
  [[nodiscard]] std::vector<Link> possible_links() const;
  void link();

  const std::vector<LaneStrip>& strips_;
  std::vector<std::size_t> edge_of_;  ///< by 2 * strip + side
  std::vector<const StripEdge*> shapes_;
  std::vector<int> users_;
  std::vector<std::optional<std::size_t>> next_;
  std::vector<std::optional<std::size_t>> previous_;
};

}  // namespace lanefuse
