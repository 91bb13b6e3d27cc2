// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/perception.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/lane_description.hpp"
#include "pipeline/graph_estimator.hpp"
#include "pipeline/measurement_items.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

constexpr Duration kLongestHole = std::chrono::seconds(10);

/// Vehicles among the sets of one cycle, each counted once however many sets it is in.
std::uint32_t count_witnesses(const std::vector<FeatureSet>& sets) {
  std::set<std::int64_t> tracks;
  for (const FeatureSet& set : sets) {
    if (set.source != Source::objects) continue;
    for (const Feature& feature : set.features) tracks.insert(feature.track_id);
  }
  return static_cast<std::uint32_t>(tracks.size());
}

std::vector<std::unique_ptr<FeatureSource>> make_sources(const SourcesConfig& config) {
  std::vector<std::unique_ptr<FeatureSource>> sources;
  if (config.serial_camera.enabled)
    sources.push_back(std::make_unique<SerialCameraSource>(config.serial_camera));
  if (config.high_resolution_camera.enabled) {
    sources.push_back(std::make_unique<HighResolutionCameraSource>(config.high_resolution_camera));
  }
  if (config.ego_path.enabled) sources.push_back(std::make_unique<EgoPathSource>(config.ego_path));
  if (config.lane_segmentation.enabled) {
    sources.push_back(std::make_unique<LaneSegmentationSource>(config.lane_segmentation));
  }
  return sources;
}

std::unique_ptr<LaneEstimator> make_estimator(const PerceptionConfig& config) {
  if (config.estimator == EstimatorKind::road) return std::make_unique<RoadEstimator>(config.road);
  return std::make_unique<GraphEstimator>(config.fusion, config.lanes);
}

}  // namespace

MultiLanePerception::MultiLanePerception(const PerceptionConfig& config, Rig rig)
    : config_(config),
      rig_(std::move(rig)),
      period_(from_seconds(1 / config.cycle_hz)),
      stamp_memory_(from_seconds(config.reorder_window_s) + std::chrono::seconds(1)),
      dead_reckoning_(config.sources.odometry),
      images_(config.sources.images),
      sources_(make_sources(config.sources)),
      estimator_(make_estimator(config)) {
  if (!config.sources.objects.enabled) return;
  auto objects = std::make_unique<ObjectSource>(config.sources.objects);
  objects_ = objects.get();
  sources_.push_back(std::move(objects));
}

void MultiLanePerception::on_stage(LaneEstimator::StageListener listener) {
  stage_done_ = listener;
  estimator_->on_stage(std::move(listener));
}

void MultiLanePerception::add(Measurement measurement) {
  // Lanes are estimated without knowing where on Earth the car is: not even the cycles' clock may notice.
  if (std::holds_alternative<GnssInsFix>(measurement)) return;
  inputs_.dropped += cut_to_bounds(measurement, config_.max_objects, config_.fusion.max_features);
  if (implausible(measurement)) {
    inputs_.rejected += item_count(measurement);
    return;
  }
  if (clock_was_set_back(measurement)) {
    const InputAccounting inputs = inputs_;
    reset();
    inputs_ = inputs;
  }
  if (is_long_past(measurement) || seen_before(measurement)) {
    inputs_.dropped += item_count(measurement);
    return;
  }
  // The first cycle is on the first whole period after the first measurement: the same for a live stream and
  // its replay.
  if (!next_cycle_) next_cycle_ = last_cycle_until(stamp_of(measurement).received_at) + period_;
  pending_.push_back(std::move(measurement));
}

bool MultiLanePerception::seen_before(const Measurement& measurement) {
  const Stamp& stamp = stamp_of(measurement);
  std::set<Time>& seen = stamps_[{kind_of(measurement), stamp.sensor_id}];
  seen.erase(seen.begin(), seen.lower_bound(stamp.measured_at - stamp_memory_));
  return !seen.insert(stamp.measured_at).second;
}

