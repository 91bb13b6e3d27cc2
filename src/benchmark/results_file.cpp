// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/results_file.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

Error cannot_write(const std::filesystem::path& path) {
  return input_error(path.string(), "could not be written", "is there room on the disk?");
}

/// What a killed run leaves is the beginning of a line; anything else is somebody's file.
void demand_begun_line(const std::string& text, const std::string& place) {
  constexpr std::string_view kBegin = R"({"scene":")";
  const std::size_t compared = std::min(text.size(), kBegin.size());
  if (text.substr(0, compared) != kBegin.substr(0, compared)) {
    throw input_error(place, "is no line of benchmark results");
  }
}

void demand_no_contradiction(const ResultLine& a, const ResultLine& b) {
  demand_same_provenance(a, b);
  if (same_figures(a, b)) return;
  throw input_error(b.place, fmt::format("contradicts {}: other figures for {}", a.place, to_string(b.key)),
                    "the same drive gives the same figures: one of the two was made by other code");
}

}  // namespace

ResultsFile read_results(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path)) throw input_error(path.string(), "cannot be read");
  ResultsFile file{path, {}, 0, false};
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    if (in.eof()) {  // no end of a line: the run that wrote it was killed
      demand_begun_line(text, fmt::format("{}:{}", path.string(), number));
      file.cut_off = true;
      break;
    }
    file.lines.push_back(parse_line(text, fmt::format("{}:{}", path.string(), number)));
    file.whole_bytes += text.size() + 1;
  }
  if (in.bad()) throw input_error(path.string(), "cannot be read");
  return file;
}

std::vector<ResultLine> merge_results(const std::vector<ResultsFile>& files) {
  std::map<DriveKey, const ResultLine*> by_key;
  for (const ResultsFile& file : files) {
    for (const ResultLine& line : file.lines) {
      const auto [known, is_new] = by_key.emplace(line.key, &line);
      if (!is_new) demand_no_contradiction(*known->second, line);
    }
  }
  std::vector<ResultLine> merged;
  for (const auto& [key, line] : by_key) merged.push_back(*line);
  return merged;
}

ResultsWriter::ResultsWriter(std::filesystem::path path, std::uintmax_t kept_bytes) : path_(std::move(path)) {
  std::error_code failed;
  if (std::filesystem::exists(path_, failed)) std::filesystem::resize_file(path_, kept_bytes, failed);
  if (!failed) out_.open(path_, std::ios::binary | std::ios::app);
  if (failed || !out_) throw cannot_write(path_);
}

void ResultsWriter::append(const std::string& line) {
  out_ << fmt::format("{}\n", line) << std::flush;
  if (!out_) throw cannot_write(path_);
}

}  // namespace lanefuse
