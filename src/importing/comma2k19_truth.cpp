// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/comma2k19_truth.hpp"

#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

#include "core/pose2.hpp"
#include "importing/array_log.hpp"
#include "importing/local_plane.hpp"

namespace lanefuse {
namespace {

constexpr Duration kHalfHeadingWindow = from_seconds(2.5);
constexpr double kSlowestCourse = 3.0;  ///< [m/s] below, the direction of travel is noise

/// The columns of the joined log.
enum Column : std::size_t { kPosition = 0, kVelocity = 3, kOrientation = 6 };

ArrayLog read_pose_log(const std::filesystem::path& global_pose, std::vector<std::string>& notes) {
  return read_array_log({.times = global_pose / "frame_times",
                         .values = {{global_pose / "frame_positions", 3, {0, 1, 2}},
                                    {global_pose / "frame_velocities", 3, {0, 1, 2}},
                                    {global_pose / "frame_orientations", 4, {0, 1, 2, 3}}}},
                        notes);
}

Eigen::Vector3d vector_at(const NpyTable& table, std::size_t row, std::size_t column) {
  return {table(row, column), table(row, column + 1), table(row, column + 2)};
}

/// The camera's forward axis in ECEF. The data set stores the Hamilton quaternion (w, x, y, z) whose rotation
/// matrix has the camera's axes (forward, right, down) as its columns.
Eigen::Vector3d forward_at(const NpyTable& table, std::size_t row) {
  const Eigen::Quaterniond ecef_from_camera(table(row, kOrientation), table(row, kOrientation + 1),
                                            table(row, kOrientation + 2), table(row, kOrientation + 3));
  return ecef_from_camera.normalized() * Eigen::Vector3d::UnitX();
}

/// Running sums, so that a window costs no more than a sample.
class MeanMountingYaw {
 public:
  void add(double offset, bool trusted) {
    sums_.push_back(sums_.back() + (trusted ? offset : 0));
    counts_.push_back(counts_.back() + (trusted ? 1 : 0));
  }

  /// Over the samples [begin, end).
  [[nodiscard]] double mean(std::size_t begin, std::size_t end) const {
    if (counts_[end] > counts_[begin]) return (sums_[end] - sums_[begin]) / (counts_[end] - counts_[begin]);
    return counts_.back() > 0 ? sums_.back() / counts_.back() : 0;
  }

 private:
  std::vector<double> sums_ = {0};
  std::vector<double> counts_ = {0};
};

/// Yaw rates as central differences of the headings [rad/s].
void differentiate_headings(std::vector<TrueFrame>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const TrueFrame& before = frames[i == 0 ? i : i - 1];
    const TrueFrame& after = frames[i + 1 == frames.size() ? i : i + 1];
    const double seconds = to_seconds(after.time - before.time);
    const double turn = wrap_angle(after.world_from_vehicle.heading - before.world_from_vehicle.heading);
    frames[i].yaw_rate = seconds > 0 ? turn / seconds : 0;
  }
}

}  // namespace

std::vector<double> headings_without_mounting(const std::vector<Time>& times, const std::vector<double>& yaws,
                                              const std::vector<double>& courses,
                                              const std::vector<double>& speeds) {
  assert(yaws.size() == times.size() && courses.size() == times.size() && speeds.size() == times.size());
  MeanMountingYaw mounting;
  for (std::size_t i = 0; i < times.size(); ++i) {
    mounting.add(wrap_angle(yaws[i] - courses[i]), speeds[i] >= kSlowestCourse);
  }
  std::vector<double> headings;
  std::size_t begin = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (times[begin] < times[i] - kHalfHeadingWindow) ++begin;
    while (end < times.size() && times[end] <= times[i] + kHalfHeadingWindow) ++end;
    headings.push_back(wrap_angle(yaws[i] - mounting.mean(begin, end)));
  }
  return headings;
}

std::vector<TrueFrame> read_comma2k19_poses(const std::filesystem::path& global_pose,
                                            std::vector<std::string>& notes) {
  const ArrayLog log = read_pose_log(global_pose, notes);
  const LocalPlane plane(vector_at(log.values, 0, kPosition));
  std::vector<double> yaws;
  std::vector<double> courses;
  std::vector<double> speeds;
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    const Eigen::Vector3d forward = plane.direction(forward_at(log.values, row));
    const Eigen::Vector3d velocity = plane.direction(vector_at(log.values, row, kVelocity));
    yaws.push_back(std::atan2(forward.y(), forward.x()));
    courses.push_back(std::atan2(velocity.y(), velocity.x()));
    speeds.push_back(velocity.norm());
  }
  const std::vector<double> headings = headings_without_mounting(log.times, yaws, courses, speeds);
  std::vector<TrueFrame> frames;
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    const Eigen::Vector3d camera = plane.position(vector_at(log.values, row, kPosition));
    const Pose2 world_from_camera{camera.x(), camera.y(), headings[row]};
    TrueFrame frame;
    frame.time = log.times[row];
    frame.world_from_vehicle = world_from_camera * Pose2{kCommaCameraBehindFrontAxle, 0, 0};
    frame.speed = speeds[row];
    frames.push_back(std::move(frame));
  }
  differentiate_headings(frames);
  return frames;
}

}  // namespace lanefuse
