// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/surveyed_truth.hpp"

#include "core/pose2.hpp"

namespace lanefuse {

SurveyError::SurveyError(const SurveyedTruthConfig& config)
    : random_(config.seed, "surveyed truth"),
      across_{Wander(config.ego, kForgetsWithin, random_), Wander(config.ego, kForgetsWithin, random_),
              Wander(config.adjacent, kForgetsWithin, random_),
              Wander(config.adjacent, kForgetsWithin, random_)},
      heading_(config.heading, kForgetsAfter, random_) {}

void SurveyError::advance(Time time, const Eigen::Vector2d& position) {
  if (last_) {
    const double way = (position - last_->position).norm();
    for (Wander& error : across_) error.advance(way, random_);
    heading_.advance(to_seconds(time - last_->time), random_);
  }
  last_ = Place{time, position};
}

RoleLine SurveyError::surveyed(const RoleLine& line, LaneRole role) const {
  const Pose2 moved{0, across_[role].value(), heading_.value()};
  RoleLine result;
  for (const LineAhead& piece : line.pieces()) {
    LineAhead turned;
    for (const Eigen::Vector2d& point : piece.points()) turned.extend(moved * point);
    result.add(std::move(turned));
  }
  return result;
}

}  // namespace lanefuse