Time MultiLanePerception::last_cycle_until(Time time) const {
  return Time{time.time_since_epoch() / period_ * period_};
}

bool MultiLanePerception::is_long_past(const Measurement& measurement) const {
  const Time received = stamp_of(measurement).received_at;
  return next_cycle_ && *next_cycle_ - received > period_ + from_seconds(config_.reorder_window_s);
}

/// Single messages from long ago are late. Where nothing else comes for a while, it is the clock.
bool MultiLanePerception::clock_was_set_back(const Measurement& measurement) {
  constexpr Duration kAWhile = std::chrono::milliseconds(200);
  const Time received = stamp_of(measurement).received_at;
  if (!is_long_past(measurement)) {
    long_past_since_.reset();
    return false;
  }
  if (!long_past_since_ || received < *long_past_since_) long_past_since_ = received;
  return received - *long_past_since_ > kAWhile;
}

const LaneEstimate* MultiLanePerception::advance(Time now) {
  // Strictly later: what arrives at the very moment of a cycle belongs to it.
  if (!next_cycle_ || now <= *next_cycle_) return nullptr;
  // A stamp far ahead, of a broken clock or behind a hole in the recording, is no reason to run every cycle
  // until then.
  if (now - *next_cycle_ > kLongestHole) next_cycle_ = last_cycle_until(now);
  const Time time = std::exchange(*next_cycle_, *next_cycle_ + period_);
  run_sources(time);
  if (std::exchange(restarts_, dead_reckoning_.restarts()) != restarts_) {
    estimator_->reset();
    availability_.reset();
  }
  stage_done_(Stage::sources);
  estimate_ = estimator_->process({time, dead_reckoning_.samples(), feature_sets_});
  describe_lanes(estimate_);
  availability_.update(estimate_);
  estimate_.inputs = std::exchange(inputs_, {});
  estimate_.witnesses = count_witnesses(feature_sets_);
  judge_sources(time, estimate_);
  judge_cameras(estimate_);
  judge_object_sensors(estimate_);
  return &estimate_;
}

void MultiLanePerception::run_sources(Time now) {
  feature_sets_.clear();
  images_.forget_views();
  std::stable_sort(pending_.begin(), pending_.end(), measured_before);
  for (const Measurement& measurement : pending_) {
    if (const auto* motion = std::get_if<VehicleMotion>(&measurement))
      inputs_ += dead_reckoning_.add(*motion);
  }
  SourceContext context{rig_, dead_reckoning_.samples(), lane_width_.width(now)};
  // Vehicles that radars have placed hide the road in images, too, unless an object list says better.
  ObjectList placed{{now - period_, now - period_, 0}, {}};
  std::copy_if(objects().begin(), objects().end(), std::back_inserter(placed.objects),
               [](const TrackedObject& object) { return object.seen_by_radar; });
  if (!placed.objects.empty()) images_.note(placed);
  for (const Measurement& measurement : pending_) take(measurement, context);
  pending_.clear();
  for (const auto& source : sources_) {
    const std::size_t first = feature_sets_.size();
    source->collect(now, context, feature_sets_);
    for (std::size_t i = first; i < feature_sets_.size(); ++i) {
      lane_width_.update(feature_sets_[i]);
      last_heard_[feature_sets_[i].source] = now;
    }
  }
}

void MultiLanePerception::take(const Measurement& measurement, const SourceContext& context) {
  if (std::holds_alternative<VehicleMotion>(measurement)) return;
  const Time newest = context.motion.empty() ? stamp_of(measurement).measured_at : context.motion.back().time;
  // What has waited here for its cycle is not late for that.
  const Time until = std::min(newest, stamp_of(measurement).received_at);
  if (until - stamp_of(measurement).measured_at > from_seconds(config_.reorder_window_s)) {
    inputs_.dropped += item_count(measurement);
    return;
  }
  if (const auto* objects = std::get_if<ObjectList>(&measurement)) images_.note(*objects);
  const auto* image = std::get_if<CameraImage>(&measurement);
  inputs_ += image ? take_image(*image, context) : hand_to_sources(measurement, context);
}

