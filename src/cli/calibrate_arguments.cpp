// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/calibrate_chessboard_command.hpp"
#include "cli/calibrate_mounting_command.hpp"
#include "cli/command_line.hpp"

namespace lanefuse {
namespace {

constexpr double kLargest = 1000;

void add_chessboard(CLI::App& calibrate, CommandLine& line) {
  auto& options = line.make<CalibrateChessboardOptions>();
  CLI::App& command =
      *calibrate.add_subcommand("chessboard", "a camera's lens, from pictures of a chessboard");
  command
      .add_option("images", options.images, "pictures of the board, tilted to all sides (.jpg, .png, .webp)")
      ->required();
  command
      .add_option("--pattern", options.pattern,
                  "the board's inner corners, COLUMNSxROWS; parts of it count, too")
      ->capture_default_str();
  command.add_option("--square-m", options.square, "side of a square [m], to be told the boards' distances")
      ->check(CLI::Range(1e-4, kLargest));
  command.add_option("--name", options.name, "of the camera in the file")->capture_default_str();
  command
      .add_option_function<std::string>(
          "--kind",
          [&options](const std::string& kind) {
            options.kind = kind == "serial_camera"            ? SensorKind::serial_camera
                           : kind == "high_resolution_camera" ? SensorKind::high_resolution_camera
                                                              : SensorKind::camera;
          },
          "what its images serve as")
      ->check(CLI::IsMember({"camera", "serial_camera", "high_resolution_camera"}))
      ->default_str("camera");
  command.add_option("-o,--output", options.output, "the camera to write (.yaml)");
  finish(command, line, options, calibrate_chessboard);
}

void add_mounting(CLI::App& calibrate, CommandLine& line) {
  auto& options = line.make<CalibrateMountingOptions>();
  CLI::App& command = *calibrate.add_subcommand(
      "mounting", "how a camera stands in the car, from pictures of straight roads");
  command
      .add_option("images", options.images, "pictures with both markings of the own lane (.jpg, .png, .webp)")
      ->required();
  command.add_option("--camera", options.camera, "the camera with its lens (.yaml)")->required();
  command.add_option("--lane-width-m", options.lane_width, "between the middles of the markings [m]")
      ->required()
      ->check(CLI::Range(1.0, 10.0));
  command.add_option("-o,--output", options.output,
                     "the camera to write (.yaml); with --force the same file");
  finish(command, line, options, [](const CalibrateMountingOptions& o) { return calibrate_mounting(o); });
}

}  // namespace

void add_calibrate(CommandLine& line) {
  CLI::App& calibrate =
      *line.app.add_subcommand("calibrate", "find a camera's lens and how it stands in the car");
  demand_subcommand(calibrate);
  add_chessboard(calibrate, line);
  add_mounting(calibrate, line);
}

}  // namespace lanefuse
