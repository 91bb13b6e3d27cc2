// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/random.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "core/hash.hpp"

namespace lanefuse {
namespace {

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15ULL;

}  // namespace

Random::Random(std::uint64_t seed, std::string_view stream)
    : state_(mix(mix(seed + kGoldenStep) ^ fnv1a(stream))) {}

std::uint64_t Random::bits() { return mix(state_ += kGoldenStep); }

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double Random::uniform(double low, double high) { return low + (high - low) * uniform(); }

double Random::normal(double sigma) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return sigma * radius * std::cos(2 * std::numbers::pi * uniform());
}

double Random::exponential(double mean) { return -mean * std::log(1 - uniform()); }

int Random::poisson(double mean) {
  const double limit = std::exp(-mean);
  int count = 0;
  for (double product = uniform(); product > limit; product *= uniform()) ++count;
  return count;
}

Wander::Wander(double sigma, double tau, Random& random)
    : sigma_(sigma), tau_(tau), value_(random.normal(sigma)) {
  assert(sigma >= 0 && tau > 0);
}

void Wander::advance(double step, Random& random) {
  const double kept = std::exp(-step / tau_);
  value_ = kept * value_ + random.normal(sigma_ * std::sqrt(1 - kept * kept));
}

}  // namespace lanefuse
