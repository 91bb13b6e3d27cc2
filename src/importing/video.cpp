// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/video.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "camera/camera_file.hpp"
#include "camera/dash_period.hpp"
#include "camera/image_codec.hpp"
#include "camera/road_plane_motion.hpp"
#include "camera/vehicle_detector.hpp"
#include "core/error.hpp"
#include "importing/motion_table.hpp"
#include "importing/video_frames.hpp"

namespace lanefuse {
namespace {

/// How well a camera's height is known without anything better; the speed's scale is as good.
constexpr double kHeightSigma = 0.03;

Time time_of(std::size_t frame, double frames_per_second) {
  return Time{from_seconds(static_cast<double>(frame) / frames_per_second)};
}

void check_size(const ImageView& image, const SensorDescription& camera, const VideoImport& import) {
  const CameraIntrinsics& intrinsics = *camera.camera;
  if (image.width == intrinsics.width && image.height == intrinsics.height) return;
  throw input_error(
      import.video.string(),
      fmt::format("frames are {} x {} pixels, the camera's are {} x {}", image.width, image.height,
                  intrinsics.width, intrinsics.height),
      fmt::format("calibrate for this size, or scale the video to that of {}", import.camera.string()));
}

/// What the road plane tells of the motion, frame by frame.
class RoadPlaneSurvey {
 public:
  RoadPlaneSurvey(const SensorDescription& camera, const VideoImport& import, double seconds)
      : seconds_(seconds), motion_(*camera.camera), vehicles_(*camera.camera) {
    pose_.mounting = camera.mounting;
    if (import.dash_period) {
      dashes_.emplace(*camera.camera, DashPeriodConfig{.expected = *import.dash_period});
    }
  }

  void add(const ImageView& image) {
    const std::vector<VehicleBox>& boxes =
        vehicles_.detect({image, pose_, last_.speed, last_.yaw_rate, seconds_});
    last_ = motion_.update({image, pose_, seconds_, boxes});
    estimates_.push_back(last_);
    way_ += last_.speed * seconds_;
    if (dashes_) dashes_->add(image, pose_, way_);
  }

  /// The first frame moved as the second did: there is nothing before it.
  [[nodiscard]] std::vector<RoadPlaneMotionEstimate> estimates() const {
    std::vector<RoadPlaneMotionEstimate> all = estimates_;
    if (all.size() > 1) all[0] = all[1];
    return all;
  }

  [[nodiscard]] std::optional<DashPeriod> dash_period() const {
    return dashes_ ? dashes_->measure() : std::nullopt;
  }

