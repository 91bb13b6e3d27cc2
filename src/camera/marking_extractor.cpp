// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/marking_extractor.hpp"

#include <algorithm>
#include <cmath>

#include "camera/marking_covariance.hpp"
#include "camera/paint_ends.hpp"
#include "camera/paint_judge.hpp"
#include "camera/row_plan.hpp"
#include "camera/still_mask.hpp"

namespace lanefuse {
namespace {

constexpr double kSlantLateral = 8;          ///< [m] to the side up to which slanted paint is not too wide
constexpr double kBoxMargin = 0.06;          ///< of a vehicle's width, beside it
constexpr double kSideMargin = 0.2;          ///< [m] beside a vehicle's flank
constexpr double kSideMarginGrowth = 0.005;  ///< [m] of that for each metre of distance
constexpr double kShadowMargin = 0.12;       ///< of its height, below it
constexpr double kPitchSigmaLeast = 0.002;   ///< [rad] no pose knows the pitch of one image better
constexpr double kRowShare = 0.29;           ///< of a row: sigma of where paint that ends within it lies
constexpr double kFar = 1e9;                 ///< [m]
constexpr double kYellow = 0.35;             ///< of the contrast: blue that is missing in yellow paint

/// Whether a place of the road lies beside a vehicle, on the car's side of it: a box around a vehicle that is
/// not straight ahead holds a corner of free road.
bool lies_beside(const Eigen::Vector2d& ground, const VehicleBox& box) {
  if (!(box.width > 0) || !(box.distance > 0)) return false;
  const double margin = kSideMargin + kSideMarginGrowth * ground.x();
  const double side = std::abs(box.lateral) - box.width / 2 - margin;
  const double place = box.lateral > 0 ? ground.y() : -ground.y();
  return side > 0 && place < side;
}

bool is_hidden(const RowBar& bar, int row, const Eigen::Vector2d& ground,
               std::span<const VehicleBox> vehicles) {
  return std::any_of(vehicles.begin(), vehicles.end(), [&](const VehicleBox& box) {
    const double aside = kBoxMargin * (box.right - box.left);
    const double below = kShadowMargin * (box.bottom - box.top);
    const bool inside = bar.right > box.left - aside && bar.left < box.right + aside && row > box.top &&
                        row < box.bottom + below;
    return inside && !lies_beside(ground, box);
  });
}

/// How much more blue is missing in a column than would be missing in grey.
double blue_missing(const ImageView& image, int row, double column) {
  const int u = std::clamp(static_cast<int>(std::lround(column)), 1, image.width - 2);
  const std::uint8_t* pixel = image.row(row) + static_cast<std::ptrdiff_t>(u - 1) * 3;
  double missing = 0;
  for (int i = 0; i < 3; ++i, pixel += 3) missing += std::min(pixel[1], pixel[2]) - pixel[0];
  return missing / 3;
}

MarkingColour colour_of(const ImageView& image, int row, const RowBar& bar) {
  if (image.channels != 3) return MarkingColour::unknown;
  const double width = bar.right - bar.left;
  const double beside = (blue_missing(image, row, bar.left - 0.7 * width - 2) +
                         blue_missing(image, row, bar.right + 0.7 * width + 2)) /
                        2;
  const double missing = blue_missing(image, row, bar.centre) - beside;
  return missing > kYellow * bar.contrast ? MarkingColour::yellow : MarkingColour::white;
}

BarFinderConfig finder_config(const MarkingExtractorConfig& config) {
  BarFinderConfig finder;
  finder.width_min = config.width_min;
  finder.width_max = config.width_max;
  finder.width_tolerance = config.width_tolerance;
  finder.contrast_min = config.contrast_min;
  finder.contrast_to_noise = config.contrast_to_noise;
  return finder;
}

BarChainsConfig chains_config(const MarkingExtractorConfig& config) {
  BarChainsConfig chains;
  chains.radius_min = config.radius_min;
  return chains;
}

}  // namespace

class MarkingExtractor::Stages {
 public:
  Stages(const CameraIntrinsics& intrinsics, const MarkingExtractorConfig& config)
      : config_(config),
        camera_(intrinsics),
        signal_(intrinsics.width),
        finder_(intrinsics.width, finder_config(config)),
        chains_(chains_config(config)),
        ends_(config.blur_px),
        judge_({}),
        still_(intrinsics.width, intrinsics.height) {
    rows_.reserve(static_cast<std::size_t>(intrinsics.height));
  }

  void extract(const Input& input);
  void reset() { still_.reset(); }

  std::vector<Feature> features;
  std::vector<ImageBar> image_bars;
  double pitch_sigma = 0;

 private:
  MarkingExtractorConfig config_;
  CameraModel camera_;
  RowSignal signal_;
  BarFinder finder_;
  BarChains chains_;
  PaintEnds ends_;
  PaintJudge judge_;
  StillMask still_;
  std::vector<PlannedRow> rows_;
  std::vector<RoadBar> bars_;
  std::vector<double> published_to_;  ///< [m] by chain

