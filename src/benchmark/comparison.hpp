// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/drive_statistics.hpp"
#include "benchmark/figure.hpp"
#include "benchmark/result_line.hpp"

namespace lanefuse {

enum class Verdict {
  better,  ///< B is, and so large a difference would hardly be chance
  worse,
  noise,   ///< what is seen may be chance
  unknown  ///< too few drives to say
};
const char* to_string(Verdict verdict);

/// How one figure changed from A to B.
struct FigureChange {
  const BenchmarkFigure* figure = nullptr;
  double in_a = 0;  ///< mean over the drives that were compared
  double in_b = 0;
  Difference change;             ///< B minus A
  std::size_t drives = 0;        ///< pairs, or drives of the smaller side
  std::optional<double> chance;  ///< the probability, corrected for the number of figures looked at (Holm)
  Verdict verdict = Verdict::unknown;
};

struct Comparison {
  std::size_t pairs = 0;  ///< drives that both sides have; 0: the sides were compared as a whole
  std::size_t only_in_a = 0;
  std::size_t only_in_b = 0;
  std::vector<FigureChange> figures;  ///< those that both sides have
};

/// A difference counts where its corrected probability is below this.
inline constexpr double kSignificance = 0.05;

/// Compares two sides drive by drive: the same scene, road, seed, length and truth. Where each
/// side holds one variant, they are compared whatever they are called, else those of one name; so are
/// estimators. Where no
/// drive is in both, the sides are compared as a whole if they hold the same kinds of drives.
///
/// Throws a configuration Error where there is nothing to compare, where presets differ or
/// the scenarios of one scene do, and where one side holds a drive twice.
Comparison compare(std::span<const ResultLine> a, std::span<const ResultLine> b);

}  // namespace lanefuse
