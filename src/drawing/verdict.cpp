// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "drawing/html.hpp"
#include "drawing/report.hpp"

namespace lanefuse {
namespace {

constexpr std::size_t kNear = 6;  // index of 60 m
constexpr std::size_t kFar = 10;  // index of 100 m

bool judged(const std::vector<DeviationStatistics>& lane) {
  return lane.size() == kDistanceCount && lane[0].n + lane[kNear].n > 0;
}

/// "0.19 m at 60 m and 0.55 m at 100 m", or what there is of it.
std::string rmse_near_and_far(const std::vector<DeviationStatistics>& lane) {
  const auto one = [&lane](std::size_t index) {
    const DeviationStatistics& at = lane[index];
    return at.n == 0 ? fmt::format("not judged at {:.0f} m", at.distance_m)
                     : fmt::format("{} m at {:.0f} m", metres(at.rmse_m), at.distance_m);
  };
  return one(kNear) + " and " + one(kFar);
}

std::string against_exact_truth(const EvaluationResult& result) {
  const auto& [ego, adjacent] = result.lanes;
  std::string text =
      fmt::format("The ego lane's boundaries are off by {} (RMSE), and reach 60 m in {} of the cycles.",
                  rmse_near_and_far(ego), percent(ego[kNear].availability));
  if (!judged(adjacent)) return text + " No adjacent lane could be judged.";
  return text + fmt::format(" Adjacent lanes: {}, reaching 60 m in {}.", rmse_near_and_far(adjacent),
                            percent(adjacent[kNear].availability));
}

std::string against_ego_path(const EvaluationResult& result) {
  const auto& ego = result.lanes.ego;
  std::string text =
      fmt::format("The ego lane's centre is off the path driven later by {} (RMSE)", rmse_near_and_far(ego));
  text +=
      fmt::format("; the arc of the current yaw rate by {}, straight ahead by {}.",
                  rmse_near_and_far(result.baselines->arc), rmse_near_and_far(result.baselines->straight));
  text += fmt::format(" It reaches 60 m in {} of the cycles", percent(ego[kNear].availability));
  const auto& ahead = result.availability_with_vehicle_ahead;
  if (ahead.size() != kDistanceCount || ahead[kNear].cycles == 0) return text + ".";
  return text + fmt::format(", and in {} of those with a moving vehicle tracked ahead.",
                            percent(ahead[kNear].availability));
}

}  // namespace

std::string verdict(const EvaluationResult& result) {
  if (result.cycles == 0) return "No data: the run has no cycles.";
  if (result.cycles_with_truth == 0) {
    return fmt::format("No data: none of the {} cycles has truth to be compared with.", result.cycles);
  }
  if (!judged(result.lanes.ego)) {
    return fmt::format("No data: in none of the {} cycles with truth was there an ego lane to judge.",
                       result.cycles_with_truth);
  }
  return result.baselines ? against_ego_path(result) : against_exact_truth(result);
}

}  // namespace lanefuse
