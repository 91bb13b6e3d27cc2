// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/label_benchmark_command.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/progress.hpp"
#include "core/error.hpp"
#include "pipeline/perception.hpp"
#include "recording/drive_reader.hpp"

namespace lanefuse {
namespace {

/// Runs the drive and judges the cycles that took in a labelled image.
class LabelledDrive {
 public:
  LabelledDrive(const LabelBenchmarkOptions& options, const PerceptionConfig& config, const Rig& rig,
                const std::string& clip)
      : tolerance_(options.tolerance), list_(options.list), rig_(rig), perception_(config, rig) {
    for (ImageLabels& labels : load_image_labels(options.labels, clip)) {
      const std::int64_t frame = labels.frame;
      labels_.emplace(frame, std::move(labels));
    }
  }

  void add(const Measurement& measurement) {
    advance(stamp_of(measurement).received_at);
    if (std::holds_alternative<CameraImage>(measurement)) {
      frames_.emplace(stamp_of(measurement).measured_at, static_cast<std::int64_t>(frames_.size()));
    }
    perception_.add(measurement);
  }

  void advance(Time now) {
    while (const LaneEstimate* estimate = perception_.advance(now)) judge(*estimate);
  }

  [[nodiscard]] const LabelFigures& figures() const { return figures_; }
  /// [m] of the ego lane beside the car, in the median cycle.
  [[nodiscard]] double median_width() {
    if (widths_.empty()) return 0;
    const auto middle = widths_.begin() + static_cast<std::ptrdiff_t>(widths_.size() / 2);
    std::nth_element(widths_.begin(), middle, widths_.end());
    return *middle;
  }

 private:
  void judge(const LaneEstimate& estimate) {
    constexpr double kAhead = 5;  // [m] where the width is taken
    if (const Lane* lane = ego_lane(estimate)) {
      const Boundary* left = find_boundary(estimate, lane->left_boundary);
      const Boundary* right = find_boundary(estimate, lane->right_boundary);
      widths_.push_back(lateral_at(*left, kAhead) - lateral_at(*right, kAhead));
    }
    for (const CameraView& view : perception_.camera_views()) {
      const auto frame = frames_.find(view.measured_at);
      const SensorDescription* sensor = rig_.find(view.sensor_id);
      if (frame == frames_.end() || !sensor || !sensor->camera) continue;
      const auto labels = labels_.find(frame->second);
      if (labels == labels_.end()) continue;
      LabelFigures of_frame;
      judge_labels(labels->second, estimate, view, CameraModel(*sensor->camera), tolerance_, of_frame);
      if (list_) list(frame->second, of_frame);
      figures_ += of_frame;
    }
  }

  /// One labelled image, on a line of standard error.
  static void list(std::int64_t frame, const LabelFigures& figures) {
    fmt::print(stderr, "frame {:>4}:", frame);
    for (const ErrorFigure& error : figures.error_px) fmt::print(stderr, " {:+6.1f}", error.mean());
    fmt::print(stderr, " px; left {}, right {}, outer {}\n", figures.ego_left.count, figures.ego_right.count,
               figures.right_outer.count);
  }

  LabelTolerance tolerance_;
  bool list_;
  Rig rig_;
  MultiLanePerception perception_;
  std::map<std::int64_t, ImageLabels> labels_;
  std::map<Time, std::int64_t> frames_;
  LabelFigures figures_;
  std::vector<double> widths_;
};

nlohmann::ordered_json share_json(const Share& share) { return {{"found", share.count}, {"of", share.of}}; }

void print(const LabelFigures& figures, double width, bool json) {
  const std::pair<const char*, const Share*> shares[] = {
      {"ego_both", &figures.ego_both},    {"ego_left", &figures.ego_left},
      {"ego_right", &figures.ego_right},  {"right_outer", &figures.right_outer},
      {"dummy", &figures.dummy},          {"vehicles_found", &figures.vehicles_found},
      {"boxes_true", &figures.boxes_true}};
  if (json) {
    nlohmann::ordered_json result;
    for (const auto& [name, share] : shares) result[name] = share_json(*share);
    for (std::size_t i = 0; i < figures.error_px.size(); ++i) {
      const ErrorFigure& error = figures.error_px[i];
      result["ego_px"].push_back({{"from_m", LabelFigures::kBinLength * static_cast<double>(i)},
                                  {"points", error.count},
                                  {"rmse", error.rmse()},
                                  {"bias", error.mean()}});
    }
    result["median_ego_width_m"] = width;
    fmt::print("{}\n", result.dump());
    return;
  }
  for (const auto& [name, share] : shares) fmt::print("{:<16}{:>4} of {}\n", name, share->count, share->of);
  for (std::size_t i = 0; i < figures.error_px.size(); ++i) {
    const ErrorFigure& error = figures.error_px[i];
    const double from = LabelFigures::kBinLength * static_cast<double>(i);
    fmt::print("ego lines, {:.0f}-{:.0f} m: {:.2f} px RMSE, {:+.2f} px bias in {} points\n", from,
               from + LabelFigures::kBinLength, error.rmse(), error.mean(), error.count);
  }
  fmt::print("median width of the ego lane {:.2f} m\n", width);
}

}  // namespace

int benchmark_labels(const LabelBenchmarkOptions& options) {
  DriveReader reader(options.drive);
  PerceptionConfig config = default_config(reader.info().witness);
  if (options.config) config = load_config(*options.config, config);
  for (const std::string& assignment : options.assignments) set_key(config, assignment);
  const std::string clip = options.clip.empty() ? reader.info().name : options.clip;
  LabelledDrive drive(options, config, reader.rig(), clip);
  Progress progress("fusing");
  Measurement measurement;
  Time end{};
  while (reader.next(measurement)) {
    end = std::max(end, stamp_of(measurement).received_at);
    drive.add(measurement);
  }
  drive.advance(end + from_seconds(1));
  if (drive.figures().ego_both.of == 0) {
    throw input_error(options.drive.string(), fmt::format("shows none of the labelled images of '{}'", clip));
  }
  print(drive.figures(), drive.median_width(), options.json);
  return 0;
}

}  // namespace lanefuse
