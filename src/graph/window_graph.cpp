// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_graph.hpp"

#include <cassert>
#include <cmath>

#include <Eigen/LU>

namespace lanefuse {

namespace {

using Id = WindowGraph::Id;

Id take_slot(std::vector<Id>& free) {
  const Id id = free.back();
  free.pop_back();
  return id;
}

Symmetric3 in_frame_of_from(const Pose2& measurement, const Eigen::Matrix3d& m) {
  const Symmetric3 own{m(0, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2), m(2, 2)};
  return turned(own, std::cos(measurement.heading), std::sin(measurement.heading));
}

Eigen::Matrix3d dense(const Symmetric3& m) {
  return (Eigen::Matrix3d() << m.xx, m.xy, m.xh, m.xy, m.yy, m.yh, m.xh, m.yh, m.hh).finished();
}

/// The step over two steps. In the frame of the earliest pose the errors of the first are as they are, its
/// heading error swings the second's end, and the second's are turned.
WindowGraph::Step composed(const WindowGraph::Step& first, const WindowGraph::Step& second) {
  const Pose2 whole = first.measurement * second.measurement;
  Eigen::Matrix3d swing = Eigen::Matrix3d::Identity();
  swing(0, 2) = first.measurement.y - whole.y;
  swing(1, 2) = whole.x - first.measurement.x;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = rotation(first.measurement.heading);
  const Eigen::Matrix3d covariance = swing * dense(first.information).inverse() * swing.transpose() +
                                     turn * dense(second.information).inverse() * turn.transpose();
  const Eigen::Matrix3d m = covariance.inverse();
  return {whole, {m(0, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2), m(2, 2)}};
}

void write_observation(WindowGraph::Block& block, std::size_t place, const Pose2& seen,
                       const PlanarInformation& own) {
  const PlanarInformation information = turned(own, seen.heading);
  block.x[place] = seen.x;
  block.y[place] = seen.y;
  block.heading[place] = seen.heading;
  block.mean[place] = (information.xx + information.yy) / 2;
  block.half[place] = (information.xx - information.yy) / 2;
  block.cross[place] = information.xy;
  block.heading_information[place] = information.heading;
}

PlanarInformation own_information(const WindowGraph::Block& block, std::size_t place) {
  const PlanarInformation information{block.mean[place] + block.half[place], block.cross[place],
                                      block.mean[place] - block.half[place],
                                      block.heading_information[place]};
  return turned(information, -block.heading[place]);
}

void add(PlanarInformation& sum, const PlanarInformation& term, double sign) {
  sum.xx += sign * term.xx;
  sum.xy += sign * term.xy;
  sum.yy += sign * term.yy;
  sum.heading += sign * term.heading;
}

WindowGraph::Block empty_block() {
  WindowGraph::Block block{};
  block.pose.fill(WindowGraph::kNowhere);
  return block;
}

}  // namespace

PlanarInformation turned(const PlanarInformation& information, double angle) {
  const double mean = (information.xx + information.yy) / 2;
  const double half = (information.xx - information.yy) / 2;
  const double c = std::cos(2 * angle);
  const double s = std::sin(2 * angle);
  const double turned_half = c * half - s * information.xy;
  return {mean + turned_half, s * half + c * information.xy, mean - turned_half, information.heading};
}

WindowGraph::WindowGraph() : WindowGraph(Limits{}) {}

WindowGraph::WindowGraph(const Limits& limits) {
  poses_.reserve(limits.poses + 1);
  observed_from_.reserve(limits.poses + 1);
  free_poses_.reserve(limits.poses + 1);
  chain_.reserve(limits.poses);
  steps_.reserve(limits.poses);
  landmarks_.reserve(limits.landmarks);
  alive_.reserve(limits.landmarks);
  counts_.reserve(limits.landmarks);
  own_.reserve(limits.landmarks);
  first_block_.reserve(limits.landmarks);
  first_tie_.reserve(limits.landmarks);
  free_landmarks_.reserve(limits.landmarks);
  // A landmark's newest block need not be full.
  blocks_.reserve(limits.observations / 4 + limits.landmarks);
  ties_.reserve(limits.ties);
  free_ties_.reserve(limits.ties);
  clear();
}

void WindowGraph::clear() {
  poses_.assign(1, Quad{});
  observed_from_.assign(1, 0);
  free_poses_.clear();
  chain_.clear();
  steps_.clear();
  landmarks_.clear();
  alive_.clear();
  counts_.clear();
  own_.clear();
  first_block_.clear();
  first_tie_.clear();
  free_landmarks_.clear();
  blocks_.clear();
  free_block_ = kNone;
  ties_.clear();
  free_ties_.clear();
  landmark_count_ = observation_count_ = tie_count_ = 0;
}

Id WindowGraph::append_pose(const Pose2& pose, const Pose2& step, const Eigen::Matrix3d& information) {
  if (free_poses_.empty()) {
    free_poses_.push_back(static_cast<Id>(poses_.size()));
    poses_.emplace_back();
    observed_from_.push_back(0);
  }
  const Id id = take_slot(free_poses_);
  place_pose(id, pose);
  observed_from_[id] = 0;
  steps_.push_back(chain_.empty() ? Step{} : Step{step, in_frame_of_from(step, information)});
  chain_.push_back(id);
  return id;
}

void WindowGraph::remove_pose(std::size_t index) {
  assert(index + 1 < chain_.size() && observed_from_[chain_[index]] == 0);
  steps_[index + 1] = index == 0 ? Step{} : composed(steps_[index], steps_[index + 1]);
  free_poses_.push_back(chain_[index]);
  chain_.erase(chain_.begin() + static_cast<std::ptrdiff_t>(index));
  steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(index));
}

