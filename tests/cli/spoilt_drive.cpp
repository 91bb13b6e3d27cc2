// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// spoilt_drive KIND FILE: writes a short simulated drive in which one kind of thing is impossible.
#include <limits>
#include <string_view>

#include "recording/drive_writer.hpp"
#include "simulation/drive_simulation.hpp"

namespace lanefuse {
namespace {

void spoil(MarkingFeatures& markings, std::string_view kind) {
  if (markings.features.empty()) return;
  Feature& first = markings.features.front();
  if (kind == "nan") first.y = std::numeric_limits<double>::quiet_NaN();
  if (kind == "covariance") first.covariance(1, 1) = -1;
  if (kind == "time") markings.stamp.received_at = markings.stamp.measured_at - std::chrono::seconds(1);
}

void write(std::string_view kind, const char* file) {
  DriveSimulation simulation({.seed = 1, .km = 0.2}, nominal_preset());
  DriveWriter writer(file, simulation.info(), simulation.rig());
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (bool more = true; more;) {
    more = simulation.step(measurements, truth);
    for (Measurement& measurement : measurements) {
      if (auto* markings = std::get_if<MarkingFeatures>(&measurement)) spoil(*markings, kind);
      writer.write(measurement);
    }
  }
  writer.close();
}

}  // namespace
}  // namespace lanefuse

int main(int count, char** arguments) {
  if (count != 3) return 2;
  lanefuse::write(arguments[1], arguments[2]);
  return 0;
}
