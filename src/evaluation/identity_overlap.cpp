// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/identity_overlap.hpp"

#include <set>
#include <vector>

#include "core/assignment.hpp"

namespace lanefuse {

std::uint64_t IdentityOverlap::id_hits() const {
  std::set<Visit> vehicles;
  std::set<Visit> tracks;
  for (const auto& [pair, frames] : frames_) {
    vehicles.insert(pair.first);
    tracks.insert(pair.second);
  }
  const auto index_in = [](const std::set<Visit>& ids) {
    std::map<Visit, std::size_t> index;
    for (const Visit& id : ids) index.emplace(id, index.size());
    return index;
  };
  const auto row_of = index_in(vehicles);
  const auto column_of = index_in(tracks);
  std::vector<double> costs(vehicles.size() * tracks.size(), Assignment::kForbidden);
  for (const auto& [pair, frames] : frames_)
    costs[row_of.at(pair.first) * tracks.size() + column_of.at(pair.second)] = -static_cast<double>(frames);

  Assignment assignment;
  const auto chosen =
      assignment.solve(static_cast<int>(vehicles.size()), static_cast<int>(tracks.size()), costs, 0);
  double hits = 0;
  for (std::size_t row = 0; row < chosen.size(); ++row)
    if (chosen[row] != Assignment::kAlone)
      hits -= costs[row * tracks.size() + static_cast<std::size_t>(chosen[row])];
  return static_cast<std::uint64_t>(hits);
}

}  // namespace lanefuse
