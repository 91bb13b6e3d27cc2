// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace lanefuse {

/// A seeded source of random numbers whose every step is written here, because the standard library's
/// distributions differ from one implementation to the next: same seed, same numbers. (SplitMix64: Steele,
/// Lea, Flood 2014.)
class Random {
 public:
  /// Each `stream` of a seed is a sequence of its own: a sensor that is switched off takes nothing from the
  /// others.
  Random(std::uint64_t seed, std::string_view stream);

  std::uint64_t bits();
  double uniform();                         ///< in [0, 1)
  double uniform(double low, double high);  ///< in [low, high)
  double normal(double sigma);              ///< mean zero
  double exponential(double mean);
  int poisson(double mean);  ///< of a mean up to some tens
  /// Each of the whole numbers from `low` to `high` as likely as the others.
  int whole(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t state_;
};

/// A number that wanders around zero and forgets with time constant `tau`: a stationary Ornstein-Uhlenbeck
/// process, stepped exactly for any step length. Time may as well be a way [m].
class Wander {
 public:
  Wander(double sigma, double tau, Random& random);  ///< starts in its stationary distribution
  void advance(double step, Random& random);
  [[nodiscard]] double value() const { return value_; }

 private:
  double sigma_;
  double tau_;
  double value_;
};

}  // namespace lanefuse
