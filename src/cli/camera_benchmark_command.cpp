// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/camera_benchmark_command.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/camera_report.hpp"
#include "benchmark/camera_trial.hpp"
#include "benchmark/job_pool.hpp"
#include "benchmark/suite.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

ImageConditions conditions_named(const std::string& name) {
  const auto conditions = image_conditions(name);
  if (!conditions) {
    throw configuration_error("--conditions", fmt::format("'{}' is unknown", name),
                              "choose clear, low-sun, wet or night");
  }
  return *conditions;
}

std::vector<CameraTrial> trials_of(const CameraBenchmarkOptions& options) {
  std::vector<CameraTrial> trials;
  for (const std::string& name : options.conditions) {
    for (const std::uint64_t seed : parse_seeds(options.seeds)) {
      CameraTrial trial;
      trial.seed = seed;
      trial.km = options.km;
      trial.objects = options.objects;
      trial.road = options.road == "curved" ? RoadKind::curved : RoadKind::gentle;
      trial.conditions = conditions_named(name);
      trials.push_back(trial);
    }
  }
  return trials;
}

std::vector<CameraTrialFigures> run_all(const std::vector<CameraTrial>& trials, std::size_t workers) {
  std::vector<CameraTrialFigures> figures(trials.size());
  Progress bar("looking");
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
  return figures;
}

}  // namespace

int benchmark_cameras(const CameraBenchmarkOptions& options) {
  const std::vector<CameraTrial> trials = trials_of(options);
  const std::vector<CameraTrialFigures> figures = run_all(trials, options.jobs);
  nlohmann::ordered_json json;
  for (const std::string& name : options.conditions) {
    CameraTrialFigures sum;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (trials[i].conditions == conditions_named(name)) sum += figures[i];
    }
    if (options.json) {
      json[name] = to_json(sum);
    } else {
      fmt::print("## {}\n\n{}\n", name, to_text(sum));
    }
  }
  if (options.json) fmt::print("{}\n", json.dump());
  return 0;
}

}  // namespace lanefuse
