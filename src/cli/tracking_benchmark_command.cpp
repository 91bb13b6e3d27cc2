// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/tracking_benchmark_command.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/job_pool.hpp"
#include "benchmark/suite.hpp"
#include "benchmark/tracking_trial.hpp"
#include "cli/progress.hpp"
#include "cli/tracking_text.hpp"
#include "evaluation/tracking_json.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {
namespace {

/// [km] that the ego car drives in that time at its own wish: others only ever make it slower.
double km_of(double hours) { return 3.6 * nominal_preset().ego.speed * hours; }

std::vector<TrackingTrial> trials_of(const TrackingBenchmarkOptions& options) {
  std::vector<TrackingTrial> trials;
  for (const std::uint64_t seed : parse_seeds(options.seeds)) {
    TrackingTrial whole;
    whole.seed = seed;
    whole.km = options.hours ? km_of(*options.hours) : options.km;
    whole.road = options.road == "curved" ? RoadKind::curved : RoadKind::gentle;
    whole.guard_rail_mirrors = options.guard_rail_mirrors;
    for (const TrackingTrial& piece : cut_trial(whole)) trials.push_back(piece);
  }
  return trials;
}

TrackingTrialFigures run_all(const std::vector<TrackingTrial>& trials, std::size_t workers) {
  std::vector<TrackingTrialFigures> figures(trials.size());
  Progress bar("tracking");
  OrderedJobs jobs;
  jobs.count = trials.size();
  jobs.workers = workers > 0 ? workers : std::max(1U, std::thread::hardware_concurrency());
  jobs.run = [&](std::size_t i, const std::function<void(double)>& progress) {
    figures[i] = run_trial(trials[i], progress);
    return std::string();
  };
  jobs.take = [](std::size_t, const std::string&) {};
  jobs.progress = [&](double done) {
    bar.show(done / static_cast<double>(trials.size()),
             fmt::format("{:.1f} of {} drives", done, trials.size()));
  };
  run_jobs(jobs);
  TrackingTrialFigures sum;
  for (const TrackingTrialFigures& one : figures) sum += one;
  return sum;
}

}  // namespace

int benchmark_tracking(const TrackingBenchmarkOptions& options) {
  const std::vector<TrackingTrial> trials = trials_of(options);
  const TrackingTrialFigures figures = run_all(trials, options.jobs);
  const double km = std::accumulate(trials.begin(), trials.end(), 0.0,
                                    [](double sum, const TrackingTrial& trial) { return sum + trial.km; });
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"road", options.road},
                                              {"seeds", options.seeds},
                                              {"drives", trials.size()},
                                              {"km", km},
                                              {"tracking", to_json(figures.fused)},
                                              {"nearest_neighbour", to_json(figures.nearest_neighbour)}}
                           .dump());
    return 0;
  }
  fmt::print("{} drive{}, {:.1f} km, {} road\n\n{}", trials.size(), trials.size() == 1 ? "" : "s", km,
             options.road,
             to_text({{"fused, verified", figures.fused}, {"nearest neighbour", figures.nearest_neighbour}}));
  return 0;
}

}  // namespace lanefuse
