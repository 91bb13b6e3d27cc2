// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "benchmark/drive_statistics.hpp"

namespace lanefuse {

/// One number that a drive is judged by, and how it is read, averaged and compared.
struct BenchmarkFigure {
  enum class Better { lower, higher };
  enum class Mean {
    plain,       ///< over drives
    root_square  ///< root of the mean square, drives weighted by their deviations: the RMSE of all of them
  };

  std::string name;    ///< "ego RMSE at 60 m"
  std::string unit;    ///< "m", empty for none
  std::string value;   ///< where it stands in a line of results, as a JSON pointer
  std::string weight;  ///< the same for the number of deviations behind it; empty where each drive counts one
  Better better = Better::lower;
  Mean mean = Mean::plain;
};

inline constexpr std::size_t kShownDistances = 7;  ///< 0, 20 ... 120 m, as in the paper's Table I

/// The figures in the order in which they are shown: RMSE of the ego lane by distance, of the adjacent ones,
/// then those of OtherFigure.
std::span<const BenchmarkFigure> figures();
std::size_t rmse_figure(bool adjacent, std::size_t shown_distance);

/// The places of the others in figures().
enum OtherFigure : std::size_t {
  kEgoReaches = 2 * kShownDistances,
  kAdjacentReaches,
  kFalseLanes,
  kWrongLane,
  kCycleMedian,
  kCycleSlow,
  kFigureCount
};

/// What a line says of a figure, as is; nothing where it is null or not there.
std::optional<double> value_of(const BenchmarkFigure& figure, const nlohmann::ordered_json& line);

/// The same as mean_of() takes it: squared where the mean is of squares. Nothing, too, where no deviation is
/// behind it.
std::optional<DriveSample> sample_of(const BenchmarkFigure& figure, const nlohmann::ordered_json& line);

/// A figure over drives, with its 95 % confidence interval (nothing from fewer than two drives).
struct FigureMean {
  double value = 0;
  std::optional<double> low;
  std::optional<double> high;
  std::size_t drives = 0;
};

/// Nothing where no line has the figure.
std::optional<FigureMean> mean_of(const BenchmarkFigure& figure,
                                  std::span<const nlohmann::ordered_json* const> lines);

}  // namespace lanefuse
