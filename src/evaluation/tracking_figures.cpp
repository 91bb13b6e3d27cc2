// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tracking_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}
double ratio(std::uint64_t part, std::uint64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}

}  // namespace

TrackingCounts& TrackingCounts::operator+=(const TrackingCounts& other) {
  vehicles += other.vehicles;
  hits += other.hits;
  false_tracks += other.false_tracks;
  id_switches += other.id_switches;
  id_hits += other.id_hits;
  vehicle_hours += other.vehicle_hours;
  return *this;
}

double TrackingCounts::mota() const {
  return 1 - ratio(vehicles - hits + false_tracks + id_switches, vehicles);
}

double TrackingCounts::idf1() const { return ratio(2 * id_hits, vehicles + hits + false_tracks); }

double TrackingCounts::recall() const { return ratio(hits, vehicles); }

double TrackingCounts::precision() const { return ratio(hits, hits + false_tracks); }

double TrackingCounts::id_switches_per_vehicle_hour() const {
  return ratio(static_cast<double>(id_switches), vehicle_hours);
}

void TrackErrors::add(double lateral, double sigma, double heading) {
  ++n;
  lateral_squares += lateral * lateral;
  stated_variance += sigma * sigma;
  lateral_normalised += lateral * lateral / (sigma * sigma);
  heading_squares += heading * heading;
}

TrackErrors& TrackErrors::operator+=(const TrackErrors& other) {
  n += other.n;
  lateral_squares += other.lateral_squares;
  stated_variance += other.stated_variance;
  lateral_normalised += other.lateral_normalised;
  heading_squares += other.heading_squares;
  return *this;
}

double TrackErrors::lateral_rmse() const { return std::sqrt(ratio(lateral_squares, static_cast<double>(n))); }

double TrackErrors::stated_lateral() const {
  return std::sqrt(ratio(stated_variance, static_cast<double>(n)));
}

double TrackErrors::lateral_nees() const { return ratio(lateral_normalised, static_cast<double>(n)); }

double TrackErrors::heading_rmse() const { return std::sqrt(ratio(heading_squares, static_cast<double>(n))); }

TrackingFigures& TrackingFigures::operator+=(const TrackingFigures& other) {
  frames += other.frames;
  hours += other.hours;
  objects += other.objects;
  all += other.all;
  near += other.near;
  near_range = std::max(near_range, other.near_range);
  gospa_sum += other.gospa_sum;
  localisation_sum += other.localisation_sum;
  missed_sum += other.missed_sum;
  false_sum += other.false_sum;
  tracks += other.tracks;
  false_confirmed += other.false_confirmed;
  witnesses += other.witnesses;
  false_witnesses += other.false_witnesses;
  for (std::size_t bin = 0; bin < kBins; ++bin) ahead[bin] += other.ahead[bin];
  confirm_s.merge(other.confirm_s);
  confirmed += other.confirmed;
  never_confirmed += other.never_confirmed;
  return *this;
}

double TrackingFigures::gospa() const { return a_frame(gospa_sum); }

double TrackingFigures::a_frame(double sum) const { return ratio(sum, static_cast<double>(frames)); }

double TrackingFigures::an_hour(std::uint64_t count) const {
  return ratio(static_cast<double>(count), hours);
}

}  // namespace lanefuse
