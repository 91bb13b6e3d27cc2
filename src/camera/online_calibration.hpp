// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "camera/lane_tracker.hpp"
#include "core/kalman.hpp"
#include "core/time.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

struct OnlineCalibrationConfig {
  // How well the rig's mounting is known.
  double height_sigma = 0.015;  ///< [m]
  double roll_sigma = 0.003;    ///< [rad]
  double pitch_sigma = 0.010;   ///< [rad]
  double yaw_sigma = 0.007;     ///< [rad]
  // How the car moves on its springs and tyres, which is no change of the camera.
  double body_pitch_sigma = 0.0045;  ///< [rad]
  double body_pitch_tau = 0.3;       ///< [s]
  double body_roll_sigma = 0.0026;   ///< [rad]
  double body_roll_tau = 0.5;        ///< [s]
  double slip_sigma = 0.001;         ///< [rad] between where the car points and where it goes
  double slip_lever = 1.5;           ///< [m] times the curvature driven is further slip
  /// How much neighbouring lanes differ in width [m]: what limits the roll.
  double lane_difference_sigma = 0.08;
  /// The lanes' true width [m] between the inner edges of their markings, where it is known: the only thing
  /// that tells the height.
  std::optional<double> lane_width;
  double lane_width_sigma = 0.05;  ///< [m]
  double slowest = 8;              ///< [m/s] below, nothing is learned
};

/// How a camera stands over the road, learned while driving [Liang 2004 does so for the paper's cameras]: the
/// pitch as the mean of the tracked images', the yaw from the way the lane moves sideways against how it
/// points, the roll from how wide the neighbour lanes look beside the ego lane, the height from a known lane
/// width only. A Kalman filter over the four and over how the neighbour lanes truly differ.
///
/// A camera that is knocked out of place is noticed when the mean of three or five half seconds contradicts
/// what was learned, and learned anew. Deterministic; allocates nothing.
class OnlineCalibration {
 public:
  explicit OnlineCalibration(const Mounting& mounting, const OnlineCalibrationConfig& config = {});

  /// What to hand to the tracker: the mounting as corrected, with the covariance of the correction. The pitch
  /// and the vertical curvature of single images are not in it.
  [[nodiscard]] const CameraPose& pose() const { return pose_; }
  [[nodiscard]] CalibrationStatus status() const { return status_; }

  /// Learns from a track that was made with pose(). `speed` [m/s], `yaw_rate` [rad/s].
  void update(const LaneTrack& track, double speed, double yaw_rate, Time time);
  void reset();

 private:
  static constexpr int kHeight = 0;
  static constexpr int kRoll = 1;
  static constexpr int kPitch = 2;
  static constexpr int kYaw = 3;
  static constexpr int kLeftDifference = 4;  ///< [m] by which the left lane is truly wider than the ego lane
  static constexpr int kRightDifference = 5;
  static constexpr int kSize = 6;
  using RowVector = Eigen::Matrix<double, 1, kSize>;

  /// Sums over the images of half a second, in the camera's own terms: independent of the pose that was
  /// assumed.
  struct Block {
    double images = 0;
    double seconds = 0;
    double first_speed = 0;
    double last_speed = 0;
    double way = 0;  ///< [m]
    double way_squares = 0;
    double way_sum = 0;
    double offset_sum = 0;
    double offset_way_sum = 0;
    double heading_sum = 0;
    double pitch_sum = 0;
    double width_sum = 0;
    double curvature_sum = 0;  ///< of the car's path
    struct Neighbour {
      double images = 0;
      double difference_sum = 0;
      double lever_sum = 0;  ///< d difference / d roll [m/rad]
      double variance_sum = 0;
    };
    std::array<Neighbour, 2> neighbours;
  };

  OnlineCalibrationConfig config_;
  Mounting mounting_;
  CameraPose pose_;
  CalibrationStatus status_ = CalibrationStatus::learning;
  Gaussian<kSize> state_;
  Block block_;
  std::optional<Time> last_;
  static constexpr std::size_t kRemembered = 5;
  /// The last blocks' residuals, newest first, by what was measured.
  struct Residuals {
    std::array<double, kRemembered> values{};
    std::size_t count = 0;
  };
  std::array<Residuals, kSize> residuals_{};
  double learned_ = 0;  ///< [s] since the start or the last knock

  void add(const LaneTrack& track, double speed, double yaw_rate, double seconds);
  void add_neighbour(const LaneTrack& track, Side side);
  void finish_block();
  void learn_pitch();
  void learn_yaw();
  void learn_roll(Side side);
  void learn_height();
  /// Takes in one number unless it contradicts; where the mean of three or five contradicts, it was a knock.
  void learn(int what, double residual, const RowVector& jacobian, double variance);
  void knock(int what);
  void forget_differences();
  void publish();
};

}  // namespace lanefuse
