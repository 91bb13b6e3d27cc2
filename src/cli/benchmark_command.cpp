// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/benchmark_command.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/drive_run.hpp"
#include "benchmark/job_pool.hpp"
#include "benchmark/results_file.hpp"
#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of `drives`, those that a slice "I/N" names: every N-th from the I-th on.
std::vector<DriveKey> slice_of(const std::vector<DriveKey>& drives, const std::string& slice) {
  if (slice.empty()) return drives;
  const char* end = slice.data() + slice.size();
  std::size_t first = 0;
  std::size_t step = 0;
  const auto number = std::from_chars(slice.data(), end, first);
  const bool has_step = number.ptr != end && *number.ptr == '/';
  const auto rest = has_step ? std::from_chars(number.ptr + 1, end, step) : number;
  if (!has_step || rest.ec != std::errc{} || rest.ptr != end || first < 1 || first > step) {
    throw configuration_error("--job", fmt::format("'{}' is no I/N", slice),
                              "write 3/12 for the third of twelve");
  }
  std::vector<DriveKey> chosen;
  for (std::size_t i = first - 1; i < drives.size(); i += step) chosen.push_back(drives[i]);
  return chosen;
}

/// A drive that is still to be driven.
struct OpenJob {
  DriveJob job;
  Provenance provenance;
};

/// Whether the line of that drive is there already. Refuses one that was made with other settings.
bool is_done(const OpenJob& open, const ResultsFile& file) {
  const auto line = std::find_if(file.lines.begin(), file.lines.end(),
                                 [&open](const ResultLine& l) { return l.key == open.job.key; });
  if (line == file.lines.end()) return false;
  if (line->provenance == open.provenance) return true;
  throw configuration_error(line->place,
                            fmt::format("{} is there already, from another {}", to_string(open.job.key),
                                        differing(open.provenance, line->provenance)),
                            "choose another output, or start this one anew with --force");
}

ResultsFile begun_results(const BenchmarkOptions& options) {
  const std::filesystem::path& output = *options.output;
  if (options.force || !std::filesystem::exists(output)) {
    check_output(output, options.force);
    return {output, {}, 0, false};
  }
  ResultsFile file = read_results(output);
  if (file.cut_off) {
    fmt::print(stderr, "{}: its last line was cut off when a run was killed, and is driven again\n",
               output.string());
  }
  return file;
}

/// Names the drives, and stops there.
int list_drives(const BenchmarkOptions& options, const std::vector<DriveKey>& drives) {
  if (!options.json) {
    for (const DriveKey& drive : drives) fmt::print("{}\n", to_string(drive));
    return 0;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DriveKey& drive : drives) {
    list.push_back(head_json(drive, provenance_of({drive, options.assignments}, LANEFUSE_VERSION)));
  }
  fmt::print("{}\n", list.dump());
  return 0;
}

/// "5 of 12 drives, 0.8 km/s, 3:20 left"
std::string pace(double done, const std::vector<OpenJob>& jobs, double seconds) {
  const double km = done * jobs.front().job.key.km;
  std::string counted = fmt::format("{:.0f} of {} drives", std::floor(done), jobs.size());
  if (seconds < 1 || km <= 0) return counted;
  const double left = seconds * (static_cast<double>(jobs.size()) - done) / done;
  const auto whole = static_cast<long>(left);
  return fmt::format("{}, {:.2f} km/s, {}:{:02} left", counted, km / seconds, whole / 60, whole % 60);
}

void drive_all(const BenchmarkOptions& options, const std::vector<OpenJob>& open, ResultsWriter& writer) {
  if (open.empty()) return;
  const WallClock clock = options.no_times ? WallClock{} : WallClock{seconds_now};
  const double begin = seconds_now();
  Progress bar("driving");
  OrderedJobs jobs;
  jobs.count = open.size();
  jobs.workers = options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  jobs.run = [&](std::size_t i, const std::function<void(double)>& progress) {
    nlohmann::ordered_json line = head_json(open[i].job.key, open[i].provenance);
    line.update(run_drive(open[i].job, clock, progress));
    return line.dump();
  };
  jobs.take = [&](std::size_t, const std::string& line) { writer.append(line); };
  jobs.progress = [&](double done) {
    bar.show(done / static_cast<double>(open.size()), pace(done, open, seconds_now() - begin));
  };
  run_jobs(jobs);
}

void report(const BenchmarkOptions& options, std::size_t drives, std::size_t driven) {
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"output", options.output->string()},
                                              {"drives", drives},
                                              {"driven", driven},
                                              {"there_already", drives - driven}}
                           .dump());
  } else {
    fmt::print("{} of {} drives driven, {} there already -> {}\n", driven, drives, drives - driven,
               options.output->string());
  }
}

}  // namespace

int benchmark(const BenchmarkOptions& options) {
  SuiteChoice choice = options.choice;
  choice.seeds = parse_seeds(options.seeds);
  const std::vector<DriveKey> drives = slice_of(drives_of(choice), options.slice);
  if (options.list) return list_drives(options, drives);

  const ResultsFile file = begun_results(options);
  std::vector<OpenJob> open;
  for (const DriveKey& drive : drives) {
    const DriveJob job{drive, options.assignments};
    OpenJob candidate{job, provenance_of(job, LANEFUSE_VERSION)};
    if (!is_done(candidate, file)) open.push_back(std::move(candidate));
  }
  ResultsWriter writer(*options.output, file.whole_bytes);
  drive_all(options, open, writer);
  report(options, drives.size(), open.size());
  return 0;
}

}  // namespace lanefuse