InputAccounting MultiLanePerception::hand_to_sources(const Measurement& measurement,
                                                     const SourceContext& context) {
  InputAccounting taken;
  for (const auto& source : sources_) taken += source->add(measurement, context);
  if (taken == InputAccounting{}) taken.dropped = item_count(measurement);
  return taken;
}

/// What an image shows counts beside the image itself. An own source that wants images gets them, too.
InputAccounting MultiLanePerception::take_image(const CameraImage& image, const SourceContext& context) {
  InputAccounting own;
  for (const auto& source : sources_) own += source->add(image, context);
  std::vector<Measurement> seen;
  InputAccounting taken = images_.take(image, context, seen);
  for (const Measurement& measurement : seen) taken += hand_to_sources(measurement, context);
  // Whoever used it: the image is one item.
  if (own.used > 0 && taken.dropped == 1 && seen.empty()) taken = {.used = 1};
  return taken;
}

/// Cameras that give images and cannot be believed are no silence: they are named.
void MultiLanePerception::judge_cameras(LaneEstimate& estimate) const {
  for (const CameraView& view : images_.views()) {
    const bool bumped = view.calibration == CalibrationStatus::bumped;
    if (view.fault == ImageFault::none && !bumped) continue;
    const SensorDescription* sensor = rig_.find(view.sensor_id);
    if (!sensor) continue;
    const Source source = sensor->kind == SensorKind::high_resolution_camera ? Source::high_resolution_camera
                                                                             : Source::serial_camera;
    estimate.sources[static_cast<std::size_t>(source)] = SourceStatus::degraded;
    if (estimate.status == EstimateStatus::invalid) continue;
    estimate.status = EstimateStatus::degraded;
    estimate.reason = bumped ? StatusReason::camera_bumped : StatusReason::image_fault;
  }
}

void MultiLanePerception::judge_object_sensors(LaneEstimate& estimate) const {
  if (!objects_ || objects_->distrusted().empty()) return;
  estimate.sources[static_cast<std::size_t>(Source::objects)] = SourceStatus::degraded;
  if (estimate.status != EstimateStatus::ok) return;
  estimate.status = EstimateStatus::degraded;
  estimate.reason = StatusReason::sensor_inconsistent;
}

std::span<const TrackedObject> MultiLanePerception::objects() const {
  return objects_ ? objects_->objects() : std::span<const TrackedObject>{};
}

std::span<const std::uint32_t> MultiLanePerception::distrusted_sensors() const {
  return objects_ ? objects_->distrusted() : std::span<const std::uint32_t>{};
}

void MultiLanePerception::judge_sources(Time now, LaneEstimate& estimate) const {
  for (int i = 0; i < kSourceCount; ++i) {
    const auto heard = last_heard_.find(static_cast<Source>(i));
    const bool speaks = heard != last_heard_.end() && now - heard->second <= from_seconds(config_.silence_s);
    estimate.sources[i] = speaks ? SourceStatus::ok : SourceStatus::unavailable;
    if (heard == last_heard_.end() || speaks || estimate.status != EstimateStatus::ok) continue;
    estimate.status = EstimateStatus::degraded;
    estimate.reason = StatusReason::source_silent;
  }
}

void MultiLanePerception::reset() {
  dead_reckoning_.reset();
  lane_width_.reset();
  images_.reset();
  for (const auto& source : sources_) source->reset();
  estimator_->reset();
  availability_.reset();
  pending_.clear();
  next_cycle_.reset();
  long_past_since_.reset();
  restarts_ = 0;
  inputs_ = {};
  stamps_.clear();
  last_heard_.clear();
}

}  // namespace lanefuse
