// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/import_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "importing/comma2k19.hpp"
#include "recording/drive_writer.hpp"

namespace lanefuse {

int import_comma2k19_drive(const ImportOptions& options) {
  check_output(options.output, options.force);
  const ImportedDrive drive = import_comma2k19(options.directory);
  DriveWriter writer(options.output, drive.info, drive.rig);
  for (const Measurement& measurement : drive.measurements) writer.write(measurement);
  for (const TrueFrame& frame : drive.truth) writer.write(frame);
  writer.close();

  for (const std::string& note : drive.notes) fmt::print(stderr, "note: {}\n", note);
  fmt::print(stderr, "witness: {}, set by the import: later runs follow it and say so\n",
             to_string(drive.info.witness));
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"drive", drive.info.name},
                                              {"output", options.output.string()},
                                              {"measurements", drive.measurements.size()},
                                              {"truth_frames", drive.truth.size()},
                                              {"witness", to_string(drive.info.witness)},
                                              {"notes", drive.notes}}
                           .dump());
  } else {
    fmt::print("{}: {} measurements, {} true poses -> {}\n", drive.info.name, drive.measurements.size(),
               drive.truth.size(), options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
