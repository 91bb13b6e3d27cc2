// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kRightmostPace = 28;     ///< [m/s] usual speed of cars in the right lane
constexpr double kPaceStep = 3;           ///< [m/s] more in each lane further left
constexpr double kShareOfHeadway = 0.6;   ///< of the mean headway is the least, in dense traffic
constexpr double kMeanLength = 6;         ///< [m] of a vehicle
constexpr double kContent = 0.85;         ///< of its wish for speed is what everyone gets in dense traffic
constexpr double kCrawl = 2;              ///< [m/s] of the densest traffic
constexpr double kWavesBelow = 15;        ///< [m/s] a slower flow goes in waves
constexpr double kStandstillsBelow = 10;  ///< [m/s] in which a slower one stands still for a moment
constexpr double kFullWave = 1.15;        ///< swing that makes it stand still
constexpr double kWaveLength = 600;       ///< [m]
constexpr double kWaveSpeed = 4.2;        ///< [m/s] backwards, the same on every motorway

/// Of drivers who follow each other so closely, nearly as fast as they wish: the nearer they are to their
/// wish, the wider the gap that they like.
double following_speed(double density) {
  const CarFollowing driver;
  const double close_gap = (1 / density - kMeanLength) * std::sqrt(1 - std::pow(kContent, 4));
  return std::max(kCrawl, (close_gap - driver.standstill_gap) / driver.headway / kContent);
}

double wave_of(double speed) {
  return std::clamp((kWavesBelow - speed) / (kWavesBelow - kStandstillsBelow), 0.0, 1.0) * kFullWave;
}

}  // namespace

double usual_speed(int lanes_to_the_right) { return kRightmostPace + kPaceStep * lanes_to_the_right; }

TrafficFlow::TrafficFlow(const TrafficConfig& config)
    : density_(config.preset.vehicles_per_metre_lane),
      least_headway_(density_ > 0 ? std::min(kFreeHeadway, kShareOfHeadway / density_) : kFreeHeadway),
      speed_(config.jam_speed                ? *config.jam_speed
             : least_headway_ < kFreeHeadway ? following_speed(density_)
                                             : INFINITY),
      wave_(wave_of(speed_)) {}

double TrafficFlow::speed_limit(double station, double time) const {
  if (wave_ == 0) return speed_;
  const double phase = 2 * std::numbers::pi * (station + kWaveSpeed * time) / kWaveLength;
  return std::max(0.0, speed_ * (1 + wave_ * std::sin(phase)));
}

double TrafficFlow::mean_gap() const { return dense() ? 1 / density_ - kMeanLength : INFINITY; }

double TrafficFlow::draw_headway(Random& random) const {
  if (density_ <= 0) return INFINITY;
  return least_headway_ + random.exponential(std::max(1.0, 1 / density_ - least_headway_));
}

}  // namespace lanefuse
