// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/survey_input.hpp"

#include <numbers>

#include "core/error.hpp"
#include "recording/drive_reader.hpp"
#include "recording/drive_truth.hpp"
#include "roadmap/map_comparison.hpp"
#include "roadmap/map_files.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

void refuse_damaged(const std::filesystem::path& file, const ReadReport& report) {
  if (!report.complete()) throw input_error(file.string(), "damaged: " + report.first_problem);
}

}  // namespace

GeoOrigin survey_origin(const std::filesystem::path& drive) {
  DriveReader reader(drive);
  if (reader.info().origin) return *reader.info().origin;
  for (Measurement measurement; reader.next(measurement);) {
    const auto* fix = std::get_if<GnssInsFix>(&measurement);
    if (fix && !implausible(measurement))
      return {fix->latitude / kDegree, fix->longitude / kDegree, fix->height};
  }
  throw input_error(drive.string(), "holds no GNSS/INS fixes",
                    "this needs drives with /in/gnss_ins, as of simulate --gnss-ins");
}

SurveyedDrive read_surveyed(const std::filesystem::path& drive, const GeoOrigin& origin) {
  DriveReader reader(drive);
  SurveyRecorder recorder(drive.string(), GeoFrame(origin), reader.rig());
  for (Measurement measurement; reader.next(measurement);) recorder.add(measurement);
  refuse_damaged(drive, reader.report());
  return recorder.finish();
}

RoadMap exact_map(const std::filesystem::path& drive) {
  const DriveTruth truth = read_truth(drive);
  refuse_damaged(drive, truth.report);
  if (!truth.road) throw input_error(drive.string(), "has no exact road (/truth/road)");
  return as_map(*truth.road, DriveReader(drive).info().origin);
}

RoadMap read_map_or_exact(const std::filesystem::path& path) {
  return path.extension() == ".mcap" ? exact_map(path) : read_map(path);
}

}  // namespace lanefuse
