// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/map_localize_command.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "cli/survey_input.hpp"
#include "core/error.hpp"
#include "recording/drive_reader.hpp"
#include "recording/drive_truth.hpp"
#include "roadmap/map_files.hpp"
#include "roadmap/map_localiser.hpp"

namespace lanefuse {
namespace {

/// Mean and root mean square of what is added.
struct Moments {
  std::size_t count = 0;
  double sum = 0;
  double squares = 0;
  void add(double value) {
    ++count;
    sum += value;
    squares += value * value;
  }
  [[nodiscard]] nlohmann::ordered_json json() const {
    const double n = static_cast<double>(count);
    if (count == 0) return nullptr;
    return {{"mean", sum / n}, {"rmse", std::sqrt(squares / n)}};
  }
};

/// How far poses are off the true ones, in the vehicle's own directions.
struct PoseErrors {
  Moments across;
  Moments along;
  Moments heading;
  void add(const Pose2& estimated, const Pose2& actual) {
    const Pose2 off = actual.inverse() * estimated;
    across.add(off.y);
    along.add(off.x);
    heading.add(wrap_angle(off.heading));
  }
  [[nodiscard]] nlohmann::ordered_json json() const {
    return {{"across_m", across.json()}, {"along_m", along.json()}, {"heading_rad", heading.json()}};
  }
};

struct Summary {
  Moments left;
  Moments right;
  std::map<int, std::size_t> lanes;
  std::size_t poses = 0;
  std::optional<PoseErrors> by_fixes;
  std::optional<PoseErrors> by_map;
};

Pose2 moved(const Pose2& pose, const std::optional<GeoOrigin>& from, const GeoOrigin& into) {
  if (!from || *from == into) return pose;
  const GeoFrame old_frame(*from);
  const GeoFrame new_frame(into);
  const GeoOrigin there = old_frame.place({pose.x, pose.y, 0});
  const Eigen::Vector3d place = new_frame.local(there);
  return {place.x(), place.y(),
          wrap_angle(pose.heading - old_frame.convergence(there) + new_frame.convergence(there))};
}

std::vector<Time> times_of(const SurveyedDrive& drive, const std::vector<TrueFrame>& frames) {
  std::vector<Time> times;
  for (const TrueFrame& frame : frames) times.push_back(frame.time);
  if (!times.empty()) return times;
  for (const TrackNode& node : drive.track) times.push_back(node.time);
  return times;
}

Summary summarise(const std::vector<MapPose>& poses) {
  Summary summary;
  summary.poses = poses.size();
  for (const MapPose& pose : poses) {
    if (pose.left_residual) summary.left.add(*pose.left_residual);
    if (pose.right_residual) summary.right.add(*pose.right_residual);
    ++summary.lanes[pose.lane_number];
  }
  return summary;
}

void judge(const std::vector<MapPose>& poses, const std::map<Time, Pose2>& actual, Summary& summary) {
  if (actual.empty()) return;
  summary.by_fixes.emplace();
  summary.by_map.emplace();
  for (const MapPose& pose : poses) {
    summary.by_fixes->add(pose.by_fixes, actual.at(pose.time));
    summary.by_map->add(pose.by_map, actual.at(pose.time));
  }
}

std::string to_csv(const std::vector<MapPose>& poses) {
  std::string text =
      "time_ns,x_m,y_m,heading_rad,sigma_across_m,lane,lane_number,fix_x_m,fix_y_m,fix_heading_rad\n";
  for (const MapPose& pose : poses) {
    text +=
        fmt::format("{},{:.4f},{:.4f},{:.6f},{:.4f},{},{},{:.4f},{:.4f},{:.6f}\n", to_nanoseconds(pose.time),
                    pose.by_map.x, pose.by_map.y, pose.by_map.heading, pose.sigma, pose.lane.value_or(0),
                    pose.lane_number, pose.by_fixes.x, pose.by_fixes.y, pose.by_fixes.heading);
  }
  return text;
}

nlohmann::ordered_json to_json(const Summary& summary) {
  nlohmann::ordered_json lanes = nlohmann::ordered_json::object();
  for (const auto& [number, count] : summary.lanes) lanes[std::to_string(number)] = count;
  nlohmann::ordered_json json{
      {"poses", summary.poses},
      {"lanes", lanes},
      {"residual_m", {{"left", summary.left.json()}, {"right", summary.right.json()}}}};
  if (summary.by_fixes) {
    json["error"] = {{"by_fixes", summary.by_fixes->json()}, {"by_map", summary.by_map->json()}};
  }
  return json;
}

std::string to_text(const Summary& summary) {
  const auto rmse = [](const Moments& m) {
    return m.count > 0 ? std::sqrt(m.squares / static_cast<double>(m.count)) : 0.0;
  };
  std::string text = fmt::format("{} poses; markings against the map: left {:.3f} m, right {:.3f} m RMSE\n",
                                 summary.poses, rmse(summary.left), rmse(summary.right));
  for (const auto& [number, count] : summary.lanes) {
    text += number > 0 ? fmt::format("  lane {}: {} poses\n", number, count)
                       : fmt::format("  in no lane: {} poses\n", count);
  }
  const auto line = [&](const char* name, const PoseErrors& errors) {
    return fmt::format("{:<9} {:.4f} m across, {:.4f} m along, {:.5f} rad heading (RMSE)\n", name,
                       rmse(errors.across), rmse(errors.along), rmse(errors.heading));
  };
  if (summary.by_fixes) text += line("by fixes", *summary.by_fixes) + line("by map", *summary.by_map);
  return text;
}

}  // namespace

int map_localize(const MapLocalizeOptions& options) {
  if (options.output) {
    for (const auto& input : {options.drive, options.map})
      check_output(*options.output, options.force, input);
  }
  const RoadMap map = read_map(options.map);
  if (!map.origin) {
    throw input_error(options.map.string(), "does not say where on Earth it is",
                      "lanefuse map convert --origin LAT,LON adds it");
  }
  const SurveyedDrive drive = read_surveyed(options.drive, *map.origin);
  const std::vector<TrueFrame> frames = read_truth(options.drive).frames;
  const std::vector<MapPose> poses = localise(drive, map, times_of(drive, frames));
  Summary summary = summarise(poses);
  std::map<Time, Pose2> actual;
  const std::optional<GeoOrigin> origin = DriveReader(options.drive).info().origin;
  for (const TrueFrame& frame : frames)
    actual[frame.time] = moved(frame.world_from_vehicle, origin, *map.origin);
  judge(poses, actual, summary);
  if (options.output) write_text(*options.output, to_csv(poses));
  fmt::print("{}", options.json ? to_json(summary).dump() + "\n" : to_text(summary));
  return 0;
}

}  // namespace lanefuse
