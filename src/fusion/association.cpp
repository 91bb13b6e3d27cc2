// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/association.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kFirst = -20;  ///< [m] x of the first slice; what lies behind it shares it
constexpr double kSlice = 2;    ///< [m] must be at least the gate along the road
constexpr std::size_t kSlices = 120;
constexpr std::uint32_t kEnd = 0xffffffff;

}  // namespace

FeatureAssociation::FeatureAssociation(const AssociationConfig& config, std::size_t features)
    : config_(config) {
  candidates_.reserve(features);
  claimed_in_.reserve(features);
  slices_.assign(kSlices, kEnd);
}

void FeatureAssociation::clear() {
  candidates_.clear();
  slices_.assign(kSlices, kEnd);
  claimed_in_.assign(claimed_in_.size(), 0);
  set_ = 0;
}

std::size_t FeatureAssociation::slice(double x) const {
  return static_cast<std::size_t>(std::clamp((x - kFirst) / kSlice, 0.0, static_cast<double>(kSlices - 1)));
}

void FeatureAssociation::add(Id id, const Pose2& pose) {
  std::uint32_t& last = slices_[slice(pose.x)];
  candidates_.push_back({id, pose, last});
  last = static_cast<std::uint32_t>(candidates_.size() - 1);
  if (id >= claimed_in_.size()) claimed_in_.resize(id + 1, 0);
}

void FeatureAssociation::add_claimed(Id id, const Pose2& pose) {
  add(id, pose);
  claimed_in_[id] = set_;
}

void FeatureAssociation::begin_set() { ++set_; }

bool FeatureAssociation::within_gates(const Pose2& offset, double x, double heading_sigma) const {
  const double across = config_.across + config_.across_per_metre * std::max(0.0, x);
  const double heading = config_.heading_deg * std::numbers::pi / 180 + 2 * heading_sigma;
  return std::abs(offset.x) < config_.along && std::abs(offset.y) < across &&
         std::abs(offset.heading) < heading;
}

std::optional<FeatureAssociation::Id> FeatureAssociation::claim(const Pose2& measured,
                                                                const Eigen::Matrix3d& information) {
  const Pose2 feature_from_vehicle = measured.inverse();
  const double heading_sigma = 1 / std::sqrt(information(2, 2));
  // A feature whose gates reach along its own heading stays within this of its x, whatever the heading.
  const double reach = config_.along + config_.across + config_.across_per_metre * std::max(0.0, measured.x);
  std::optional<Id> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t s = slice(measured.x - reach); s <= slice(measured.x + reach); ++s) {
    for (std::uint32_t next = slices_[s]; next != kEnd; next = candidates_[next].next) {
      const Candidate& candidate = candidates_[next];
      const Pose2 offset = feature_from_vehicle * candidate.pose;
      if (!within_gates(offset, measured.x, heading_sigma) || claimed_in_[candidate.id] == set_) continue;
      const Eigen::Vector3d e(offset.x, offset.y, offset.heading);
      const double distance = e.dot(information * e);
      if (distance >= best_distance) continue;
      best = candidate.id;
      best_distance = distance;
    }
  }
  if (best) claimed_in_[*best] = set_;
  return best;
}

}  // namespace lanefuse