  void plan(const CameraPose& pose);
  void look_at(const Input& input, const RoadRays& rays, int plan);
  void add_bar(const Input& input, const RoadRays& rays, int plan, const RowBar& found);
  void publish(const RoadRays& rays);
  [[nodiscard]] Feature feature_of(const RoadRays& rays, const RoadBar& bar) const;
  [[nodiscard]] double sigma_px(const RoadBar& bar) const;
};

void MarkingExtractor::Stages::plan(const CameraPose& pose) {
  RowPlanConfig plan;
  plan.range_min = config_.range_min;
  plan.range_max = config_.range_max;
  plan.lateral_max = config_.lateral_max;
  plan.radius_min = config_.radius_min;
  plan.row_spacing = config_.row_spacing;
  plan_rows(GroundProjection(camera_, pose), camera_.intrinsics(), plan, rows_);
}

void MarkingExtractor::Stages::add_bar(const Input& input, const RoadRays& rays, int plan,
                                       const RowBar& found) {
  const PlannedRow& row = rows_[static_cast<std::size_t>(plan)];
  const auto hit = rays.hit({found.centre, static_cast<double>(row.row)});
  if (!hit || is_hidden(found, row.row, hit->ground, input.vehicles)) return;
  if (config_.learn_still && still_.is_still(row.row, found.left, found.right)) return;
  RoadBar bar;
  bar.bar = found;
  bar.plan = plan;
  bar.row = row.row;
  bar.row_height = row.height();
  bar.row_sigma = kRowShare * row.height();
  bar.x = hit->ground.x();
  bar.y = hit->ground.y();
  bar.per_pixel = hit->per_pixel;
  const double pixel = std::abs(hit->per_pixel(1, 0));
  bar.width = (found.right - found.left) * pixel;
  const double slanted = std::abs(hit->per_pixel(1, 1)) * row.height();
  if (bar.width > config_.width_max * (1 + config_.width_tolerance) + 0.8 * slanted + pixel) return;
  if (bar.width < config_.width_min * (1 - config_.width_tolerance) - pixel) return;
  bar.y_sigma = std::hypot(found.sigma * pixel, config_.noise_floor_px * pixel, config_.ragged_paint);
  bar.colour = colour_of(input.image, row.row, found);
  bars_.push_back(bar);
}

void MarkingExtractor::Stages::look_at(const Input& input, const RoadRays& rays, int plan) {
  const PlannedRow& row = rows_[static_cast<std::size_t>(plan)];
  signal_.read(input.image, row);
  const double slant = kSlantLateral / rays.pose().mounting.z * row.height();
  for (const RowBar& found : finder_.find(signal_, row, slant)) add_bar(input, rays, plan, found);
}

double MarkingExtractor::Stages::sigma_px(const RoadBar& bar) const {
  return bar.y_sigma / std::abs(bar.per_pixel(1, 0));
}

Feature MarkingExtractor::Stages::feature_of(const RoadRays& rays, const RoadBar& bar) const {
  Feature feature;
  feature.source = Source::high_resolution_camera;
  feature.x = bar.x;
  feature.y = bar.y;
  feature.heading = bar.heading;
  const PixelSigma noise{sigma_px(bar), bar.row_sigma};
  feature.covariance = marking_covariance(rays, bar, noise, bar.heading_sigma);
  feature.confidence = std::clamp(0.95 - 0.6 * bar.x / 130, 0.1, 0.95);
  feature.marking = {judge_.type_of(bar), bar.colour};
  return feature;
}

void MarkingExtractor::Stages::publish(const RoadRays& rays) {
  features.clear();
  image_bars.clear();
  published_to_.assign(bars_.size(), -kFar);
  for (const RoadBar& bar : bars_) {
    image_bars.push_back({static_cast<double>(rows_[static_cast<std::size_t>(bar.plan)].row), bar.bar.left,
                          bar.bar.right, bar.believed});
    double& published_to = published_to_[static_cast<std::size_t>(bar.chain)];
    if (!bar.believed || bar.x < published_to + config_.feature_spacing) continue;
    published_to = bar.x;
    features.push_back(feature_of(rays, bar));
  }
}

void MarkingExtractor::Stages::extract(const Input& input) {
  assert(input.image.width == camera_.intrinsics().width &&
         input.image.height == camera_.intrinsics().height);
  plan(input.pose);
  const RoadRays rays(camera_, input.pose);
  bars_.clear();
  const int plans = static_cast<int>(rows_.size());
  for (int i = 0; i < plans; ++i) look_at(input, rays, i);
  const std::vector<BarChain>& chains = chains_.link(bars_, plans);
  chains_.measure_headings(bars_);
  pitch_sigma = std::sqrt(input.pose.covariance(2, 2));
  judge_.find_lines(bars_, chains, std::max(pitch_sigma, kPitchSigmaLeast) / input.pose.mounting.z);
  ends_.settle(bars_, chains, judge_.lines());
  chains_.measure_headings(bars_);
  judge_.judge(bars_, chains);
  publish(rays);
  if (config_.learn_still) still_.learn(input.image, input.distance_moved);
}

MarkingExtractor::MarkingExtractor(const CameraIntrinsics& intrinsics, const MarkingExtractorConfig& config)
    : stages_(std::make_unique<Stages>(intrinsics, config)) {}
MarkingExtractor::~MarkingExtractor() = default;
MarkingExtractor::MarkingExtractor(MarkingExtractor&&) noexcept = default;
MarkingExtractor& MarkingExtractor::operator=(MarkingExtractor&&) noexcept = default;

const std::vector<Feature>& MarkingExtractor::extract(const Input& input) {
  stages_->extract(input);
  return stages_->features;
}

const std::vector<ImageBar>& MarkingExtractor::bars() const { return stages_->image_bars; }

SharedError MarkingExtractor::shared_error() const {
  return {SharedError::Kind::pitch, stages_->pitch_sigma};
}

void MarkingExtractor::reset() { stages_->reset(); }

}  // namespace lanefuse
