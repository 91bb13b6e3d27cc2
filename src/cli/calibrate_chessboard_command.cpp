// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/calibrate_chessboard_command.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "camera/camera_file.hpp"
#include "camera/chessboard_calibration.hpp"
#include "cli/calibration_images.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kUsualHeight = 1.3;  ///< [m] of a camera behind a car's windscreen

ChessboardConfig chessboard_of(const CalibrateChessboardOptions& options) {
  ChessboardConfig config;
  int end = 0;
  const int read = std::sscanf(options.pattern.c_str(), "%3dx%3d%n", &config.columns, &config.rows, &end);
  if (read != 2 || static_cast<std::size_t>(end) != options.pattern.size() || config.columns < 3 ||
      config.rows < 3) {
    throw configuration_error("--pattern", fmt::format("'{}' is no number of inner corners", options.pattern),
                              "write 9x6 for ten by seven squares");
  }
  config.square = options.square.value_or(1);
  return config;
}

Json to_json(const ChessboardCalibration& result, const Findings<ChessboardView>& seen, bool has_square) {
  const CameraIntrinsics& c = result.camera;
  const auto& s = result.sigma;
  Json json{
      {"rms_px", result.rms_px},
      {"width", c.width},
      {"height", c.height},
      {"fx", c.fx},
      {"fy", c.fy},
      {"cx", c.cx},
      {"cy", c.cy},
      {"distortion", c.distortion},
      {"sigma",
       {{"fx", s[0]}, {"fy", s[1]}, {"cx", s[2]}, {"cy", s[3]}, {"distortion", {s[4], s[5], s[6], s[7]}}}},
      {"images_used", result.views_used},
      {"images_refused", to_json(seen.refused)}};
  Json images = Json::array();
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    const ChessboardView& view = seen.views[i];
    if (!result.views[i].used) continue;
    Json image{{"image", seen.names[i]},
               {"pattern", fmt::format("{}x{}", view.columns, view.rows)},
               {"size", {view.width, view.height}},
               {"rms_px", result.views[i].rms_px}};
    if (has_square) image["distance_m"] = result.views[i].distance;
    images.push_back(image);
  }
  json["images"] = images;
  return json;
}

/// Images of another size: refused, or used though they differ by a pixel.
void judge_sizes(const ChessboardCalibration& result, Findings<ChessboardView>& seen) {
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    const ChessboardView& view = seen.views[i];
    const std::string size = fmt::format("{} x {}", view.width, view.height);
    if (!result.views[i].used) {
      seen.refused.push_back({seen.names[i], fmt::format("is {}, not the size of most images", size)});
    } else if (view.width != result.camera.width || view.height != result.camera.height) {
      fmt::print(stderr, "note: {} is {}, used as if it were {} x {}\n", seen.names[i], size,
                 result.camera.width, result.camera.height);
    }
  }
}

std::string to_text(const ChessboardCalibration& result) {
  const CameraIntrinsics& c = result.camera;
  const auto& s = result.sigma;
  const auto& k = c.distortion;
  std::string text =
      fmt::format("{} x {} px, reprojection RMS {:.3f} px\n", c.width, c.height, result.rms_px);
  text += fmt::format("fx {:8.2f} +- {:.2f} px    cx {:8.2f} +- {:.2f} px\n", c.fx, s[0], c.cx, s[2]);
  text += fmt::format("fy {:8.2f} +- {:.2f} px    cy {:8.2f} +- {:.2f} px\n", c.fy, s[1], c.cy, s[3]);
  text += fmt::format("k1 {:.4f} +- {:.4f}  k2 {:.4f} +- {:.4f}  ", k[0], s[4], k[1], s[5]);
  return text + fmt::format("p1 {:.5f} +- {:.5f}  p2 {:.5f} +- {:.5f}\n", k[2], s[6], k[3], s[7]);
}

}  // namespace

int calibrate_chessboard(const CalibrateChessboardOptions& options) {
  if (options.output) check_output(*options.output, options.force);
  const ChessboardConfig config = chessboard_of(options);
  auto seen = look_at<ChessboardView>(options.images, [&](const Image& image, std::string& why) {
    why = "shows no chessboard of that pattern";
    return find_chessboard(image.view(), config);
  });
  const ChessboardCalibration result = calibrate_with_chessboards(seen.views, config);
  judge_sizes(result, seen);
  SensorDescription camera{0, options.kind, options.name, {}, result.camera};
  camera.mounting.z = kUsualHeight;
  if (options.output) {
    write_text(*options.output,
               "# The mounting is a guess: find it with 'lanefuse calibrate mounting'.\n" + to_yaml(camera));
  }
  if (options.json) {
    fmt::print("{}\n", to_json(result, seen, options.square.has_value()).dump());
    return 0;
  }
  fmt::print("{} of {} images, {}{}", result.views_used, options.images.size(), to_text(result),
             to_text(seen.refused));
  return 0;
}

}  // namespace lanefuse
