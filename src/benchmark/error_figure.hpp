// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace lanefuse {

/// Errors that have been summed up, with the share that their own uncertainty covered.
struct ErrorFigure {
  std::uint64_t count = 0;
  std::uint64_t covered = 0;  ///< within 1.96 sigma: 95 % should be
  double sum = 0;
  double sum_of_squares = 0;
  double sum_of_normalised = 0;  ///< of (error / sigma)^2

  void add(double error) {
    ++count;
    sum += error;
    sum_of_squares += error * error;
  }
  void add(double error, double sigma) {
    add(error);
    if (std::abs(error) <= 1.959964 * sigma) ++covered;
    sum_of_normalised += error * error / (sigma * sigma);
  }
  ErrorFigure& operator+=(const ErrorFigure& other) {
    count += other.count;
    covered += other.covered;
    sum += other.sum;
    sum_of_squares += other.sum_of_squares;
    sum_of_normalised += other.sum_of_normalised;
    return *this;
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
  [[nodiscard]] double rmse() const {
    return count == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(count));
  }
  /// Mean of the squared errors by their own variances: 1 where the uncertainty is right.
  [[nodiscard]] double consistency() const {
    return count == 0 ? 0 : sum_of_normalised / static_cast<double>(count);
  }
  [[nodiscard]] double coverage() const {
    return count == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(count);
  }
};

/// How many of a number of things.
struct Share {
  std::uint64_t count = 0;
  std::uint64_t of = 0;
  void add(bool is) {
    ++of;
    if (is) ++count;
  }
  Share& operator+=(const Share& other) {
    count += other.count;
    of += other.of;
    return *this;
  }
  [[nodiscard]] double value() const {
    return of == 0 ? 0 : static_cast<double>(count) / static_cast<double>(of);
  }
};

}  // namespace lanefuse