Id WindowGraph::add_landmark(const Pose2& pose) {
  if (free_landmarks_.empty()) {
    free_landmarks_.push_back(landmark_slots());
    landmarks_.emplace_back();
    alive_.push_back(0);
    counts_.push_back(0);
    own_.emplace_back();
    first_block_.push_back(kNone);
    first_tie_.push_back(kNone);
  }
  const Id id = take_slot(free_landmarks_);
  place_landmark(id, pose);
  alive_[id] = 1;
  counts_[id] = 0;
  own_[id] = {};
  first_block_[id] = first_tie_[id] = kNone;
  ++landmark_count_;
  return id;
}

void WindowGraph::remove_landmark(Id landmark) {
  assert(is_alive(landmark));
  drop_blocks(landmark);
  drop_ties(landmark);
  alive_[landmark] = 0;
  free_landmarks_.push_back(landmark);
  --landmark_count_;
}

void WindowGraph::drop_blocks(Id landmark) {
  Id id = first_block_[landmark];
  while (id != kNone) {
    Block& block = blocks_[id];
    for (const Id pose : block.pose) {
      if (pose != kNowhere) --observed_from_[pose];
    }
    const Id next = block.next;
    block.next = free_block_;
    free_block_ = id;
    id = next;
  }
  observation_count_ -= counts_[landmark];
  first_block_[landmark] = kNone;
}

Id WindowGraph::take_block() {
  if (free_block_ == kNone) {
    blocks_.push_back(empty_block());
    return static_cast<Id>(blocks_.size() - 1);
  }
  const Id id = free_block_;
  free_block_ = blocks_[id].next;
  blocks_[id] = empty_block();
  return id;
}

bool WindowGraph::observe(Id pose, Id landmark, const Pose2& seen, const PlanarInformation& own,
                          std::uint64_t witness) {
  // The newest block comes first; only that one can have empty places.
  for (Id id = first_block_[landmark]; id != kNone; id = blocks_[id].next) {
    Block& block = blocks_[id];
    for (std::size_t place = 0; place < 4; ++place) {
      if (block.pose[place] != pose || block.witness[place] != witness) continue;
      add(own_[landmark], own_information(block, place), -1);
      add(own_[landmark], own, 1);
      write_observation(block, place, seen, own);
      return false;
    }
  }
  const std::size_t place = counts_[landmark] % 4;
  if (place == 0) {
    const Id fresh = take_block();
    blocks_[fresh].next = first_block_[landmark];
    first_block_[landmark] = fresh;
  }
  Block& block = blocks_[first_block_[landmark]];
  write_observation(block, place, seen, own);
  block.pose[place] = pose;
  block.witness[place] = witness;
  add(own_[landmark], own, 1);
  ++counts_[landmark];
  ++observed_from_[pose];
  ++observation_count_;
  return true;
}

Id WindowGraph::add_tie(const Tie& tie, const Eigen::Matrix3d& information, bool symmetric) {
  if (tie.from == tie.to) return kNone;
  for (Id id = first_tie_[tie.from]; id != kNone; id = next_tie(ties_[id], tie.from)) {
    const Tie& other = ties_[id];
    if (other.kind != tie.kind) continue;
    if (other.to == tie.to || (symmetric && other.from == tie.to)) return kNone;
  }
  if (free_ties_.empty()) {
    free_ties_.push_back(tie_slots());
    ties_.emplace_back();
  }
  const Id id = take_slot(free_ties_);
  Tie& own = ties_[id] = tie;
  own.information = in_frame_of_from(tie.measurement, information);
  own.switch_value = 1;
  own.next_of_from = first_tie_[tie.from];
  own.next_of_to = first_tie_[tie.to];
  first_tie_[tie.from] = first_tie_[tie.to] = id;
  ++tie_count_;
  return id;
}

void WindowGraph::drop_ties(Id landmark) {
  while (first_tie_[landmark] != kNone) {
    const Id id = first_tie_[landmark];
    Tie& tie = ties_[id];
    first_tie_[landmark] = next_tie(tie, landmark);
    unlink(id, tie.from == landmark ? tie.to : tie.from);
    tie = {};
    free_ties_.push_back(id);
    --tie_count_;
  }
}

void WindowGraph::unlink(Id tie, Id landmark) {
  Id* link = &first_tie_[landmark];
  while (*link != tie) {
    Tie& other = ties_[*link];
    link = other.from == landmark ? &other.next_of_from : &other.next_of_to;
  }
  *link = next_tie(ties_[tie], landmark);
}

}  // namespace lanefuse
