// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluate_judging.hpp"

#include <algorithm>
#include <memory>

#include "cli/progress.hpp"
#include "core/error.hpp"
#include "evaluation/ego_path.hpp"
#include "evaluation/exact_truth.hpp"
#include "evaluation/serial_camera_baseline.hpp"
#include "evaluation/tracking_judge.hpp"
#include "evaluation/true_frames.hpp"
#include "recording/drive_reader.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {
namespace {

template <typename Judge>
std::vector<Highlight> judge_all(const EvaluateOptions& options, const std::vector<TrueFrame>& frames,
                                 Judge&& judge) {
  Highlights highlights(frames.front().time, frames.back().time);
  Progress progress("evaluating");
  LanesReader reader(options.lanes);
  LaneRecord record;
  while (reader.next_without_features(record)) {
    highlights.add(record, [&reader](LaneRecord& kept) { reader.complete(kept); });
    judge(record);
    progress.show_seconds(to_seconds(record.estimate.time - *highlights.first()));
  }
  refuse_damage(options.lanes, reader.report());
  if (!highlights.first()) throw input_error(options.lanes.string(), "holds no cycle");
  return highlights.chosen();
}

/// Plays a drive's serial camera beside the estimates.
class SerialCameraReplay {
 public:
  explicit SerialCameraReplay(const std::filesystem::path& drive) : file_(drive), reader_(drive) {
    if (std::none_of(reader_.rig().sensors.begin(), reader_.rig().sensors.end(),
                     [](const auto& sensor) { return sensor.kind == SensorKind::serial_camera; })) {
      throw input_error(drive.string(), "has no serial camera", "leave out --baseline");
    }
    more_ = reader_.next(next_);
  }

  LaneEstimate at(Time time) {
    for (; more_ && stamp_of(next_).received_at <= time; more_ = reader_.next(next_)) camera_.add(next_);
    return camera_.at(time);
  }

  void finish() const { refuse_damage(file_, reader_.report()); }

 private:
  std::filesystem::path file_;
  DriveReader reader_;
  SerialCameraBaseline camera_;
  Measurement next_;
  bool more_ = false;
};

std::optional<SurveyedTruthConfig> survey_of(const EvaluateOptions& options) {
  if (options.truth != "surveyed") return std::nullopt;
  const SurveyedTruthPreset preset = nominal_preset().surveyed_truth;
  return SurveyedTruthConfig{preset.ego, preset.adjacent, preset.heading, options.truth_seed};
}

Judged judge_by_road(const EvaluateOptions& options, const LanesAndTruth& context, const TrueRoad& road) {
  ExactTruthEvaluation evaluation(road, survey_of(options));
  TrackingJudge tracking{TrackingJudgeConfig{}};
  std::unique_ptr<SerialCameraReplay> camera;
  if (options.serial_camera) camera = std::make_unique<SerialCameraReplay>(context.drive);
  Judged judged;
  judged.highlights = judge_all(options, context.truth->frames, [&](const LaneRecord& record) {
    const LaneEstimate& estimate = record.estimate;
    const auto frame = frame_at(context.truth->frames, estimate.time);
    if (!frame) return evaluation.add_without_truth(estimate);
    tracking.add(*frame, record.objects);
    if (!camera) return evaluation.add(estimate, *frame);
    const LaneEstimate alone = camera->at(estimate.time);
    evaluation.add(estimate, *frame, &alone);
  });
  if (camera) camera->finish();
  judged.result = evaluation.result();
  judged.trace = evaluation.trace();
  if (const TrackingFigures figures = tracking.figures(); figures.judged()) judged.result.tracking = figures;
  return judged;
}

Judged judge_by_drive(const EvaluateOptions& options, const LanesAndTruth& context) {
  if (!context.truth->road) {
    throw input_error(options.lanes.string(), "its drive has no exact truth (/truth/road)",
                      "try --truth ego-path");
  }
  return judge_by_road(options, context, *context.truth->road);
}

Judged judge_by_map(const EvaluateOptions& options, const LanesAndTruth& context) {
  Judged judged = judge_by_road(options, context, *context.truth->road);
  judged.result.truth = "map";
  judged.result.map = options.map->filename().string();
  if (judged.result.cycles_with_truth == 0) {
    throw input_error(
        options.map->string(), "the car is in none of its lanes at any time",
        "a map must be in the frame of the drive's true poses, and its lanes in the direction of "
        "driving");
  }
  return judged;
}

Judged judge_by_path(const EvaluateOptions& options, const LanesAndTruth& context) {
  EgoPathEvaluation evaluation(context.truth->frames);
  Judged judged;
  judged.highlights = judge_all(options, context.truth->frames, [&](const LaneRecord& record) {
    evaluation.add(record.estimate, record.estimate.witnesses > 0);
  });
  judged.result = evaluation.result();
  return judged;
}

}  // namespace

void refuse_damage(const std::filesystem::path& file, const ReadReport& report) {
  if (!report.complete()) throw input_error(file.string(), "damaged: " + report.first_problem);
}

Judged judge_lanes(const EvaluateOptions& options, const LanesAndTruth& context) {
  if (options.map) return judge_by_map(options, context);
  return options.truth == "ego-path" ? judge_by_path(options, context) : judge_by_drive(options, context);
}

}  // namespace lanefuse
