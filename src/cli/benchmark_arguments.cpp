// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string>

#include "benchmark/estimator_choice.hpp"
#include "benchmark/scene.hpp"
#include "benchmark/suite.hpp"
#include "benchmark/variant.hpp"
#include "cli/benchmark_command.hpp"
#include "cli/benchmark_results_command.hpp"
#include "cli/camera_benchmark_command.hpp"
#include "cli/command_line.hpp"
#include "cli/label_benchmark_command.hpp"
#include "cli/tracking_benchmark_command.hpp"
#include "simulation/sensor_noise.hpp"

namespace lanefuse {
namespace {

/// "WHAT: a, b, c"
std::string listed(const std::string& what, const std::vector<std::string>& names) {
  std::string text = what;
  for (const std::string& name : names) text.append(&name == &names.front() ? ": " : ", ").append(name);
  return text;
}

void add_drives(CLI::App& command, BenchmarkOptions& options) {
  SuiteChoice& choice = options.choice;
  command.add_option("--suite", choice.suite, listed("which drives", suite_names()))->capture_default_str();
  command.add_option("--road", choice.road, "gentle, curved or all, if not the suite's own");
  command.add_option("--scene", choice.scene, listed("only this scene", scene_names()));
  command.add_option("--seeds", options.seeds, "one drive each, as in 1-6,9")->capture_default_str();
  command.add_option("--km", choice.km, "length of a drive [km], if not the suite's own")
      ->check(CLI::Range(0.05, 1000.0));
  command.add_option("--variant", choice.variant,
                     listed("all of the estimator, or only this variant", variant_names()));
  command
      .add_option("--noise", choice.noise,
                  "sensors err so many times as much as the preset, and they themselves, say")
      ->check(CLI::Range(kNoiseFactors.low, kNoiseFactors.high))
      ->capture_default_str();
  command.add_flag("--detections", choice.detections,
                   "drive each once more with raw detections in place of the object list, as the variant "
                   "'detections'");
  command
      .add_option(
          "--estimator", choice.estimators,
          listed("what fuses, if not the suite's own, or several as in graph,road", estimator_names()))
      ->delimiter(',');
  command.add_option("--truth", choice.truth, "exact, or surveyed with the errors of the paper's own map")
      ->capture_default_str();
  command
      .add_option("--set", options.assignments, "one setting, KEY=VALUE, over the variant's; may be repeated")
      ->expected(1)
      ->take_all();
}

void add_merge(CLI::App& benchmark, CommandLine& line) {
  auto& options = line.make<MergeResultsOptions>();
  CLI::App& command = *benchmark.add_subcommand("merge", "join files of results into one");
  command.add_option("files", options.files, "the files of results (.jsonl)")->required();
  command.add_option("-o,--output", options.output, "the file to write (.jsonl)")->required();
  finish(command, line, options, merge_results_files);
}

/// A subcommand that shows drives in rows.
void add_rows(CLI::App& benchmark, CommandLine& line, const char* name, const char* about,
              int (*show)(const ResultsTableOptions&)) {
  static const std::map<std::string, GroupBy> groups{
      {"variant", GroupBy::variant}, {"scene", GroupBy::scene}, {"road", GroupBy::road}};
  auto& options = line.make<ResultsTableOptions>();
  CLI::App& command = *benchmark.add_subcommand(name, about);
  command.add_option("files", options.files, "the files of results (.jsonl)")->required();
  const auto group = [&options](const std::string& by) { options.by = groups.at(by); };
  command
      .add_option_function<std::string>("--by", group,
                                        "one row a variant, scene or road, else one for each of all three")
      ->check(CLI::IsMember(groups));
  command.add_flag("--markdown", options.markdown, "as tables in Markdown");
  finish(command, line, options, show);
}

void add_compare(CLI::App& benchmark, CommandLine& line) {
  auto& options = line.make<CompareResultsOptions>();
  CLI::App& command =
      *benchmark.add_subcommand("compare", "what changed from A to B, and whether it may be chance");
  command.add_option("A", options.a, "results before (.jsonl)")->required();
  command.add_option("B", options.b, "results after (.jsonl)")->required();
  command.add_option("--variant-a", options.variant_a, "only the drives of this variant in A");
  command.add_option("--variant-b", options.variant_b, "only the drives of this variant in B");
  command.add_option("--estimator-a", options.estimator_a, "only the drives of this estimator in A");
  command.add_option("--estimator-b", options.estimator_b, "only the drives of this estimator in B");
  finish(command, line, options, compare_results);
}

void add_cameras(CLI::App& benchmark, CommandLine& line) {
  auto& options = line.make<CameraBenchmarkOptions>();
  CLI::App& command = *benchmark.add_subcommand(
      "cameras", "render drives and judge what the cameras see, image by image, against what was rendered");
  command
      .add_option("--conditions", options.conditions, "clear, low-sun, wet, night; all, if nothing is said")
      ->delimiter(',');
  command.add_option("--road", options.road, "gentle or curved")
      ->check(CLI::IsMember({"gentle", "curved"}))
      ->capture_default_str();
  command.add_option("--seeds", options.seeds, "one drive each, as in 1-3,9")->capture_default_str();
  command.add_option("--km", options.km, "length of a drive [km]")
      ->check(CLI::Range(0.2, 100.0))
      ->capture_default_str();
  command.add_option("--jobs", options.jobs, "drives at a time, else one a core")->check(CLI::Range(1, 4096));
  command.add_flag_callback(
      "--no-objects", [&options] { options.objects = false; },
      "without the car's object list: vehicles found in the images hide the road, and are judged");
  finish(command, line, options, benchmark_cameras);
}

void add_tracking(CLI::App& benchmark, CommandLine& line) {
  auto& options = line.make<TrackingBenchmarkOptions>();
  CLI::App& command = *benchmark.add_subcommand(
      "tracking", "simulate drives and judge the tracks of the vehicles around, beside a plain tracker's");
  CLI::Option* km = command.add_option("--km", options.km, "length of way of each seed [km]");
  km->check(CLI::Range(0.05, 100'000.0))->capture_default_str();
  command.add_option("--hours", options.hours, "at least so long a drive of each seed [h]")
      ->check(CLI::Range(0.001, 1000.0))
      ->excludes(km);
  command.add_option("--seeds", options.seeds, "as in 1-3,9")->capture_default_str();
  command.add_option("--road", options.road, "gentle or curved")
      ->check(CLI::IsMember({"gentle", "curved"}))
      ->capture_default_str();
  command
      .add_option("--guard-rail-mirrors", options.guard_rail_mirrors,
                  "most ghosts beside guard rails a scan, if not the preset's")
      ->check(CLI::Range(0, 100));
  command.add_option("--jobs", options.jobs, "drives at a time, else one a core")->check(CLI::Range(1, 4096));
  finish(command, line, options, benchmark_tracking);
}

void add_labels(CLI::App& benchmark, CommandLine& line) {
  auto& options = line.make<LabelBenchmarkOptions>();
  CLI::App& command = *benchmark.add_subcommand(
      "labels", "fuse a drive with images, and compare it with what people marked in some of them");
  command.add_option("drive", options.drive, "the recorded drive (.mcap)")->required();
  command.add_option("--labels", options.labels, "what was marked (.json)")->required();
  command.add_option("--clip", options.clip, "whose labels of the file they are, else the drive's name");
  command.add_option("--tolerance-px", options.tolerance.pixels, "between a label and the estimated line")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command.add_option("--range-m", options.tolerance.range, "up to which labels count")
      ->check(CLI::Range(5.0, 150.0))
      ->capture_default_str();
  command.add_option("--config", options.config, "YAML with settings that differ from the defaults");
  command.add_option("--set", options.assignments, "one setting, KEY=VALUE, over the file; may be repeated")
      ->expected(1)
      ->take_all();
  command.add_flag("--list", options.list,
                   "print every labelled image: mean error by 10 m, and what was found");
  finish(command, line, options, benchmark_labels);
}

}  // namespace

void add_benchmark(CommandLine& line) {
  auto& options = line.make<BenchmarkOptions>();
  CLI::App& command = *line.app.add_subcommand(
      "benchmark", "simulate, fuse and judge many drives; goes on where it was broken off");
  command.require_subcommand(0, 1);
  add_drives(command, options);
  CLI::Option* output =
      command.add_option("-o,--output", options.output, "the results to write or to add to (.jsonl)");
  command.add_option("--jobs", options.jobs, "drives at a time, else one a core")->check(CLI::Range(1, 4096));
  command.add_option("--job", options.slice,
                     "I/N: every N-th drive from the I-th on, for arrays of machines");
  CLI::Option* list = command.add_flag("--list", options.list, "name the drives and stop");
  command.add_flag("--no-times", options.no_times, "leave out wall-clock times: equal runs, equal bytes");
  add_cameras(command, line);
  add_labels(command, line);
  add_tracking(command, line);
  add_merge(command, line);
  add_rows(command, line, "table", "means over drives, with confidence intervals", show_results_table);
  add_rows(command, line, "coverage", "whether the stated uncertainty is honest, by lane and distance",
           show_coverage);
  add_compare(command, line);
  finish(command, line, options, benchmark);
  command.callback([&line, &options, &command, output, list] {
    if (!command.get_subcommands().empty()) return;
    if (output->empty() && list->empty()) throw CLI::RequiredError(output->get_name());
    line.action = [&options] { return benchmark(options); };
  });
}

}  // namespace lanefuse
