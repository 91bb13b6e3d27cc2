// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/paint_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "road/camera_view_error.hpp"
#include "road/heading_update.hpp"

namespace lanefuse {
namespace {

constexpr std::array kBands{0.0, 12.0, 20.0, 30.0, 40.0, 50.0, 60.0, 75.0, 90.0, 110.0, 160.0};  // [m]
constexpr double kGateSigmas = 3;
constexpr double kAmbiguous = 0.6;  ///< [m] sigma of where the lines are
constexpr int kUnexplainedFrames = 3;
constexpr double kWidestGate = 1.2;  ///< [m] beyond, it is nearer to the next line
constexpr double kFreshWay = 1.5;    ///< [m] driven, after which paint is seen anew
constexpr double kFresh = 1.25;      ///< repeats: hardly any
constexpr double kMostRepeats = 20;
constexpr double kNearPaint = 60;       ///< [m] ahead: paint that must be of known lines
constexpr double kBeside = 2.2;         ///< [m] from a line: may be that line elsewhere
constexpr double kPainted = 2;          ///< features in a frame, of a line that is painted
constexpr double kFreedBefore = 25;     ///< [m] before the first such band
constexpr double kHeadingReach = 60;    ///< [m] further, headings say too little
constexpr double kHeadingRepeats = 10;  ///< headings of a frame lean together
constexpr double kRefusedSigmas = 4;    ///< of a band's mean

double square(double x) { return x * x; }

}  // namespace

std::size_t PaintUpdate::take(const FeatureSet& set, const Pose2& now_from_measured, double moved,
                              RoadState& state) {
  repeats_ = std::clamp(kFreshWay / std::max(moved, 1e-3), 1.0, kMostRepeats);
  by_range_.clear();
  strays_.clear();
  first_ = set.features.data();
  given_to_.assign(set.features.size(), 0);
  for (const Feature& feature : set.features) by_range_.push_back(&feature);
  std::sort(by_range_.begin(), by_range_.end(),
            [](const Feature* a, const Feature* b) { return a->x < b->x; });
  given_.resize(RoadState::kMostLines);
  near_paint_ = {};
  near_.assign(RoadState::kMostLines, {});
  find_yellow(now_from_measured, state);
  next_ = 0;
  used_ = 0;
  if (!config_.range_order) before_frame_.emplace(state).rebuild_axis();
  bool explained = true;
  for (std::size_t b = 0; b + 1 < kBands.size() && explained; ++b) {
    explained = take_band(kBands[b], kBands[b + 1], now_from_measured, state);
    if (explained) continue;
    if (++unexplained_ < kUnexplainedFrames) break;
    unexplained_ = 0;
    state.free_course(kBands[b] - kFreedBefore);
  }
  if (explained) unexplained_ = 0;
  let_go(state);
  return used_;
}

void PaintUpdate::take_headings(const FeatureSet& set, const Pose2& now_from_measured, RoadState& state) {
  by_range_.clear();
  for (const Feature& feature : set.features) {
    if (feature.x < kHeadingReach) by_range_.push_back(&feature);
  }
  std::sort(by_range_.begin(), by_range_.end(),
            [](const Feature* a, const Feature* b) { return a->x < b->x; });
  for (const Feature* feature : by_range_) {
    const Eigen::Vector2d place = now_from_measured * Eigen::Vector2d(feature->x, feature->y);
    const double heading = now_from_measured.heading + feature->heading;
    take_heading(place, heading, kHeadingRepeats * feature->covariance(2, 2), state);
  }
}

/// Gives whether the lines explain what was seen: else it is the road that goes otherwise than was believed.
bool PaintUpdate::take_band(double begin, double end, const Pose2& now_from_measured, RoadState& state) {
  while (next_ < by_range_.size() && by_range_[next_]->x < begin) ++next_;
  if (next_ == by_range_.size() || by_range_[next_]->x >= end) return true;
  state.rebuild_axis();
  gates_.clear();
  const Eigen::Vector2d middle((begin + end) / 2, 0);
  const RoadState& from = known(state);
  for (const KnownLine& line : from.lines()) {
    const auto foot = from.axis().project(corrected(middle, now_from_measured, from).point);
    const Eigen::Vector2d beside(middle.x(), from.offset(line, foot.place.station) - foot.lateral);
    const double variance = from.numbers().variance(row_of(line, beside, now_from_measured, from));
    gates_.push_back(std::sqrt(variance));
    given_[gates_.size() - 1].clear();
  }
  // Where the road may be half a lane aside, its lines would be taken for their neighbours: better wait until
  // the car is nearer.
  const bool labelled = config_.association == RoadAssociation::labelled;
  const bool ambiguous =
      !labelled && !gates_.empty() && *std::min_element(gates_.begin(), gates_.end()) > kAmbiguous;
  const std::size_t strays = strays_.size();
  for (; next_ < by_range_.size() && by_range_[next_]->x < end; ++next_) {
    if (ambiguous || is_void(*by_range_[next_])) continue;
    if (by_range_[next_]->x < kNearPaint) ++near_paint_.seen;
    give(*by_range_[next_], now_from_measured, from);
  }
  if (!labelled && !is_explained(strays, from)) return false;
  if (before_frame_) look_again(now_from_measured, state);
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    near_[i].on += given_[i].size();
    // What few features there are where a line has no paint are of something else.
    if (given_[i].empty() || (!labelled && state.lines()[i].density < kPainted)) continue;
    used_ += take_line(state.lines()[i], given_[i], now_from_measured, state);
  }
  return true;
}

