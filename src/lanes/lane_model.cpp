// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/lane_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanefuse {
namespace {

constexpr double kOffsetCut =
    0.6;  ///< [m] a group's feature further than this from its median offset does not count

/// The road's course with an offset of its own: eq. 12.
BoundaryFit with_offset(const BaseClothoid& base, double offset, double variance) {
  BoundaryFit fit{base.clothoid, Eigen::Matrix4d::Zero()};
  fit.clothoid.lateral_offset = offset;
  fit.covariance(0, 0) = variance;
  fit.covariance.bottomRightCorner<3, 3>() = base.covariance;
  return fit;
}

}  // namespace

void LaneModel::process(std::span<const Feature> fused, const Pose2& previous_from_current,
                        LaneEstimate& estimate) {
  for (BoundaryFilter& boundary : boundaries_) boundary.predict(previous_from_current);

  base_ = base_fit_.fit(fused);
  if (base_) {
    base_ = fit_boundaries(fused, *base_);
    found_boundaries(fused, *base_);
  } else {
    grouping_.assign(fused, base_fit_.roles(), Clothoid{}, {});
    for (BoundaryFilter& boundary : boundaries_) ++boundary.misses;
  }
  forget_boundaries();
  write_boundaries(estimate);
  count_support(fused, estimate);
  write_lanes(estimate);

  estimate.status = EstimateStatus::ok;
  estimate.reason = StatusReason::none;
  if (boundaries_.empty()) {
    estimate.status = EstimateStatus::invalid;
    estimate.reason = StatusReason::warming_up;
  } else if (!ego_lane(estimate)) {
    estimate.status = EstimateStatus::degraded;
    estimate.reason = StatusReason::no_ego_lane;
  } else if (!base_) {
    estimate.status = EstimateStatus::degraded;
    estimate.reason = StatusReason::no_road_course;
  }
}

BaseClothoid LaneModel::fit_boundaries(std::span<const Feature> fused, const BaseClothoid& heading_fit) {
  offsets_.clear();
  group_ids_.clear();
  for (const BoundaryFilter& boundary : boundaries_) {
    offsets_.push_back(boundary.clothoid().lateral_offset);
    group_ids_.push_back(boundary.id());
  }
  BaseClothoid base = heading_fit;
  grouping_.assign(fused, base_fit_.roles(), base.clothoid, offsets_);
  if (config_.base.fit == BaseFit::joint && !offsets_.empty()) {
    const auto joint = base_fit_.refine(fused, grouping_.groups(), static_cast<int>(offsets_.size()));
    if (joint) base = *joint;
    grouping_.assign(fused, base_fit_.roles(), base.clothoid, offsets_);
  }
  for (std::size_t b = 0; b < boundaries_.size(); ++b) {
    const auto fit = fit_offset(fused, static_cast<int>(b), base);
    if (!fit) {
      ++boundaries_[b].misses;
      continue;
    }
    boundaries_[b].update(*fit);
    observe(boundaries_[b], fused, static_cast<int>(b));
  }
  return base;
}

std::optional<BoundaryFit> LaneModel::fit_offset(std::span<const Feature> fused, int group,
                                                 const BaseClothoid& base) {
  const auto groups = grouping_.groups();
  auto& offsets = group_offsets_;
  offsets.clear();
  double correlation = 0;
  double all = 0;
  for (std::size_t i = 0; i < fused.size(); ++i) {
    if (groups[i] != group) continue;
    // The course's own error grows with the distance: near features know the offset best.
    const double weight =
        fused[i].confidence / (1 + std::pow(std::max(0.0, fused[i].x) / config_.offset_range, 2));
    offsets.emplace_back(fused[i].y - base.clothoid.y(fused[i].x), weight);
    correlation +=
        weight * (fused[i].track_id == kNoTrack ? config_.base.correlation : config_.base.track_correlation);
    all += weight;
  }
  if (offsets.empty()) return std::nullopt;
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  const double median = middle->first;
  double weight = 0;
  double sum = 0;
  for (const auto& [offset, w] : offsets) {
    if (std::abs(offset - median) > kOffsetCut) continue;
    weight += w;
    sum += w * offset;
  }
  const double sigma = config_.base.position_sigma;
  return with_offset(base, sum / weight, correlation / all * sigma * sigma / weight);
}

void LaneModel::observe(BoundaryFilter& boundary, std::span<const Feature> fused, int group) const {
  double doubt = 1;
  std::uint32_t sound = 0;
  const auto groups = grouping_.groups();
  for (std::size_t i = 0; i < fused.size(); ++i) {
    if (groups[i] != group) continue;
    if (grouping_.is_sound(fused[i])) ++sound;
    doubt *= 1 - 0.5 * fused[i].confidence;
    if (fused[i].marking.type != MarkingType::unknown) boundary.marking.type = fused[i].marking.type;
    if (fused[i].marking.colour != MarkingColour::unknown) boundary.marking.colour = fused[i].marking.colour;
  }
  boundary.confidence = 1 - doubt;
  boundary.misses = sound >= config_.keep_features ? 0 : boundary.misses + 1;
}

void LaneModel::found_boundaries(std::span<const Feature> fused, const BaseClothoid& base) {
  const double variance = config_.birth_sigma * config_.birth_sigma;
  for (const double offset : grouping_.new_offsets(fused, base.clothoid, offsets_)) {
    boundaries_.emplace_back(next_boundary_++, with_offset(base, offset, variance), config_);
  }
}

