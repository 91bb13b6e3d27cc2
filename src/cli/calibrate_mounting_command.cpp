// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/calibrate_mounting_command.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "camera/camera_file.hpp"
#include "camera/mounting_calibration.hpp"
#include "camera/straight_road.hpp"
#include "cli/calibration_images.hpp"
#include "cli/output_file.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;
using Found = Findings<StraightRoadView>;

constexpr double kDegree = std::numbers::pi / 180;

Found find_roads(const std::vector<std::filesystem::path>& images, const CameraModel& camera) {
  const CameraIntrinsics& c = camera.intrinsics();
  const auto find = [&](const Image& image, std::string& why) -> std::optional<StraightRoadView> {
    if (image.width() == c.width && image.height() == c.height) {
      why = "shows no two markings of a straight lane";
      return find_straight_road(image.view(), camera);
    }
    why =
        fmt::format("is {} x {}, not the camera's {} x {}", image.width(), image.height(), c.width, c.height);
    return {};
  };
  return look_at<StraightRoadView>(images, find);
}

Json to_json(const MountingCalibration& result, const Found& found, double lane_width) {
  const Mounting& m = result.mounting;
  const Eigen::Vector4d sigma = result.covariance.diagonal().cwiseSqrt();
  Json images = Json::array();
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    const MountingCalibration::ViewFit& view = result.views[i];
    if (view.used)
      images.push_back({{"image", found.names[i]}, {"rms_px", view.rms_px}, {"offset_m", view.offset}});
  }
  return {{"height_m", m.z},
          {"roll_deg", m.roll / kDegree},
          {"pitch_deg", m.pitch / kDegree},
          {"yaw_deg", m.yaw / kDegree},
          {"sigma",
           {{"height_m", sigma[0]},
            {"roll_deg", sigma[1] / kDegree},
            {"pitch_deg", sigma[2] / kDegree},
            {"yaw_deg", sigma[3] / kDegree}}},
          {"lane_width_m", lane_width},
          {"images_used", result.views_used},
          {"images_refused", to_json(found.refused)},
          {"images", images}};
}

std::string to_text(const MountingCalibration& result) {
  const Mounting& m = result.mounting;
  const Eigen::Vector4d sigma = result.covariance.diagonal().cwiseSqrt();
  return fmt::format(
      "height {:6.3f} +- {:.3f} m\n"
      "pitch  {:6.2f} +- {:.2f} deg (positive: nose down)\n"
      "yaw    {:6.2f} +- {:.2f} deg (positive: to the left)\n"
      "roll   {:6.2f} +- {:.2f} deg (hardly more than was assumed)\n",
      m.z, sigma[0], m.pitch / kDegree, sigma[2] / kDegree, m.yaw / kDegree, sigma[3] / kDegree,
      m.roll / kDegree, sigma[1] / kDegree);
}

}  // namespace

int calibrate_mounting(const CalibrateMountingOptions& options) {
  if (options.output) check_output(*options.output, options.force);
  SensorDescription camera = load_camera(options.camera);
  const CameraModel model(*camera.camera);
  Found found = find_roads(options.images, model);
  MountingCalibrationConfig config;
  config.lane_width = options.lane_width;
  const MountingCalibration result = calibrate_mounting(found.views, model, camera.mounting, config);
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    if (result.views[i].used) continue;
    found.refused.push_back(
        {found.names[i], "its road runs elsewhere, or its lane is wider or narrower than the others'"});
  }
  camera.mounting = result.mounting;
  if (options.output) write_text(*options.output, to_yaml(camera));
  if (options.json) {
    fmt::print("{}\n", to_json(result, found, options.lane_width).dump());
  } else {
    fmt::print("{} of {} images, lane width {} m\n{}{}", result.views_used, options.images.size(),
               options.lane_width, to_text(result), to_text(found.refused));
  }
  return 0;
}

}  // namespace lanefuse
