// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "benchmark/drive_key.hpp"

namespace lanefuse {

/// What a drive's figures depend on, beside its key.
struct Provenance {
  std::string version;        ///< of Lanefuse
  std::string preset;         ///< hash of the simulator's sensor preset's file, whatever the key's noise
  std::string scene;          ///< hash of the scene's scenario file
  std::string configuration;  ///< hash of the pipeline's configuration
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// The line of one drive in a file of results, as in docs/benchmark.md.
struct ResultLine {
  DriveKey key;
  Provenance provenance;
  nlohmann::ordered_json json;
  std::string text;   ///< as it stands in the file, without the end of the line
  std::string place;  ///< file and line
};

/// The head of every line: key and provenance. A noise of one is left out, as in files from before there was
/// any other.
nlohmann::ordered_json head_json(const DriveKey& key, const Provenance& provenance);

/// Throws an input Error that names `place` where the text is no line of results.
ResultLine parse_line(const std::string& text, const std::string& place);

/// Whether two lines say the same; wall-clock times differ from run to run, and say nothing.
bool same_figures(const ResultLine& a, const ResultLine& b);

/// What two provenances differ in, in words: "preset (... here, ... there)". They must differ.
std::string differing(const Provenance& here, const Provenance& there);

/// Refuses, with an input Error that names both places, two lines of one key that were made from different
/// presets, scenarios, configurations or versions.
void demand_same_provenance(const ResultLine& a, const ResultLine& b);

/// The keys that hold wall-clock times.
inline constexpr const char* kTimeKeys[] = {"cycle_ms", "stage_s", "wall_s"};

}  // namespace lanefuse
