// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/overlay_command.hpp"

namespace lanefuse {

void add_overlay(CommandLine& line) {
  auto& options = line.make<OverlayOptions>();
  CLI::App& command = *line.app.add_subcommand(
      "overlay", "draw what was seen in a drive's images, and the lanes on them, as a video");
  command.add_option("lanes", options.lanes, "the estimated lanes (.mcap)")->required();
  command.add_option("--drive", options.drive, "the drive with the images, if it is not where run found it");
  command.add_option("--camera", options.camera, "the camera's name, else the first that hands over images");
  CLI::Option* from = command.add_option("--from", options.from, "seconds since the first cycle to begin at");
  CLI::Option* to = command.add_option("--to", options.to, "seconds since the first cycle to end at");
  command
      .add_option("--at", options.at,
                  "draw only the first image from this second on, as a picture (.png, .jpg)")
      ->excludes(from)
      ->excludes(to);
  command.add_option("-o,--output", options.output, "the video to write (.mp4), or the picture")->required();
  finish(command, line, options, overlay);
}

}  // namespace lanefuse
