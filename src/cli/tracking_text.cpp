// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/tracking_text.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

namespace lanefuse {
namespace {

constexpr double kToDegrees = 180 / std::numbers::pi;

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

/// The lines of the table, each with what a tracker says in it.
class Lines {
 public:
  using Cell = std::function<std::string(const TrackingFigures&)>;

  explicit Lines(const std::vector<NamedTracking>& trackers) : trackers_(trackers) {
    text_ = fmt::format("{:44}", "");
    for (const NamedTracking& tracker : trackers) text_ += fmt::format(" {:>24}", tracker.name);
    text_ += "\n";
  }
  void add(const std::string& name, const Cell& cell) {
    text_ += fmt::format("{:44}", name);
    for (const NamedTracking& tracker : trackers_) text_ += fmt::format(" {:>24}", cell(tracker.figures));
    text_ += "\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  const std::vector<NamedTracking>& trackers_;
  std::string text_;
};

void add_counts(Lines& lines, const std::string& where, TrackingCounts TrackingFigures::*counts) {
  const auto add = [&](const std::string& name, double (TrackingCounts::*figure)() const, int digits) {
    lines.add(name + where,
              [=](const TrackingFigures& f) { return number(((f.*counts).*figure)(), digits); });
  };
  add("MOTA", &TrackingCounts::mota, 4);
  add("IDF1", &TrackingCounts::idf1, 4);
  add("recall", &TrackingCounts::recall, 4);
  add("precision", &TrackingCounts::precision, 4);
  lines.add(fmt::format("id switches a vehicle-hour{} (n)", where), [=](const TrackingFigures& f) {
    return fmt::format("{} ({})", number((f.*counts).id_switches_per_vehicle_hour(), 2),
                       (f.*counts).id_switches);
  });
  lines.add("vehicle-hours" + where,
            [=](const TrackingFigures& f) { return number((f.*counts).vehicle_hours, 2); });
}

void add_rates(Lines& lines) {
  lines.add("false tracks confirmed an hour (n of tracks)", [](const TrackingFigures& f) {
    return fmt::format("{} ({} of {})", number(f.an_hour(f.false_confirmed), 2), f.false_confirmed, f.tracks);
  });
  lines.add("false witnesses an hour (n of witnesses)", [](const TrackingFigures& f) {
    return fmt::format("{} ({} of {})", number(f.an_hour(f.false_witnesses), 2), f.false_witnesses,
                       f.witnesses);
  });
  lines.add("time to confirm, median / p95 [s]", [](const TrackingFigures& f) {
    return fmt::format("{} / {}", number(f.confirm_s.quantile(0.5), 2),
                       number(f.confirm_s.quantile(0.95), 2));
  });
  lines.add("vehicles confirmed, never confirmed",
            [](const TrackingFigures& f) { return fmt::format("{}, {}", f.confirmed, f.never_confirmed); });
}

void add_errors(Lines& lines) {
  for (std::size_t bin = 0; bin < TrackingFigures::kBins; ++bin) {
    const double from = TrackingFigures::kBinLength * static_cast<double>(bin);
    lines.add(fmt::format("{:3.0f}-{:3.0f} m: lateral [m], heading [deg] RMSE (n)", from,
                          from + TrackingFigures::kBinLength),
              [bin](const TrackingFigures& f) {
                const TrackErrors& errors = f.ahead[bin];
                return fmt::format("{}, {} ({})", number(errors.lateral_rmse(), 3),
                                   number(kToDegrees * errors.heading_rmse(), 2), errors.n);
              });
  }
}

}  // namespace

std::string to_text(const std::vector<NamedTracking>& trackers) {
  Lines lines(trackers);
  lines.add("hours driven, frames",
            [](const TrackingFigures& f) { return fmt::format("{:.3f}, {}", f.hours, f.frames); });
  lines.add("GOSPA a frame [m]", [](const TrackingFigures& f) { return number(f.gospa(), 3); });
  lines.add("  its squares: localisation, missed, false", [](const TrackingFigures& f) {
    return fmt::format("{}, {}, {}", number(f.a_frame(f.localisation_sum), 2),
                       number(f.a_frame(f.missed_sum), 2), number(f.a_frame(f.false_sum), 2));
  });
  add_counts(lines, "", &TrackingFigures::all);
  add_counts(lines, fmt::format(" within {:.0f} m", trackers.front().figures.near_range),
             &TrackingFigures::near);
  add_rates(lines);
  add_errors(lines);
  return lines.text();
}

}  // namespace lanefuse