void PaintUpdate::give(const Feature& feature, const Pose2& now_from_measured, const RoadState& state) {
  const SeenPaint paint = corrected({feature.x, feature.y}, now_from_measured, state);
  const RoadAxis::Foot foot = state.axis().project(paint.point);
  const Eigen::Vector2d normal = rotation(-now_from_measured.heading) * foot.place.normal();
  const double variance = square(state.noise_scale()) * own_variance(feature, normal, config_.camera);
  const bool labelled = config_.association == RoadAssociation::labelled;
  std::size_t nearest = state.lines().size();
  double least = 1e9;
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    const KnownLine& line = state.lines()[i];
    const double residual = foot.lateral - state.offset(line, foot.place.station);
    const bool candidate =
        labelled ? line.label == feature.label && feature.label >= 0 : std::abs(residual) < std::abs(least);
    if (!candidate) continue;
    nearest = i;
    least = residual;
  }
  if (nearest < state.lines().size()) {
    const double gate = std::min(kWidestGate, kGateSigmas * std::sqrt(square(gates_[nearest]) + variance));
    if (labelled || std::abs(least) < gate) {
      given_[nearest].push_back({least, variance, &feature});
      return;
    }
    if (std::abs(least) < kBeside) {
      Near& near = near_[nearest];
      ++(least > 0 ? near.left : near.right);
      near.from = std::min(near.from, feature.x);
    }
  }
  strays_.push_back({foot.place.station, foot.lateral, feature.marking, feature.label});
}

/// How far the features that the frame's beginning gave to lines are from where the lines are believed to be
/// by now: to take in what earlier bands have told already would be to believe it twice.
void PaintUpdate::look_again(const Pose2& now_from_measured, const RoadState& state) {
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    for (Given& one : given_[i]) {
      const Eigen::Vector2d seen(one.feature->x, one.feature->y);
      const RoadAxis::Foot foot = state.axis().project(corrected(seen, now_from_measured, state).point);
      one.residual = foot.lateral - state.offset(state.lines()[i], foot.place.station);
    }
  }
}

SparseRow PaintUpdate::row_of(const KnownLine& line, const Eigen::Vector2d& seen,
                              const Pose2& now_from_measured, const RoadState& state) const {
  const SeenPaint paint = corrected(seen, now_from_measured, state);
  const RoadAxis::Foot foot = state.axis().project(paint.point);
  const double station = foot.place.station;
  // A line that leaves the axis is left or right of the point as its own direction has it.
  const Eigen::Vector2d across = foot.place.normal() - state.slope(line, station) * foot.place.tangent;
  SparseRow row;
  state.add_lateral(row, foot.place);
  state.add_offset(row, line, station, -1);
  row.add(kPaintPitch, across.dot(paint.by_pitch));
  state.add_relative_height(row, seen.x(), across.dot(paint.by_height));
  row.add(kPaintYaw, across.dot(paint.by_turn));
  row.add(kPaintLean, across.dot(paint.by_turn));
  return row;
}

std::size_t PaintUpdate::take_line(KnownLine& line, std::vector<Given>& given, const Pose2& now_from_measured,
                                   RoadState& state) {
  const auto middle = given.begin() + static_cast<std::ptrdiff_t>(given.size() / 2);
  std::nth_element(given.begin(), middle, given.end(),
                   [](const Given& a, const Given& b) { return a.residual < b.residual; });
  const double median = middle->residual;
  double weights = 0;
  double residual = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::erase_if(given, [&](const Given& one) {
    return square(one.residual - median) > square(kGateSigmas) * one.variance;
  });
  for (const Given& one : given) {
    const double weight = 1 / one.variance;
    weights += weight;
    residual += weight * one.residual;
    place += weight * Eigen::Vector2d(one.feature->x, one.feature->y);
    if (one.feature->marking.colour != MarkingColour::unknown)
      line.marking.colour = one.feature->marking.colour;
    if (one.feature->marking.type != MarkingType::unknown) line.marking.type = one.feature->marking.type;
  }
  residual /= weights;
  const SparseRow row = row_of(line, place / weights, now_from_measured, state);
  const double noise = repeats_ / weights;
  const double surprise = square(residual) / (state.numbers().variance(row) + noise);
  if (config_.association == RoadAssociation::gated && surprise > square(kRefusedSigmas)) return 0;
  // What is taken for a repetition is expected to err more than it does: it says nothing of the sensors'
  // noise.
  if (repeats_ < kFresh) state.note_surprise(std::min(surprise, square(kRefusedSigmas)));
  state.numbers().update(row, -residual, noise);
  if (place.x() < kNearPaint * weights) near_paint_.used += given.size();
  for (const Given& one : given) given_to_[static_cast<std::size_t>(one.feature - first_)] = line.id;
  line.paint = static_cast<std::uint16_t>(line.paint + given.size());
  return given.size();
}

}  // namespace lanefuse