 private:
  double seconds_;
  CameraPose pose_;
  RoadPlaneMotion motion_;
  VehicleDetector vehicles_;
  std::optional<DashPeriodMeter> dashes_;
  RoadPlaneMotionEstimate last_;
  std::vector<RoadPlaneMotionEstimate> estimates_;
  double way_ = 0;
};

/// Where the scale of the speeds comes from.
void set_scale(const VideoImport& import, const RoadPlaneSurvey& survey, VideoMotion& result) {
  const std::optional<DashPeriod> dashes = survey.dash_period();
  if (dashes) {
    result.measured_dash_period = dashes->period;
    result.scale_drift = dashes->drift;
  }
  if (import.speed || import.motion) {
    result.scale_source = "given";
  } else if (import.dash_period) {
    if (!dashes) {
      throw input_error(import.video.string(),
                        fmt::format("no dashes come again about every {} m", *import.dash_period),
                        "leave --dash-period-m out: the camera's height then gives the scale");
    }
    result.scale_source = "dash period";
    result.scale = *import.dash_period / dashes->period;
    result.scale_sigma = dashes->sigma / dashes->period;
  } else {
    result.scale_source = "camera height";
    result.scale_sigma = kHeightSigma;
  }
}

void set_motions(const VideoImport& import, const std::vector<RoadPlaneMotionEstimate>& estimates,
                 VideoMotion& result) {
  std::optional<MotionTable> table;
  if (import.motion) table.emplace(*import.motion);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const Time time = time_of(i, result.frames_per_second);
    VehicleMotion motion{.stamp = {time, time, kVideoOdometry},
                         .speed = estimates[i].speed * result.scale,
                         .yaw_rate = estimates[i].yaw_rate,
                         .wheel_speeds = {}};
    if (import.speed) motion.speed = import.speed;
    if (table) {
      const MotionTable::Motion given = table->at(static_cast<double>(i) / result.frames_per_second);
      motion.speed = given.speed;
      if (given.yaw_rate) motion.yaw_rate = given.yaw_rate;
    }
    result.motions.push_back(motion);
  }
}

void set_statistics(const std::vector<RoadPlaneMotionEstimate>& estimates, VideoMotion& result) {
  std::vector<double> speeds;
  for (const VehicleMotion& motion : result.motions) speeds.push_back(*motion.speed);
  const auto count = static_cast<double>(speeds.size());
  result.speed_mean = std::accumulate(speeds.begin(), speeds.end(), 0.0) / count;
  result.speed_min = *std::min_element(speeds.begin(), speeds.end());
  result.speed_max = *std::max_element(speeds.begin(), speeds.end());
  const auto seen = std::count_if(estimates.begin(), estimates.end(),
                                  [](const RoadPlaneMotionEstimate& estimate) { return estimate.measured; });
  result.seen = static_cast<double>(seen) / count;
}

void add_notes(const VideoImport& import, VideoMotion& result) {
  if (result.frames_announced != static_cast<std::int64_t>(result.motions.size())) {
    result.notes.push_back(fmt::format("the container announces {} frames, {} can be decoded",
                                       result.frames_announced, result.motions.size()));
  }
  if (result.scale_source == "camera height") {
    result.notes.push_back(fmt::format(
        "the scale of the speeds is that of the camera's height: {:.0f} % of one is {:.0f} % of the other",
        100 * kHeightSigma, 100 * kHeightSigma));
  }
  if (result.scale_source == "dash period") {
    result.notes.push_back(
        fmt::format("the dashes say {:.3f} of the scale that the camera's height gives: its height in the "
                    "recording is {:.3f} m",
                    result.scale, result.rig.find(kVideoCamera)->mounting.z));
  }
  if (import.speed) result.notes.emplace_back("speed as given; the yaw rate is from the road plane");
  constexpr double kLeastSeen = 0.8;
  if (result.seen < kLeastSeen) {
    result.notes.push_back(fmt::format(
        "the road showed the motion in {:.0f} % of the frames only; in between it is extrapolated",
        100 * result.seen));
  }
  result.notes.emplace_back("no radar: no vehicle can bear witness of its lane");
}

Rig video_rig(SensorDescription camera, const std::string& odometry) {
  camera.id = kVideoCamera;
  return {{{.id = kVideoOdometry, .kind = SensorKind::odometry, .name = odometry, .mounting = {}}, camera}};
}

}  // namespace

VideoMotion survey_video(const VideoImport& import) {
  SensorDescription camera = load_camera(import.camera);
  VideoFrames frames(import.video);
  VideoMotion result;
  result.frames_per_second = frames.frames_per_second();
  result.frames_announced = frames.announced();
  result.info.name = fmt::format("video {}", import.video.filename().string());
  RoadPlaneSurvey survey(camera, import, 1 / result.frames_per_second);
  while (frames.next()) {
    check_size(frames.image(), camera, import);
    survey.add(frames.image());
  }
  const std::vector<RoadPlaneMotionEstimate> estimates = survey.estimates();
  if (estimates.empty()) throw input_error(import.video.string(), "no frame can be decoded");
  set_scale(import, survey, result);
  camera.mounting.z *= result.scale;
  result.rig =
      video_rig(camera, result.scale_source == "given" ? "motion as given" : "motion from the road plane");
  set_motions(import, estimates, result);
  set_statistics(estimates, result);
  add_notes(import, result);
  return result;
}

void write_video(const VideoImport& import, const VideoMotion& motion,
                 const std::function<void(const Measurement&)>& write) {
  VideoFrames frames(import.video);
  for (const VehicleMotion& moved : motion.motions) {
    if (!frames.next()) throw input_error(import.video.string(), "holds fewer frames than a moment ago");
    write(moved);
    const Stamp stamp{moved.stamp.measured_at, moved.stamp.received_at, kVideoCamera};
    write(CameraImage{stamp, "jpeg", encode_jpeg(frames.image(), import.jpeg_quality)});
  }
}

}  // namespace lanefuse
