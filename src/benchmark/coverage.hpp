// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/figure.hpp"
#include "benchmark/result_line.hpp"
#include "benchmark/summary.hpp"

namespace lanefuse {

/// An interval by its name: it should hold this share of the deviations, and may miss it by so much.
struct CoverageLevel {
  double share = 0;
  double tolerance = 0;
};
inline constexpr std::array<CoverageLevel, 3> kCoverageLevels{{{0.68, 0.03}, {0.95, 0.02}, {0.99, 0.007}}};

/// So many drives at least say whether intervals cover: a camera's yaw is one draw a drive.
inline constexpr std::size_t kEnoughDrives = 200;

enum class CoverageVerdict {
  honest,      ///< every interval holds what it says, within its tolerance
  too_narrow,  ///< some hold less: the estimate believes too much in itself
  too_wide,    ///< some hold more: it is timid
  wrong_tails  ///< some hold more and others less: the errors are not normal
};
const char* to_string(CoverageVerdict verdict);

/// Whether one lane's stated uncertainty is honest at one distance, over drives. Figures that no line has are
/// nothing.
struct CoverageAt {
  double distance_m = 0;
  std::array<std::optional<FigureMean>, 3> within;  ///< shares in [0, 1], in the order of kCoverageLevels
  std::optional<FigureMean> stated_sigma;           ///< [m] mean
  std::optional<FigureMean> rmse;                   ///< [m]
  std::optional<FigureMean> nees;
  std::optional<FigureMean> protection;       ///< [m] mean, of those that are vouched for
  std::optional<FigureMean> misleading_rate;  ///< share of them that a deviation was beyond
  std::uint64_t n_protected = 0;              ///< deviations with a protection level
  std::optional<CoverageVerdict> verdict;     ///< nothing where nothing was stated
  bool certain = false;                       ///< the drives' scatter leaves no doubt about the verdict
};

/// One row of drives.
struct Coverage {
  std::string name;  ///< of its group
  std::string estimator;
  std::string truth;
  double km = 0;     ///< a drive
  double noise = 1;  ///< sensors err so many times as much as they say
  std::size_t drives = 0;
  std::vector<CoverageAt> ego;  ///< at 0, 10 ... 120 m
  std::vector<CoverageAt> adjacent;
};

/// How many of the row's verdicts are honest, and how many there are.
struct HonestCount {
  std::size_t honest = 0;
  std::size_t of = 0;
};
HonestCount honest_count(const Coverage& coverage);

/// Pools lines as summarise() does, each weighted by its number of deviations, with Student's t over drives
/// for the intervals. Throws as summarise().
std::vector<Coverage> coverage_of(std::span<const ResultLine> lines, GroupBy by);

}  // namespace lanefuse
