// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/lanes_and_truth.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "evaluation/ego_path.hpp"
#include "evaluation/true_frames.hpp"
#include "recording/drive_reader.hpp"

namespace lanefuse {
namespace {

constexpr double kViewReach = 130;  ///< [m]
constexpr double kPathStep = 2;     ///< [m]

std::vector<Eigen::Vector2d> path_in_view(const DriveTruth& truth, Time time) {
  std::vector<Eigen::Vector2d> points;
  const auto path = driven_path(truth.frames, time, kViewReach);
  if (!path) return points;
  for (double x = 0; x <= kViewReach; x += kPathStep) {
    if (const auto y = path->y(x)) points.emplace_back(x, *y);
  }
  return points;
}

}  // namespace

LanesAndTruth find_truth(const std::filesystem::path& lanes,
                         const std::optional<std::filesystem::path>& drive) {
  LanesAndTruth found{read_sidecar(lanes), {}, {}};
  std::filesystem::path& path = found.drive;
  if (drive) {
    path = *drive;
  } else if (found.sidecar && std::filesystem::exists(found.sidecar->drive)) {
    path = found.sidecar->drive;
  } else {
    return found;
  }
  const std::string recorded = DriveReader(path).info().name;
  const std::string estimated = LanesReader(lanes).drive().name;
  if (recorded != estimated) {
    throw configuration_error(path.string(),
                              fmt::format("is '{}', but the lanes came from '{}'", recorded, estimated),
                              "name the right drive with --drive");
  }
  found.truth = read_truth(path);
  return found;
}

TopView make_view(const LaneRecord& record, const LanesAndTruth& context) {
  TopView view;
  view.estimate = record.estimate;
  view.debug = record.debug;
  if (!context.truth) return view;
  const auto frame = frame_at(context.truth->frames, record.estimate.time);
  if (frame && context.truth->road) {
    view.true_boundaries = boundaries_in_view(*context.truth->road, frame->world_from_vehicle);
    for (const TrueObject& object : frame->objects) {
      const Pose2 pose = frame->world_from_vehicle.inverse() * object.world_from_object;
      TrackedObject vehicle;
      vehicle.id = object.id;
      vehicle.x = pose.x;
      vehicle.y = pose.y;
      vehicle.heading = pose.heading;
      vehicle.length = object.length;
      vehicle.width = object.width;
      view.vehicles.push_back(vehicle);
    }
  } else {
    view.driven_path = path_in_view(*context.truth, record.estimate.time);
  }
  return view;
}

}  // namespace lanefuse
