// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <random>
#include <vector>

#include "graph/window_graph.hpp"

namespace lanefuse::testing {

/// What a made-up window is like: a winding drive whose poses see landmarks, some of which are tied.
struct WindowShape {
  unsigned seed = 1;
  std::size_t poses = 12;
  std::size_t landmarks = 20;
  std::size_t ties = 10;           ///< as of widths and smoothing: most tell nothing about x
  double switched = 0.5;           ///< share of the ties with a switch
  double wrong = 0.2;              ///< share of the switched ties that are off by metres
  Pose2 origin{10, -20, 0.3};      ///< of the drive
  double noise = 0.05;             ///< of measurements [m], a tenth of it in rad
  double start_error = 0.1;        ///< of the start of all but the newest pose [m], a tenth of it in rad
  std::size_t most_sightings = 6;  ///< of a landmark, each with a second look now and then
};

class WindowMaker {
 public:
  using Id = WindowGraph::Id;

  explicit WindowMaker(const WindowShape& shape) : shape_(shape), random_(shape.seed) {}

  WindowGraph make() {
    WindowGraph window;
    drive(window);
    for (std::size_t i = 0; i < shape_.landmarks; ++i) add_landmark(window);
    for (std::size_t i = 0; i < shape_.ties && shape_.landmarks > 1; ++i) add_tie(window);
    return window;
  }

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }
  std::size_t below(std::size_t end) { return random_() % end; }

  Eigen::Matrix3d full_information() {
    Eigen::Matrix3d root;
    for (double& entry : root.reshaped()) entry = uniform(-3, 3);
    return root * root.transpose() + Eigen::Vector3d(5, 20, 400).asDiagonal().toDenseMatrix();
  }

  PlanarInformation planar_information() {
    const double xx = uniform(0.5, 5);
    const double yy = uniform(5, 200);
    return {xx, uniform(-0.9, 0.9) * std::sqrt(xx * yy), yy, uniform(50, 3000)};
  }

 private:
  Pose2 shaken(const Pose2& pose, double size) {
    return {pose.x + uniform(-size, size), pose.y + uniform(-size, size),
            wrap_angle(pose.heading + uniform(-size, size) / 10)};
  }

  void drive(WindowGraph& window) {
    Pose2 pose = shape_.origin;
    for (std::size_t p = 0; p < shape_.poses; ++p) {
      if (p > 0) pose = poses_.back() * Pose2{uniform(1, 3), uniform(-0.1, 0.1), uniform(-0.2, 0.2)};
      const Pose2 step = p == 0 ? Pose2{} : shaken(poses_.back().inverse() * pose, shape_.noise / 10);
      const bool newest = p + 1 == shape_.poses;
      poses_.push_back(pose);
      window.append_pose(newest ? pose : shaken(pose, shape_.start_error), step, 100 * full_information());
    }
  }

  void add_landmark(WindowGraph& window) {
    const Pose2 truth =
        poses_[below(poses_.size())] * Pose2{uniform(-5, 40), uniform(-8, 8), uniform(-3.2, 3.2)};
    landmarks_.push_back(truth);
    const Id id = window.add_landmark(shaken(truth, shape_.start_error));
    const std::size_t sightings = 1 + below(shape_.most_sightings);
    for (std::size_t i = 0; i < sightings; ++i) {
      const std::size_t p = below(poses_.size());
      // Another witness of the same place, or the same one again, whose look replaces the first.
      window.observe(window.chain()[p], id, shaken(poses_[p].inverse() * truth, shape_.noise),
                     planar_information(), below(3));
    }
  }

  void add_tie(WindowGraph& window) {
    WindowGraph::Tie tie;
    tie.from = static_cast<Id>(below(landmarks_.size()));
    tie.to = static_cast<Id>(below(landmarks_.size()));
    tie.measurement = shaken(landmarks_[tie.from].inverse() * landmarks_[tie.to], shape_.noise);
    tie.kind = static_cast<std::uint32_t>(below(2));
    if (uniform(0, 1) < shape_.switched) {
      tie.switch_prior = uniform(1, 6);
      if (uniform(0, 1) < shape_.wrong) tie.measurement.y += uniform(1, 4);
    }
    Eigen::Matrix3d information = Eigen::Vector3d(0, 100, uniform(100, 2500)).asDiagonal();
    if (below(4) == 0) information = full_information();
    window.add_tie(tie, information, below(2) == 0);
  }

  WindowShape shape_;
  std::mt19937 random_;
  std::vector<Pose2> poses_, landmarks_;  ///< as they truly are
};

/// A shape of any kind: small and large, tied much and little, its headings about pi and elsewhere.
inline WindowShape any_shape(unsigned seed) {
  WindowMaker dice({.seed = seed});
  WindowShape shape;
  shape.seed = seed + 1000;
  shape.poses = 2 + dice.below(39);
  shape.landmarks = dice.below(60);
  shape.ties = dice.below(2) == 0 ? 0 : dice.below(2 * shape.landmarks + 1);
  shape.switched = dice.uniform(0, 1);
  shape.origin = {dice.uniform(-50, 50), dice.uniform(-50, 50),
                  dice.below(2) == 0 ? dice.uniform(3.0, 3.2) : dice.uniform(-3, 3)};
  shape.most_sightings = 1 + dice.below(12);
  return shape;
}

/// Every bit that a solver may change.
inline std::vector<std::uint64_t> bits(const WindowGraph& window) {
  std::vector<std::uint64_t> result;
  const auto take = [&](const Pose2& pose) {
    for (const double number : {pose.x, pose.y, pose.heading})
      result.push_back(std::bit_cast<std::uint64_t>(number));
  };
  for (const WindowGraph::Id id : window.chain()) take(window.pose(id));
  for (WindowGraph::Id id = 0; id < window.landmark_slots(); ++id) take(window.landmark(id));
  for (WindowGraph::Id id = 0; id < window.tie_slots(); ++id)
    result.push_back(std::bit_cast<std::uint64_t>(window.tie(id).switch_value));
  return result;
}

}  // namespace lanefuse::testing
