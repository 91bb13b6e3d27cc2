// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "graph/place_comparison.hpp"

namespace lanefuse {

/// `lanefuse graph convert IN OUT`: the format follows from the ending.
struct GraphConvertOptions {
  std::filesystem::path file;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

/// `lanefuse graph spoil FILE`.
struct GraphSpoilOptions {
  std::filesystem::path file;
  std::filesystem::path output;
  std::size_t outliers = 0;
  std::uint64_t seed = 1;
  bool switchable = false;  ///< write all loop closures, false and true, as switchable edges
  double switch_prior = 1;
  bool json = false;
  bool force = false;
};

/// `lanefuse graph compare A B`.
struct GraphCompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  bool json = false;
  bool force = false;
};

/// Writes a graph in another format; what that format has no words for is told on standard error.
int graph_convert(const GraphConvertOptions& options);

/// Adds false loop closures (`add_false_loops`): same seed, same bytes.
int graph_spoil(const GraphSpoilOptions& options);

/// Says how far the places of one solution are from another's.
int graph_compare(const GraphCompareOptions& options);

nlohmann::ordered_json describe(const PlaceComparison& comparison);
std::string in_words(const PlaceComparison& comparison);
void tell_losses(const std::filesystem::path& output, const std::vector<std::string>& losses);

}  // namespace lanefuse
