// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "graph/edge_terms.hpp"
#include "graph/elimination_order.hpp"

namespace lanefuse {

/// Terms between poses whose switch has all but turned them off.
///
/// A false loop closure costs far more than it weighs: a block that joins two distant poses fills the factor,
/// and a thousand of them make a sparse system a dense one. What such a term pulls with still counts, and so
/// does its own share of either pose; only what it joins is left out of the equations' matrix. The minimum
/// that is found is therefore the same, and the steps differ by what the term weighs.
class WeakTerms {
 public:
  void clear() { joins_nothing_.clear(); }

  /// Looks at the terms' weights as of their last evaluation. True if what is left out should change now: if
  /// a term has grown heavy that is left out, or if so many have grown light that new equations are worth it.
  bool update(const EdgeTerms& terms, const EliminationOrder& order);

  /// Whether the matrix leaves out what this term joins.
  [[nodiscard]] bool joins_nothing(std::size_t term) const {
    return !joins_nothing_.empty() && joins_nothing_[term] != 0;
  }

 private:
  std::vector<char> joins_nothing_;  ///< beside the terms; empty for none
};

}  // namespace lanefuse
