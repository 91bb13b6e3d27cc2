// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/import_video_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "recording/drive_writer.hpp"

namespace lanefuse {
namespace {

nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

nlohmann::ordered_json as_json(const ImportVideoOptions& options, const VideoMotion& motion) {
  return {{"drive", motion.info.name},
          {"output", options.output.string()},
          {"frames_read", motion.motions.size()},
          {"frames_announced", motion.frames_announced},
          {"frames_per_second", motion.frames_per_second},
          {"speed_mps", {{"mean", motion.speed_mean}, {"min", motion.speed_min}, {"max", motion.speed_max}}},
          {"scale",
           {{"source", motion.scale_source},
            {"factor", motion.scale},
            {"sigma", motion.scale_sigma},
            {"drift", number_or_null(motion.scale_drift)},
            {"measured_dash_period_m", number_or_null(motion.measured_dash_period)}}},
          {"road_seen", motion.seen},
          {"witness", to_string(motion.info.witness)},
          {"notes", motion.notes}};
}

void print_text(const ImportVideoOptions& options, const VideoMotion& motion) {
  fmt::print("{}: {} frames at {:.6g} a second ({} announced) -> {}\n", motion.info.name,
             motion.motions.size(), motion.frames_per_second, motion.frames_announced,
             options.output.string());
  fmt::print("speed {:.2f} m/s, {:.2f} to {:.2f}; its scale by {}", motion.speed_mean, motion.speed_min,
             motion.speed_max, motion.scale_source);
  if (motion.scale_sigma > 0) fmt::print(", +-{:.1f} %", 100 * motion.scale_sigma);
  if (motion.scale_drift) fmt::print(", drift {:+.1f} % from half to half", 100 * *motion.scale_drift);
  fmt::print("\n");
}

}  // namespace

int import_video_drive(const ImportVideoOptions& options) {
  check_output(options.output, options.force, options.import.video);
  const VideoMotion motion = survey_video(options.import);
  DriveWriter writer(options.output, motion.info, motion.rig);
  write_video(options.import, motion,
              [&writer](const Measurement& measurement) { writer.write(measurement); });
  writer.close();

  for (const std::string& note : motion.notes) fmt::print(stderr, "note: {}\n", note);
  if (options.json) {
    fmt::print("{}\n", as_json(options, motion).dump());
  } else {
    print_text(options, motion);
  }
  return 0;
}

}  // namespace lanefuse