void LaneModel::forget_boundaries() {
  auto kept = boundaries_.begin();
  for (BoundaryFilter& boundary : boundaries_) {
    const double offset = boundary.clothoid().lateral_offset;
    const bool beside_older = std::any_of(boundaries_.begin(), kept, [&](const BoundaryFilter& older) {
      return std::abs(older.clothoid().lateral_offset - offset) < config_.merge_distance;
    });
    if (boundary.misses <= config_.max_misses && !beside_older) *kept++ = boundary;
  }
  boundaries_.erase(kept, boundaries_.end());
}

void LaneModel::write_boundaries(LaneEstimate& estimate) {
  from_left_.resize(boundaries_.size());
  std::iota(from_left_.begin(), from_left_.end(), std::size_t{0});
  const auto offset = [&](std::size_t b) { return boundaries_[b].clothoid().lateral_offset; };
  std::sort(from_left_.begin(), from_left_.end(), [&](std::size_t a, std::size_t b) {
    return offset(a) > offset(b) || (offset(a) == offset(b) && a < b);
  });
  for (Boundary& old : estimate.boundaries) spare_points_.push_back(std::move(old.points));
  estimate.boundaries.clear();
  for (const std::size_t b : from_left_) {
    const BoundaryFilter& filter = boundaries_[b];
    Boundary& boundary = estimate.boundaries.emplace_back();
    if (!spare_points_.empty()) {
      boundary.points.swap(spare_points_.back());
      spare_points_.pop_back();
    }
    boundary.id = filter.id();
    boundary.clothoid = filter.clothoid();
    boundary.covariance = filter.covariance();
    boundary.confidence = filter.confidence;
    boundary.marking = filter.marking;
    cut_to_range(boundary);
  }
}

void LaneModel::cut_to_range(Boundary& boundary) const {
  boundary.range_end = config_.range_max;
  sample_points(boundary);
  const auto unsure =
      std::find_if(boundary.points.begin(), boundary.points.end(),
                   [&](const BoundaryPoint& point) { return point.sigma > config_.sigma_max; });
  boundary.points.erase(unsure, boundary.points.end());
  boundary.range_end = boundary.points.empty() ? 0 : boundary.points.back().x;
}

void LaneModel::count_support(std::span<const Feature> fused, LaneEstimate& estimate) const {
  const auto groups = grouping_.groups();
  for (std::size_t i = 0; i < fused.size(); ++i) {
    if (groups[i] < 0) continue;
    for (Boundary& boundary : estimate.boundaries) {
      if (boundary.id == group_ids_[groups[i]]) ++boundary.support[static_cast<std::size_t>(fused[i].source)];
    }
  }
}

void LaneModel::write_lanes(LaneEstimate& estimate) {
  estimate.lanes.clear();
  for (std::size_t b = 0; b + 1 < estimate.boundaries.size(); ++b) {
    const Boundary& left = estimate.boundaries[b];
    const Boundary& right = estimate.boundaries[b + 1];
    const double width = left.clothoid.lateral_offset - right.clothoid.lateral_offset;
    if (width < config_.lane_width_min || width > config_.lane_width_max) continue;
    Lane lane;
    lane.id = lane_id(left.id, right.id);
    lane.left_boundary = left.id;
    lane.right_boundary = right.id;
    if (!estimate.lanes.empty() && estimate.lanes.back().right_boundary == lane.left_boundary) {
      lane.left_lane = estimate.lanes.back().id;
      estimate.lanes.back().right_lane = lane.id;
    }
    estimate.lanes.push_back(lane);
  }
  forget_lanes(estimate);
}

void LaneModel::forget_lanes(const LaneEstimate& estimate) {
  std::erase_if(known_lanes_, [&](const KnownLane& lane) {
    return !find_boundary(estimate, lane.left) || !find_boundary(estimate, lane.right);
  });
}

std::uint64_t LaneModel::lane_id(std::uint64_t left, std::uint64_t right) {
  const auto known = std::find_if(known_lanes_.begin(), known_lanes_.end(), [&](const KnownLane& lane) {
    return lane.left == left && lane.right == right;
  });
  if (known != known_lanes_.end()) return known->id;
  known_lanes_.push_back({left, right, next_lane_});
  return next_lane_++;
}

void LaneModel::explain(std::span<const Feature> fused, DebugView& view) const {
  const auto roles = base_fit_.roles();
  const auto groups = grouping_.groups();
  const auto lives = [&](std::uint64_t id) {
    return std::any_of(boundaries_.begin(), boundaries_.end(), [id](const auto& b) { return b.id() == id; });
  };
  view.features.clear();
  for (std::size_t i = 0; i < fused.size(); ++i) {
    FusedFeature feature{fused[i]};
    feature.in_base_fit = roles[i] == FitRole::inlier;
    feature.outlier = roles[i] == FitRole::outlier;
    if (groups[i] >= 0 && lives(group_ids_[groups[i]])) feature.boundary = group_ids_[groups[i]];
    view.features.push_back(feature);
  }
  view.base_clothoid.reset();
  if (base_) view.base_clothoid = base_->clothoid;
}

void LaneModel::reset() {
  base_.reset();
  boundaries_.clear();
  known_lanes_.clear();
  next_boundary_ = 1;
  next_lane_ = 1;
}

}  // namespace lanefuse
