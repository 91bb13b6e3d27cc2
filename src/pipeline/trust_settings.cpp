// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/trust_settings.hpp"

#include <utility>

namespace lanefuse {

void add_trust_settings(const Section& s, SensorTrustConfig& c) {
  constexpr std::pair<double, double> kVotes{1.0, 1000.0};
  constexpr std::pair<double, double> kSeconds{0.1, 60.0};
  s.add("min_speed", c.min_speed, {0.5, 50.0}, "m/s", "of the own car: slower, no sensor is judged");
  s.add("memory_s", c.memory_s, kSeconds, "s", "over which sensors' words of each other are forgotten");
  s.add("enough", c.enough, kVotes, "", "such words before anything is said");
  s.add("ratio", c.ratio, {1.0, 100.0}, "", "times as many must say wrong as sound");
  s.add("recover_s", c.recover_s, kSeconds, "s", "for which a distrusted sensor must be sound again");
  s.add("repeats", c.repeats, {1, 100}, "", "of a look with several detections: frozen");
  s.add("repeats_single", c.repeats_single, {1, 100}, "", "of a look with one");
  s.add("proof_memory_s", c.proof_memory_s, kSeconds, "s", "over which standing things' word is forgotten");
  s.add("proof", c.proof, kVotes, "", "votes of standing things that prove on which side they are");
  s.add("pairs", c.pairs, kVotes, "", "of bearings that must agree before a sensor is said to be turned");
  s.add("turned_deg", c.turned_deg, {2.0, 14.0}, "deg", "off before a sensor is said to be turned");
  s.add("blind_s", c.blind_s, {0.5, 3.5}, "s", "without a word beside vehicles: blind");
}

void add_alignment_settings(const Section& s, RadarAlignmentConfig& c) {
  constexpr std::pair<double, double> kDegrees{1e-6, 5.0};
  constexpr std::pair<double, double> kDrift{0.0, 1.0};
  s.add("enabled", c.enabled, "whether radars' turns are found by things that stand, and corrected");
  s.add("sigma_deg", c.sigma_deg, kDegrees, "deg", "of a mounting before anything is known");
  s.add("drift_deg", c.drift_deg, kDrift, "deg/sqrt(s)", "by which mountings settle");
  s.add("most_deg", c.most_deg, {0.0, 5.0}, "deg", "more is never corrected");
  s.add("yaw_rate_sigma_deg", c.yaw_rate_sigma_deg, kDegrees, "deg/s", "that the yaw rate is off by");
  s.add("yaw_rate_drift_deg", c.yaw_rate_drift_deg, kDrift, "deg/s/sqrt(s)", "by which that changes");
}

}  // namespace lanefuse
