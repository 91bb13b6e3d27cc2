// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/marking_judge.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lanefuse {
namespace {

constexpr double kFarthest = 130;    ///< [m] up to which features are promised
constexpr double kNearest = 8;       ///< [m]
constexpr double kAside = 12;        ///< [m] to either side up to which lines are asked for
constexpr double kStep = 2;          ///< [m] between the pieces of paint that are to be found
constexpr double kSamePaint = 6;     ///< a bar's centre further off is none of this line
constexpr double kSameLine = 1;      ///< [m] the same for a feature
constexpr double kPartOfDash = 0.3;  ///< [m] of paint that make a bar true

MarkingFigures::Bin* bin_at(MarkingFigures& figures, double distance) {
  const int bin = static_cast<int>(distance / MarkingFigures::kBinLength);
  if (!(distance >= 0) || bin >= MarkingFigures::kBins) return nullptr;
  return &figures.bins[static_cast<std::size_t>(bin)];
}

/// A believed bar and the line that it lies on, if it lies on one.
struct JudgedBar {
  double row = 0;
  int line = -1;
  double station = 0;
  double error_px = 0;
  double distance = 0;
  bool painted = false;
};

/// The length of road [m] that one row shows at the place.
double row_footprint(const ImageTruth& truth, const TrueMarking& place) {
  const auto next = truth.marking(place.line, place.row + 1);
  return next ? std::abs(place.station - next->station) : 0;
}

bool painted_near(const Road& road, const TrueMarking& place, double reach) {
  for (double along = -reach; along <= reach; along += kPartOfDash) {
    if (road.painted(place.line, place.station + along)) return true;
  }
  return road.painted(place.line, place.station);
}

JudgedBar judged(const Scene& scene, const ImageTruth& truth, const std::vector<int>& lines,
                 const ImageBar& bar) {
  JudgedBar result{.row = bar.row, .error_px = 1e9};
  const double centre = (bar.left + bar.right) / 2;
  for (const int line : lines) {
    const auto place = truth.marking(line, bar.row);
    if (!place) continue;
    const double error = centre - place->column;
    result.distance = std::max(result.distance, place->ground.x());
    if (std::abs(error) >= std::abs(result.error_px)) continue;
    const bool near = std::abs(error) <= std::max(kSamePaint, (place->right - place->left) / 2);
    const bool paint = near && painted_near(*scene.road, *place, row_footprint(truth, *place));
    result = {bar.row, near ? line : -1, place->station, error, place->ground.x(), paint};
  }
  return result;
}

void judge_found(const Scene& scene, const ImageTruth& truth, const CameraIntrinsics& camera, int line,
                 const std::vector<JudgedBar>& bars, MarkingFigures& figures) {
  for (double ahead = kNearest; ahead <= kFarthest; ahead += kStep) {
    const auto place = truth.marking_at(line, scene.ego.station + ahead);
    if (!place || !place->visible() || std::abs(place->ground.y()) > kAside) continue;
    if (place->left < 2 || place->right > camera.width - 3 || place->row > camera.height - 2) continue;
    MarkingFigures::Bin* bin = bin_at(figures, place->ground.x());
    if (!bin) continue;
    const double reach = kStep / 2 + row_footprint(truth, *place);
    bin->found.add(std::any_of(bars.begin(), bars.end(), [&](const JudgedBar& bar) {
      return bar.line == line && std::abs(bar.station - place->station) <= reach;
    }));
  }
}

void judge_feature(const std::vector<TrueLine>& lines, const Feature& feature, MarkingFigures& figures) {
  std::optional<TrueLine::Place> nearest;
  for (const TrueLine& line : lines) {
    const auto place = line.at(feature.x);
    if (place && (!nearest || std::abs(place->y - feature.y) < std::abs(nearest->y - feature.y)))
      nearest = place;
  }
  MarkingFigures::Bin* bin = bin_at(figures, feature.x);
  if (!bin || !nearest || std::abs(nearest->y - feature.y) > kSameLine) return;
  const double heading = std::atan(nearest->slope);
  const Eigen::Vector2d across(-std::sin(heading), std::cos(heading));
  const double variance = across.dot(feature.covariance.topLeftCorner<2, 2>() * across);
  bin->lateral.add((feature.y - nearest->y) * across.y(), std::sqrt(variance));
  bin->heading.add(feature.heading - heading, std::sqrt(feature.covariance(2, 2)));
}

}  // namespace

MarkingFigures& MarkingFigures::operator+=(const MarkingFigures& other) {
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i].lateral_px += other.bins[i].lateral_px;
    bins[i].lateral += other.bins[i].lateral;
    bins[i].heading += other.bins[i].heading;
    bins[i].found += other.bins[i].found;
    bins[i].believed_falsely += other.bins[i].believed_falsely;
  }
  return *this;
}

void judge_markings(const Scene& scene, const ImageTruth& truth, const CameraIntrinsics& camera,
                    const CameraView& view, std::span<const Feature> features, MarkingFigures& figures) {
  const std::vector<int> lines = truth.lines();
  std::vector<JudgedBar> bars;
  for (const ImageBar& bar : view.bars) {
    if (!bar.believed) continue;
    const JudgedBar result = judged(scene, truth, lines, bar);
    MarkingFigures::Bin* bin = bin_at(figures, result.distance);
    if (!bin) continue;
    bin->believed_falsely.add(!result.painted);
    if (result.painted) {
      bin->lateral_px.add(result.error_px);
      bars.push_back(result);
    }
  }
  for (const int line : lines) judge_found(scene, truth, camera, line, bars, figures);
  const std::vector<TrueLine> true_places = true_lines(scene, truth, [](int, double) { return 0.0; });
  for (const Feature& feature : features) judge_feature(true_places, feature, figures);
}

}  // namespace lanefuse
