// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/camera_report.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kToDegrees = 180 / std::numbers::pi;

/// A number with as many digits as it is worth; null where nothing was counted.
Json figure(double value, bool exists) { return exists ? Json(std::round(value * 1e5) / 1e5) : Json(); }
Json share(const Share& s) { return figure(s.value(), s.of > 0); }

Json angle_json(const ErrorFigure& error) {
  return {{"rmse_deg", figure(error.rmse() * kToDegrees, error.count > 0)},
          {"bias_deg", figure(error.mean() * kToDegrees, error.count > 0)},
          {"coverage_95", figure(error.coverage(), error.count > 0)},
          {"consistency", figure(error.consistency(), error.count > 0)}};
}

Json markings_json(const MarkingFigures& markings) {
  Json bins = Json::array();
  for (std::size_t i = 0; i < markings.bins.size(); ++i) {
    const MarkingFigures::Bin& bin = markings.bins[i];
    bins.push_back({{"from_m", MarkingFigures::kBinLength * static_cast<double>(i)},
                    {"bars", bin.believed_falsely.of},
                    {"lateral_rmse_px", figure(bin.lateral_px.rmse(), bin.lateral_px.count > 0)},
                    {"lateral_bias_px", figure(bin.lateral_px.mean(), bin.lateral_px.count > 0)},
                    {"lateral_rmse_m", figure(bin.lateral.rmse(), bin.lateral.count > 0)},
                    {"coverage_95", figure(bin.lateral.coverage(), bin.lateral.count > 0)},
                    {"consistency", figure(bin.lateral.consistency(), bin.lateral.count > 0)},
                    {"heading_rmse_deg", figure(bin.heading.rmse() * kToDegrees, bin.heading.count > 0)},
                    {"heading_coverage_95", figure(bin.heading.coverage(), bin.heading.count > 0)},
                    {"found", share(bin.found)},
                    {"false", share(bin.believed_falsely)}});
  }
  return bins;
}

Json camera_json(const LaneTrackFigures& figures) {
  return {{"pitch", angle_json(figures.pitch)},
          {"yaw", angle_json(figures.yaw)},
          {"roll", angle_json(figures.roll)},
          {"vehicles_found", share(figures.vehicles_found)},
          {"vehicle_boxes_true", share(figures.boxes_true)}};
}

Json serial_json(const LaneTrackFigures& figures) {
  Json json{{"tracked", share(figures.tracked)},
            {"mean_range_m", figure(figures.mean_range(), figures.tracked.count > 0)}};
  for (std::size_t i = 0; i < figures.lateral.size(); ++i) {
    const ErrorFigure& error = figures.lateral[i];
    json["lateral"].push_back({{"at_m", 10 * i},
                               {"count", error.count},
                               {"rmse_m", figure(error.rmse(), error.count > 0)},
                               {"bias_m", figure(error.mean(), error.count > 0)},
                               {"coverage_95", figure(error.coverage(), error.count > 0)},
                               {"consistency", figure(error.consistency(), error.count > 0)}});
  }
  json.update(camera_json(figures));
  return json;
}

std::string markings_text(const MarkingFigures& markings) {
  std::string text =
      "| distance [m] | bars | lateral RMSE [px] | [m] | 95 % holds | heading RMSE [deg] | found [%] | false "
      "[%] |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < markings.bins.size(); ++i) {
    const MarkingFigures::Bin& bin = markings.bins[i];
    if (bin.found.of == 0 && bin.believed_falsely.of == 0) continue;
    text += fmt::format("| {:.0f}-{:.0f} | {} | {:.2f} | {:.3f} | {:.1f} | {:.2f} | {:.1f} | {:.1f} |\n",
                        MarkingFigures::kBinLength * static_cast<double>(i),
                        MarkingFigures::kBinLength * static_cast<double>(i + 1), bin.believed_falsely.of,
                        bin.lateral_px.rmse(), bin.lateral.rmse(), 100 * bin.lateral.coverage(),
                        bin.heading.rmse() * kToDegrees, 100 * bin.found.value(),
                        100 * bin.believed_falsely.value());
  }
  return text;
}

std::string serial_text(const LaneTrackFigures& figures) {
  std::string text =
      fmt::format("serial camera: both markings in {:.1f} % of the images, mean range {:.1f} m\n\n",
                  100 * figures.tracked.value(), figures.mean_range());
  text += "| at [m] | images | RMSE [m] | bias [m] | 95 % holds |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < figures.lateral.size(); ++i) {
    const ErrorFigure& error = figures.lateral[i];
    if (error.count == 0) continue;
    text += fmt::format("| {} | {} | {:.3f} | {:+.3f} | {:.1f} |\n", 10 * i, error.count / 2, error.rmse(),
                        error.mean(), 100 * error.coverage());
  }
  return text;
}

std::string pose_text(const char* camera, const LaneTrackFigures& figures) {
  std::string text = fmt::format(
      "{}: pitch {:.3f} deg RMSE (95 % holds in {:.1f} %), yaw {:.3f} ({:.1f} %), roll {:.3f} ({:.1f} %)\n",
      camera, figures.pitch.rmse() * kToDegrees, 100 * figures.pitch.coverage(),
      figures.yaw.rmse() * kToDegrees, 100 * figures.yaw.coverage(), figures.roll.rmse() * kToDegrees,
      100 * figures.roll.coverage());
  if (figures.vehicles_found.of > 0) {
    text += fmt::format("vehicles nearer than 50 m: {:.1f} % found, {:.1f} % of the boxes true\n",
                        100 * figures.vehicles_found.value(), 100 * figures.boxes_true.value());
  }
  return text;
}

}  // namespace

Json to_json(const CameraTrialFigures& figures) {
  return {{"images", figures.images},
          {"refused", figures.refused},
          {"markings", markings_json(figures.markings)},
          {"serial_camera", serial_json(figures.serial)},
          {"high_resolution_camera", camera_json(figures.high)}};
}

std::string to_text(const CameraTrialFigures& figures) {
  return fmt::format("{} images, {} refused\n\n{}\n{}\n{}{}", figures.images, figures.refused,
                     markings_text(figures.markings), serial_text(figures.serial),
                     pose_text("serial camera", figures.serial),
                     pose_text("high-resolution camera", figures.high));
}

}  // namespace lanefuse
