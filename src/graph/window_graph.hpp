// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "graph/edge_terms.hpp"
#include "graph/quad.hpp"

namespace lanefuse {

/// Information about a position and, apart from it, about a heading.
struct PlanarInformation {
  double xx = 0, xy = 0, yy = 0;  ///< [1/m^2]
  double heading = 0;             ///< [1/rad^2]
};

/// `information` with its axes turned by `angle`.
PlanarInformation turned(const PlanarInformation& information, double angle);

/// A chain of poses, the landmarks seen from it, and ties between landmarks: the graph of [IROS16, sec. II-E]
/// as it is kept from cycle to cycle. Whatever is added, replaced or dropped costs what it touches, not what
/// the graph holds, and within the limits given at the beginning nothing is allocated.
///
/// Ids stay what they are until their owner is removed; then they are given to others. All poses are in one
/// frame of the caller's, which need not move with the car.
class WindowGraph {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffff;

  /// What memory is set aside for; more is taken when more comes.
  struct Limits {
    std::uint32_t poses = 512;
    std::uint32_t landmarks = 4096;
    std::uint32_t observations = 65536;
    std::uint32_t ties = 16384;
  };

  /// Four observations of one landmark.
  struct alignas(kQuadAlignment) Block {
    Quad x, y, heading;      ///< of the landmark, seen from the pose [m, rad]
    Quad mean, half, cross;  ///< its information as (xx + yy) / 2, (xx - yy) / 2, xy, in the pose's frame
    Quad heading_information;
    std::array<Id, 4> pose;  ///< kNowhere where there is none: its information is zero, too
    std::array<std::uint64_t, 4> witness;
    Id next = kNone;
  };

  /// The pose that empty places of blocks refer to; no pose of the graph.
  static constexpr Id kNowhere = 0;

  /// The step from a pose of the chain to the next one.
  struct Step {
    Pose2 measurement;
    Symmetric3 information;  ///< in the frame of the earlier pose
  };

  /// A constraint between two landmarks.
  struct Tie {
    Id from = kNone, to = kNone;
    Pose2 measurement;        ///< `to` seen from `from`
    Symmetric3 information;   ///< in the frame of `from`
    double switch_prior = 0;  ///< Omega_s; 0 for a tie without a switch
    double switch_value = 1;  ///< s, written by the solver
    std::uint32_t kind = 0;   ///< the caller's: two landmarks have at most one of a kind and direction
    Id next_of_from = kNone, next_of_to = kNone;
  };

  WindowGraph();
  explicit WindowGraph(const Limits& limits);

  /// Adds the newest pose. Only the newest is held: it is the gauge. `information` is of the step, in the
  /// frame of the measurement as in `Edge`; the first pose has no step.
  Id append_pose(const Pose2& pose, const Pose2& step, const Eigen::Matrix3d& information);

  /// Takes the `index`-th pose out of the chain and ties its neighbours by the composition of its two steps.
  /// It must not be the newest, and nothing may be observed from it.
  void remove_pose(std::size_t index);

  Id add_landmark(const Pose2& pose);
  /// Removes a landmark with its observations and ties.
  void remove_landmark(Id landmark);

  /// The landmark as seen from a pose, with the information in the landmark's own measured frame. A second
  /// observation by the same witness from the same pose replaces the first. Returns whether it was the first.
  bool observe(Id pose, Id landmark, const Pose2& seen, const PlanarInformation& own, std::uint64_t witness);

  /// Ties two landmarks, or returns kNone if they are one or are tied like that already. Of `tie` the ends,
  /// the measurement, the kind and the switch prior are read; `information` is in the frame of the
  /// measurement. `symmetric`: a tie the other way round counts as the same.
  Id add_tie(const Tie& tie, const Eigen::Matrix3d& information, bool symmetric);

  void clear();

  [[nodiscard]] std::span<const Id> chain() const { return chain_; }  ///< from old to new
  [[nodiscard]] std::span<const Step> steps() const {
    return steps_;
  }  ///< [k] leads from chain()[k-1] to [k]
  [[nodiscard]] Pose2 pose(Id id) const { return {poses_[id][0], poses_[id][1], poses_[id][2]}; }
  void place_pose(Id id, const Pose2& pose) { poses_[id] = Quad{pose.x, pose.y, pose.heading, 0}; }
  [[nodiscard]] std::uint32_t observations_from(Id pose) const { return observed_from_[pose]; }

  /// Ids of landmarks are below this; not all of them are alive.
  [[nodiscard]] Id landmark_slots() const { return static_cast<Id>(landmarks_.size()); }
  [[nodiscard]] bool is_alive(Id landmark) const { return alive_[landmark] != 0; }
  [[nodiscard]] Pose2 landmark(Id id) const {
    return {landmarks_[id][0], landmarks_[id][1], landmarks_[id][2]};
  }
  void place_landmark(Id id, const Pose2& pose) { landmarks_[id] = Quad{pose.x, pose.y, pose.heading, 0}; }
  [[nodiscard]] std::uint32_t observation_count(Id landmark) const { return counts_[landmark]; }
  /// The sum of its observations' information, each in its own measured frame.
  [[nodiscard]] const PlanarInformation& observed_information(Id landmark) const { return own_[landmark]; }
  [[nodiscard]] Id first_block(Id landmark) const { return first_block_[landmark]; }
  [[nodiscard]] const Block& block(Id id) const { return blocks_[id]; }
  [[nodiscard]] Id first_tie(Id landmark) const { return first_tie_[landmark]; }
  /// The tie after `tie` among those of `landmark`.
  [[nodiscard]] Id next_tie(const Tie& tie, Id landmark) const {
    return tie.from == landmark ? tie.next_of_from : tie.next_of_to;
  }
  [[nodiscard]] Id tie_slots() const { return static_cast<Id>(ties_.size()); }
  [[nodiscard]] bool is_tie(Id id) const { return ties_[id].from != kNone; }
  [[nodiscard]] const Tie& tie(Id id) const { return ties_[id]; }
  void set_switch(Id tie, double value) { ties_[tie].switch_value = value; }

  [[nodiscard]] std::size_t landmark_count() const { return landmark_count_; }
  [[nodiscard]] std::size_t observation_count() const { return observation_count_; }
  [[nodiscard]] std::size_t tie_count() const { return tie_count_; }
  [[nodiscard]] std::size_t pose_slots() const { return poses_.size(); }

 private:
  void drop_blocks(Id landmark);
  void drop_ties(Id landmark);
  void unlink(Id tie, Id landmark);
  Id take_block();

  Quads poses_;  ///< x, y, heading; [kNowhere] is all zero
  std::vector<std::uint32_t> observed_from_;
  std::vector<Id> free_poses_;
  std::vector<Id> chain_;
  std::vector<Step> steps_;

  Quads landmarks_;
  std::vector<std::uint8_t> alive_;
  std::vector<std::uint32_t> counts_;
  std::vector<PlanarInformation> own_;
  std::vector<Id> first_block_, first_tie_;
  std::vector<Id> free_landmarks_;

  std::vector<Block> blocks_;
  Id free_block_ = kNone;
  std::vector<Tie> ties_;
  std::vector<Id> free_ties_;
  std::size_t landmark_count_ = 0, observation_count_ = 0, tie_count_ = 0;
};

}  // namespace lanefuse
