// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/overlay_command.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "camera/image_codec.hpp"
#include "cli/lanes_and_truth.hpp"
#include "cli/output_file.hpp"
#include "cli/overlay_input.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "drawing/moved_view.hpp"
#include "drawing/overlay.hpp"
#include "drawing/picture_file.hpp"
#include "drawing/video_writer.hpp"

namespace lanefuse {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();

/// The cycle as it looks at the moment of the image, with whatever truth there is.
TopView road_at(const OverlayFrame& frame, const LanesAndTruth& context) {
  const LaneEstimate& estimate = frame.record->estimate;
  const double seconds = to_seconds(frame.image.stamp.measured_at - estimate.time);
  LaneRecord moved;
  moved.estimate = moved_by(estimate, seconds);
  moved.debug = moved_by(frame.record->debug, constant_turn(estimate.speed, estimate.yaw_rate, seconds));
  return make_view(moved, context);
}

Image draw(const OverlayFrame& frame, const SensorDescription& camera, const LanesAndTruth& context,
           const std::string& title) {
  const std::optional<Image> image = decode_image(frame.image.bytes);
  OverlayScene scene;
  scene.title = title;
  scene.camera = camera.name;
  scene.seconds = frame.seconds;
  if (image) scene.image = image->view();
  scene.intrinsics = *camera.camera;
  scene.view = frame.view;
  scene.pose = frame.view ? frame.view->pose : CameraPose{.mounting = camera.mounting};
  if (frame.record) scene.road = road_at(frame, context);
  return draw_overlay(scene);
}

struct Drawn {
  std::int64_t frames = 0;
  std::int64_t without_view = 0;
  double first = 0;  ///< [s]
  double last = 0;   ///< [s]
  int width = 0;
  int height = 0;
  std::string codec;
  double frames_per_second = 0;

  void add(const OverlayFrame& frame, const Image& picture) {
    if (frames++ == 0) first = frame.seconds;
    if (!frame.view) ++without_view;
    last = frame.seconds;
    width = picture.width();
    height = picture.height();
  }
};

[[noreturn]] void refuse_no_image(double from, double end) {
  throw configuration_error(from > end ? fmt::format("second {}", from) : "the chosen seconds",
                            fmt::format("no image lies there; the last one is at {:.2f} s", end));
}

Drawn draw_video(const OverlayOptions& options, OverlayInput& input, const LanesAndTruth& context,
                 const std::string& title) {
  const double from = options.from.value_or(-kEver);
  const double to = options.to.value_or(kEver);
  Drawn drawn;
  drawn.frames_per_second = input.frames_per_second();
  std::optional<VideoWriter> video;
  Progress progress("drawing");
  double seconds = -kEver;
  for (OverlayFrame frame; input.next(frame) && frame.seconds <= to + 1e-9;) {
    seconds = frame.seconds;
    if (frame.seconds < from - 1e-9) continue;
    const Image picture = draw(frame, input.camera(), context, title);
    if (!video) video.emplace(options.output, picture.width(), picture.height(), input.frames_per_second());
    video->write(picture.view());
    drawn.add(frame, picture);
    if (options.to) {
      progress.show((frame.seconds - drawn.first) / std::max(1e-9, to - drawn.first));
    } else {
      progress.show_seconds(frame.seconds);
    }
  }
  if (!video) refuse_no_image(from, seconds);
  drawn.codec = video->codec();
  video->close();
  return drawn;
}

Drawn draw_still(const OverlayOptions& options, OverlayInput& input, const LanesAndTruth& context,
                 const std::string& title) {
  OverlayFrame frame;
  double seconds = -kEver;
  while (input.next(frame)) {
    seconds = frame.seconds;
    if (seconds < *options.at - 1e-9) continue;
    const Image picture = draw(frame, input.camera(), context, title);
    write_picture(options.output, picture.view());
    Drawn drawn;
    drawn.add(frame, picture);
    return drawn;
  }
  refuse_no_image(*options.at, seconds);
}

void print(const OverlayOptions& options, const Drawn& drawn, const std::string& camera) {
  if (!options.json) {
    fmt::print("{} frame{} of {}, {:.2f} s to {:.2f} s, {} x {} -> {}\n", drawn.frames,
               drawn.frames == 1 ? "" : "s", camera, drawn.first, drawn.last, drawn.width, drawn.height,
               options.output.string());
    return;
  }
  nlohmann::ordered_json json{{"output", options.output.string()},
                              {"camera", camera},
                              {"frames", drawn.frames},
                              {"without_view", drawn.without_view},
                              {"from_s", drawn.first},
                              {"to_s", drawn.last},
                              {"width", drawn.width},
                              {"height", drawn.height}};
  if (!options.at) {
    json["frames_per_second"] = drawn.frames_per_second;
    json["codec"] = drawn.codec;
  }
  fmt::print("{}\n", json.dump());
}

void check_ending(const OverlayOptions& options) {
  const std::string ending = options.output.extension().string();
  const bool right = options.at ? ending == ".png" || ending == ".jpg" : ending == ".mp4";
  if (!right) {
    throw configuration_error(options.output.string(), "is no name of what is to be written",
                              options.at ? "let a picture end with .png or .jpg"
                                         : "let a video end with .mp4, or choose one moment with --at");
  }
}

}  // namespace

int overlay(const OverlayOptions& options) {
  check_ending(options);
  check_output(options.output, options.force, options.lanes);
  const std::string title = LanesReader(options.lanes).drive().name;
  const LanesAndTruth context = find_truth(options.lanes, options.drive);
  if (context.drive.empty()) {
    throw configuration_error(options.lanes.string(),
                              "the drive that these lanes came from is not to be found",
                              "name it with --drive");
  }
  check_output(options.output, true, context.drive);
  OverlayInput input(options.lanes, context.drive, options.camera);
  const Drawn drawn =
      options.at ? draw_still(options, input, context, title) : draw_video(options, input, context, title);
  print(options, drawn, input.camera().name);
  return 0;
}

}  // namespace lanefuse
