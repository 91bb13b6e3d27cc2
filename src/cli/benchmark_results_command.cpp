// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/benchmark_results_command.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/comparison.hpp"
#include "benchmark/coverage.hpp"
#include "benchmark/results_file.hpp"
#include "cli/benchmark_text.hpp"
#include "cli/coverage_text.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

/// Says so where a line was cut off; all others count.
ResultsFile read_whole_lines(const std::filesystem::path& path) {
  ResultsFile file = read_results(path);
  if (file.cut_off) {
    fmt::print(stderr, "{}: its last line was cut off when a run was killed, and is left out\n",
               path.string());
  }
  return file;
}

std::vector<ResultLine> read_merged(const std::vector<std::filesystem::path>& paths) {
  std::vector<ResultsFile> files;
  std::transform(paths.begin(), paths.end(), std::back_inserter(files), read_whole_lines);
  return merge_results(files);
}

std::vector<ResultLine> read_side(const std::filesystem::path& path,
                                  const std::optional<std::string>& variant,
                                  const std::optional<std::string>& estimator) {
  std::vector<ResultLine> lines = read_merged({path});
  if (variant) std::erase_if(lines, [&](const ResultLine& line) { return line.key.variant != *variant; });
  if (estimator)
    std::erase_if(lines, [&](const ResultLine& line) { return line.key.estimator != *estimator; });
  if (lines.empty()) {
    throw configuration_error(path.string(),
                              fmt::format("holds no drive{}{}", variant ? " of variant " + *variant : "",
                                          estimator ? " of estimator " + *estimator : ""));
  }
  return lines;
}

std::vector<ResultLine> read_for_table(const ResultsTableOptions& options) {
  std::vector<ResultLine> lines = read_merged(options.files);
  if (lines.empty()) throw configuration_error(options.files.front().string(), "holds no drive");
  return lines;
}

}  // namespace

int merge_results_files(const MergeResultsOptions& options) {
  for (const auto& file : options.files) check_output(options.output, options.force, file);
  std::size_t read = 0;
  std::vector<ResultsFile> files;
  for (const auto& path : options.files) {
    files.push_back(read_whole_lines(path));
    read += files.back().lines.size();
  }
  const std::vector<ResultLine> merged = merge_results(files);
  std::string text;
  for (const ResultLine& line : merged) text += fmt::format("{}\n", line.text);
  write_text(options.output, text);
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"output", options.output.string()},
                                              {"files", files.size()},
                                              {"lines", read},
                                              {"drives", merged.size()}}
                           .dump());
  } else {
    fmt::print("{} lines of {} files, {} drives -> {}\n", read, files.size(), merged.size(),
               options.output.string());
  }
  return 0;
}

int show_results_table(const ResultsTableOptions& options) {
  const std::vector<ResultLine> lines = read_for_table(options);
  const std::vector<Summary> summaries = summarise(lines, options.by);
  if (options.json) {
    fmt::print("{}\n", to_json(summaries).dump());
  } else {
    fmt::print("{}", to_text(summaries, options.markdown));
  }
  return 0;
}

int show_coverage(const ResultsTableOptions& options) {
  const std::vector<ResultLine> lines = read_for_table(options);
  const std::vector<Coverage> coverage = coverage_of(lines, options.by);
  if (options.json) {
    fmt::print("{}\n", to_json(coverage).dump());
  } else {
    fmt::print("{}", to_text(coverage, options.markdown));
  }
  return 0;
}

int compare_results(const CompareResultsOptions& options) {
  const auto a = read_side(options.a, options.variant_a, options.estimator_a);
  const auto b = read_side(options.b, options.variant_b, options.estimator_b);
  const Comparison comparison = compare(a, b);
  if (options.json) {
    fmt::print("{}\n", to_json(comparison).dump());
  } else {
    fmt::print("{}", to_text(comparison));
  }
  return 0;
}

}  // namespace lanefuse
