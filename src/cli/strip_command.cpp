// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/strip_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "recording/drive_reader.hpp"
#include "recording/drive_truth.hpp"

namespace lanefuse {

int strip(const StripOptions& options) {
  check_output(options.output, options.force, options.drive);
  const DriveReader drive(options.drive);  // refuses what is none
  strip_truth(options.drive, options.output);
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"output", options.output.string()}}.dump());
  } else {
    fmt::print("without truth -> {}\n", options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
