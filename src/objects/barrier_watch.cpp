// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/barrier_watch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kReach = 40;      ///< [m] ahead and behind: nearer the road is as good as straight
constexpr double kStanding = 1.0;  ///< [m/s] over ground
constexpr double kSlant = 0.4;     ///< cosine of the steepest angle to our way that tells
constexpr double kSlowest = 5;     ///< [m/s] below, a queue looks like a wall
constexpr int kStationsOfLine = 12;
constexpr double kNearest = 2.5;  ///< [m] nothing nearer is beside the lane

std::uint64_t bit_of(std::int64_t station) {
  return std::uint64_t{1} << static_cast<unsigned>(((station % 64) + 64) % 64);
}

}  // namespace

void BarrierWatch::look(const SightingSet& look, double seconds) {
  const double speed = look.velocity.norm();
  const auto before = static_cast<std::int64_t>(std::floor(way_ / kStation));
  way_ += speed * std::max(0.0, seconds);
  forget(before, static_cast<std::int64_t>(std::floor(way_ / kStation)));
  if (look.kind != SightingKind::radar || speed < kSlowest) return;
  const Pose2 vehicle_from_sensor = look.odometry_from_vehicle.inverse() * look.odometry_from_sensor;
  for (const Sighting& sighting : look.sightings) {
    if (!sighting.range_rate || sighting.range > kReach) continue;
    const double angle = look.odometry_from_sensor.heading + sighting.bearing;
    const double own = look.velocity.x() * std::cos(angle) + look.velocity.y() * std::sin(angle);
    // Of what drives beside us the range does not change either.
    if (std::abs(own) < kSlant * speed || std::abs(*sighting.range_rate + own) > kStanding) continue;
    const Eigen::Vector2d at =
        vehicle_from_sensor * Eigen::Vector2d(sighting.range * std::cos(sighting.bearing),
                                              sighting.range * std::sin(sighting.bearing));
    const double across = at.y() - look.own_curvature * at.x() * at.x() / 2;
    const auto bin = static_cast<int>(std::lround(across / kBin));
    // Straight ahead and behind, what drives along with us at our own speed is not told from what stands.
    if (std::abs(across) < kNearest || std::abs(bin) > kBins) continue;
    const auto station = static_cast<std::int64_t>(std::floor((way_ + at.x()) / kStation));
    stood_[static_cast<std::size_t>(bin + kBins)] |= bit_of(station);
  }
  find_lines();
}

/// The stations that come into reach are those of long ago, under the same bits.
void BarrierWatch::forget(std::int64_t from, std::int64_t to) {
  const auto ahead = static_cast<std::int64_t>(kReach / kStation) + 1;
  for (std::int64_t station = from + 1; station <= std::min(to, from + 64); ++station) {
    const std::uint64_t keep = ~bit_of(station + ahead);
    for (std::uint64_t& bits : stood_) bits &= keep;
  }
}

bool BarrierWatch::is_line(int bin) const {
  std::uint64_t bits = 0;
  for (int b = std::max(0, bin - 1); b <= std::min(2 * kBins, bin + 1); ++b) {
    bits |= stood_[static_cast<std::size_t>(b)];
  }
  return std::popcount(bits) >= kStationsOfLine;
}

void BarrierWatch::find_lines() {
  left_ = kFar;
  right_ = -kFar;
  for (int bin = 1; bin <= kBins && left_ == kFar; ++bin) {
    if (is_line(kBins + bin)) left_ = bin * kBin;
  }
  for (int bin = 1; bin <= kBins && right_ == -kFar; ++bin) {
    if (is_line(kBins - bin)) right_ = -bin * kBin;
  }
}

}  // namespace lanefuse
