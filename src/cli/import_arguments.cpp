// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/import_command.hpp"
#include "cli/import_video_command.hpp"

namespace lanefuse {
namespace {

void add_comma2k19(CLI::App& import, CommandLine& line) {
  auto& options = line.make<ImportOptions>();
  CLI::App& command =
      *import.add_subcommand("comma2k19", "one minute of comma2k19: radar, speed, gyro; poses as truth");
  command.add_option("directory", options.directory, "a segment, or a folder that holds exactly one")
      ->required();
  command.add_option("-o,--output", options.output, "the recording to write (.mcap)")->required();
  finish(command, line, options, import_comma2k19_drive);
}

void add_video(CLI::App& import, CommandLine& line) {
  constexpr double kFastest = 100;     // [m/s]
  constexpr double kLongestDash = 50;  // [m]
  auto& options = line.make<ImportVideoOptions>();
  CLI::App& command = *import.add_subcommand("video", "a plain video: its images, and motion from the road");
  command.add_option("file", options.import.video, "the video")->required();
  command.add_option("--camera", options.import.camera, "its camera (.yaml), see docs/camera-calibration.md")
      ->required();
  command.add_option("-o,--output", options.output, "the recording to write (.mcap)")->required();
  CLI::Option* speed =
      command.add_option("--speed-mps", options.import.speed, "the car's speed throughout [m/s]")
          ->check(CLI::Range(0.0, kFastest));
  command
      .add_option("--motion", options.import.motion,
                  "the car's motion: CSV with time_s,speed_mps or time_s,speed_mps,yaw_rate_radps")
      ->excludes(speed);
  command
      .add_option("--dash-period-m", options.import.dash_period,
                  "the way from one dash of the markings to the next [m]: gives the speeds their scale")
      ->check(CLI::Range(2.0, kLongestDash));
  command.add_option("--quality", options.import.jpeg_quality, "of the images (JPEG)")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  finish(command, line, options, import_video_drive);
}

}  // namespace

void add_import(CommandLine& line) {
  CLI::App& import =
      *line.app.add_subcommand("import", "turn a data set's drive or a video into a recording");
  demand_subcommand(import);
  add_comma2k19(import, line);
  add_video(import, line);
}

}  // namespace lanefuse
