// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace lanefuse {

/// A landmark that is tied to other landmarks, as the rungs and rails of a ladder are.
struct LadderNode {
  std::vector<std::uint32_t> ties;   ///< other nodes, ascending
  std::vector<std::uint32_t> poses;  ///< blocks of poses, ascending
};

/// Eliminates every node in the order of least degree and returns that order. Afterwards each node's ties and
/// poses are those it has when its turn comes: its own and the fill left by those before it.
std::vector<std::uint32_t> eliminate_ladder(std::vector<LadderNode>& nodes);

}  // namespace lanefuse
