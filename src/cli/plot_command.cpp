// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/plot_command.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/lanes_and_truth.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "drawing/svg.hpp"
#include "drawing/top_view.hpp"
#include "drawing/track_picture.hpp"

namespace lanefuse {
namespace {

int plot_tracks(const PlotOptions& options) {
  LanesReader reader(options.lanes);
  TrackHistory history;
  LaneRecord record;
  std::optional<Time> first;
  while (reader.next_without_features(record)) {
    if (!first) first = record.estimate.time;
    history.add(to_seconds(record.estimate.time - *first), record.objects);
  }
  const std::string title = fmt::format("Tracks of {}", reader.drive().name);
  write_text(options.output, standalone_svg(draw_tracks(title, history)));
  const std::vector<TrackedLife> lives = history.lives();
  const auto witnesses = std::count_if(lives.begin(), lives.end(),
                                       [](const TrackedLife& life) { return life.was(TrackRole::witness); });
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"output", options.output.string()},
                                              {"duration_s", history.duration()},
                                              {"tracks", lives.size()},
                                              {"witnesses", witnesses}}
                           .dump());
  } else {
    fmt::print("{:.1f} s, {} tracks, {} of them witnesses at some time -> {}\n", history.duration(),
               lives.size(), witnesses, options.output.string());
  }
  return 0;
}

}  // namespace

int plot(const PlotOptions& options) {
  check_output(options.output, options.force, options.lanes);
  if (options.tracks) return plot_tracks(options);
  LanesReader reader(options.lanes);
  const LanesAndTruth context = find_truth(options.lanes, options.drive);
  check_output(options.output, options.force, context.drive);
  LaneRecord record;
  std::optional<Time> first;
  double seconds = -1;
  const auto reached = [&] { return seconds + 1e-9 >= options.at; };  // never, where --at is no number
  while (!reached() && reader.next(record)) {
    if (!first) first = record.estimate.time;
    seconds = to_seconds(record.estimate.time - *first);
  }
  if (!reached()) {
    throw configuration_error(fmt::format("--at {}", options.at),
                              fmt::format("{} ends at {:.2f} s", options.lanes.string(), seconds));
  }
  TopView view = make_view(record, context);
  view.title = fmt::format("{}, {:.2f} s", reader.drive().name, seconds);
  write_text(options.output, standalone_svg(draw_top_view(view)));
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"output", options.output.string()},
                                              {"at_s", seconds},
                                              {"status", to_string(record.estimate.status)},
                                              {"boundaries", record.estimate.boundaries.size()},
                                              {"features", record.debug.features.size()}}
                           .dump());
  } else {
    fmt::print("{:.2f} s, status {} -> {}\n", seconds, to_string(record.estimate.status),
               options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
