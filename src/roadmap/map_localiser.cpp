// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/map_localiser.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/kalman.hpp"
#include "roadmap/line_locator.hpp"

namespace lanefuse {
namespace {

constexpr std::array kDistances{2.0, 14.0};  ///< [m] ahead, where markings are read
constexpr double kSameLine = 0.7;            ///< [m]
constexpr double kBeside = 15;               ///< [m] to a lane's boundaries

using State =
    Gaussian<3>;  ///< how far the track is off to the right, its heading to the right, camera to the left

class Localiser {
 public:
  Localiser(const RoadMap& map, const LocaliserConfig& config) : map_(map), config_(config) {
    for (const MapBoundary& boundary : map.boundaries) locators_.emplace_back(boundary);
    state_.covariance = Eigen::Vector3d(config.position_sigma, config.heading_sigma, config.yaw_sigma)
                            .cwiseAbs2()
                            .asDiagonal();
  }

  void advance(Time to) {
    const double seconds = last_ ? to_seconds(to - *last_) : 0;
    last_ = to;
    if (seconds <= 0) return;
    Eigen::Matrix3d keep = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    const std::array sigmas{config_.position_sigma, config_.heading_sigma, config_.yaw_sigma};
    const std::array taus{config_.position_tau, config_.heading_tau, config_.yaw_tau};
    for (int i = 0; i < 3; ++i) {
      keep(i, i) = std::exp(-seconds / taus[i]);
      noise(i, i) = sigmas[i] * sigmas[i] * (1 - keep(i, i) * keep(i, i));
    }
    predict<3>(state_, keep, noise);
  }

  void see(const SeenMarking& marking, const Pose2& by_fixes) {
    for (const double x : kDistances) {
      const std::optional<double> off = off_line(marking, x, by_fixes);
      if (x == kDistances.front()) (marking.side == Side::left ? left_ : right_) = off;
      if (!off) continue;
      using Scalar = Eigen::Matrix<double, 1, 1>;
      const Eigen::RowVector3d jacobian(-1, -x, x);
      update<3, 1>(state_, Scalar(*off - jacobian.dot(state_.mean)), jacobian,
                   Scalar(config_.sight_sigma * config_.sight_sigma));
    }
  }

  MapPose pose(Time time, const Pose2& by_fixes) {
    MapPose pose{time,  by_fixes, by_fixes * Pose2{0, state_.mean[0], state_.mean[1]},
                 {},    0,        std::sqrt(state_.covariance(0, 0)),
                 left_, right_};
    find_lane(pose);
    return pose;
  }

 private:
  const RoadMap& map_;
  LocaliserConfig config_;
  std::vector<LineLocator> locators_;
  State state_;
  std::optional<Time> last_;
  std::optional<double> left_;
  std::optional<double> right_;

  /// How far to the left of the map's line the marking seems to lie.
  std::optional<double> off_line(const SeenMarking& marking, double x, const Pose2& by_fixes) {
    const Eigen::Vector2d point = by_fixes * Eigen::Vector2d(x, marking.line.y(x));
    std::optional<double> nearest;
    for (std::size_t i = 0; i < locators_.size(); ++i) {
      const auto place = locators_[i].locate(point, kSameLine);
      if (!place) continue;
      const double paint = style_at(map_.boundaries[i], place->along).width;
      const double inwards = marking.paint_width > 0 ? 0 : (marking.side == Side::left ? -0.5 : 0.5) * paint;
      const double off = place->lateral - inwards;
      if (!nearest || std::abs(off) < std::abs(*nearest)) nearest = off;
    }
    return nearest;
  }

  void find_lane(MapPose& pose) {
    std::vector<std::optional<double>> laterals;
    for (LineLocator& locator : locators_) {
      const auto place = locator.locate(pose.by_map.position(), kBeside);
      laterals.push_back(place ? std::optional(place->lateral) : std::nullopt);
    }
    const auto lateral = [&](std::uint64_t boundary) {
      return laterals[static_cast<std::size_t>(find_boundary(map_, boundary) - map_.boundaries.data())];
    };
    for (const MapLane& lane : map_.lanes) {
      const auto left = lateral(lane.left_boundary);
      const auto right = lateral(lane.right_boundary);
      if (!left || !right || *left > 0 || *right <= 0) continue;
      pose.lane = lane.id;
      pose.lane_number = number_of(lane);
      return;
    }
  }

  [[nodiscard]] int number_of(const MapLane& lane) const {
    int number = 1;
    const MapLane* left = lane.left_lane ? lanefuse::find_lane(map_, *lane.left_lane) : nullptr;
    // A map may link its lanes in a circle.
    for (; left && number <= static_cast<int>(map_.lanes.size()); ++number) {
      left = left->left_lane ? lanefuse::find_lane(map_, *left->left_lane) : nullptr;
    }
    return number;
  }
};

}  // namespace

std::vector<MapPose> localise(const SurveyedDrive& drive, const RoadMap& map, std::span<const Time> times,
                              const LocaliserConfig& config) {
  Localiser localiser(map, config);
  std::vector<MapPose> poses;
  auto marking = drive.markings.begin();
  for (const Time time : times) {
    const auto by_fixes = pose_at(drive.track, time);
    for (; marking != drive.markings.end() && marking->time <= time; ++marking) {
      const auto then = pose_at(drive.track, marking->time);
      if (!then) continue;
      localiser.advance(marking->time);
      localiser.see(*marking, *then);
    }
    if (!by_fixes) continue;
    localiser.advance(time);
    poses.push_back(localiser.pose(time, *by_fixes));
  }
  return poses;
}

}  // namespace lanefuse
