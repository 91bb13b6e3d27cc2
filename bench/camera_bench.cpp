// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What an image costs beside OpenCV's Canny on the same frame, on one core: the whole extraction of marking
// features from the high-resolution camera, with covariances, and the serial camera's lane tracker. The last
// lines print both and their ratio.
#include <algorithm>
#include <ctime>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include <benchmark/benchmark.h>

#include "camera/image.hpp"
#include "camera/lane_tracker.hpp"
#include "camera/marking_extractor.hpp"
#include "camera/online_calibration.hpp"
#include "core/random.hpp"
#include "simulation/camera_image_model.hpp"
#include "simulation/image_truth.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

constexpr int kFrames = 8;

/// A rendered frame of traffic on a clear day, and how its camera stood.
struct Frame {
  Image image;
  CameraPose pose;
  std::vector<VehicleBox> vehicles;
};

std::vector<Frame> render(const CameraIntrinsics& camera) {
  const CameraRenderer renderer(camera, {});
  std::vector<Frame> frames;
  for (std::uint64_t seed = 1; seed <= kFrames; ++seed) {
    testing::SceneRun run(seed);
    for (int tick = 0; tick < 50; ++tick) run.advance();
    const Scene scene = run.scene();
    Random random(seed, "attitude of the bench");
    const Mounting mounting{
        0, 0, 1.25 + random.normal(0.01), random.normal(0.003), random.normal(0.005), random.normal(0.004)};
    const ImageTruth truth(scene, renderer.camera(), mounting);
    Frame frame{renderer.render(scene, mounting), truth.pose(), truth.vehicles()};
    frame.pose.covariance.diagonal() << 1e-4, 7e-6, 4e-6, 4e-6;
    frames.push_back(std::move(frame));
  }
  return frames;
}

const std::vector<Frame>& high_resolution_frames() {
  static const std::vector<Frame> frames = render(high_resolution_camera_intrinsics());
  return frames;
}

cv::Mat grey_of(const Image& image) {
  const ImageView view = image.view();
  // OpenCV only reads from here.
  const cv::Mat colours(view.height, view.width, CV_8UC3, const_cast<std::uint8_t*>(view.data));
  cv::Mat grey;
  cv::cvtColor(colours, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

void canny(benchmark::State& state, const std::vector<Frame>& frames) {
  cv::setNumThreads(1);
  std::vector<cv::Mat> grey;
  for (const Frame& frame : frames) grey.push_back(grey_of(frame.image));
  cv::Mat edges;
  std::size_t i = 0;
  for (auto _ : state) cv::Canny(grey[i++ % grey.size()], edges, 100, 200);
}

void extract_markings(benchmark::State& state) {
  cv::setNumThreads(1);
  const std::vector<Frame>& frames = high_resolution_frames();
  MarkingExtractor extractor(high_resolution_camera_intrinsics());
  std::size_t i = 0;
  std::size_t features = 0;
  for (auto _ : state) {
    const Frame& frame = frames[i++ % frames.size()];
    features += extractor.extract({frame.image.view(), frame.pose, frame.vehicles, 2.4}).size();
  }
  state.counters["features"] =
      benchmark::Counter(static_cast<double>(features), benchmark::Counter::kAvgIterations);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Ours and Canny in turn on the same frames, so that whatever else the machine does hits both; the medians
/// and their ratio. `work` takes the number of a frame.
template <class Work>
void compare(benchmark::State& state, const std::vector<Frame>& frames, Work work) {
  cv::setNumThreads(1);
  std::vector<double> ours;
  std::vector<double> theirs;
  // Processor time: the machine may have other things to do.
  const auto ms_since = [](std::clock_t begin) {
    return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  std::vector<cv::Mat> grey;
  for (const Frame& frame : frames) grey.push_back(grey_of(frame.image));
  cv::Mat edges;
  for (auto _ : state) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      std::clock_t begin = std::clock();
      work(i);
      ours.push_back(ms_since(begin));
      begin = std::clock();
      cv::Canny(grey[i], edges, 100, 200);
      theirs.push_back(ms_since(begin));
    }
  }
  const double mine = median(ours);
  const double reference = median(theirs);
  state.counters["ours_ms"] = mine;
  state.counters["canny_ms"] = reference;
  state.counters["ratio"] = mine / reference;
}

void extraction_against_canny(benchmark::State& state) {
  const std::vector<Frame>& frames = high_resolution_frames();
  MarkingExtractor extractor(high_resolution_camera_intrinsics());
  compare(state, frames, [&](std::size_t i) {
    extractor.extract({frames[i].image.view(), frames[i].pose, frames[i].vehicles, 2.4});
  });
}

/// The serial camera's lane tracker with its online calibration; each frame has a tracker of its own that
/// stands in front of it and follows the lane already.
void tracking_against_canny(benchmark::State& state) {
  const std::vector<Frame> frames = render(serial_camera_intrinsics());
  struct Follower {
    LaneTracker tracker{serial_camera_intrinsics()};
    OnlineCalibration calibration{Mounting{0, 0, 1.25, 0, 0, 0}};
    Time now{};
  };
  std::vector<Follower> followers(frames.size());
  double tracked = 0;
  const auto follow = [&](std::size_t i) {
    Follower& f = followers[i];
    f.now += std::chrono::milliseconds(40);
    const LaneTrack& track =
        f.tracker.track({frames[i].image.view(), f.now, f.calibration.pose(), 0, 0, frames[i].vehicles});
    f.calibration.update(track, 0, 0, f.now);
    tracked += track.status == LaneTrackStatus::tracking ? 1 : 0;
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (int warm = 0; warm < 20; ++warm) follow(i);
  }
  tracked = 0;
  compare(state, frames, follow);
  state.counters["tracked"] =
      tracked / (static_cast<double>(frames.size()) * static_cast<double>(state.iterations()));
}

BENCHMARK_CAPTURE(canny, high_resolution, high_resolution_frames())->Unit(benchmark::kMillisecond);
BENCHMARK(extract_markings)->Unit(benchmark::kMillisecond);
BENCHMARK(extraction_against_canny)->Unit(benchmark::kMillisecond)->Iterations(20);
BENCHMARK(tracking_against_canny)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
}  // namespace lanefuse
