// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/chessboard_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr int kFewestAcross = 3;  ///< inner corners of a board: fewer are found in any tiled wall
constexpr std::size_t kFewestViews = 3;
constexpr double kLeastCornerError = 0.1;  ///< [px]: a better fit does not make the lens better known

cv::Mat grey_of(const ImageView& image) {
  cv::Mat seen(image.height, image.width, image.channels == 3 ? CV_8UC3 : CV_8UC1,
               const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
               static_cast<std::size_t>(image.stride));
  if (image.channels == 1) return seen;
  cv::Mat grey;
  cv::cvtColor(seen, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// The pattern and its parts, the largest first.
std::vector<std::pair<int, int>> patterns(const ChessboardConfig& config) {
  std::vector<std::pair<int, int>> sizes;
  for (int columns = config.columns; columns >= config.columns - config.may_miss; --columns) {
    for (int rows = config.rows; rows >= config.rows - config.may_miss; --rows) {
      if (std::min(columns, rows) >= kFewestAcross) sizes.emplace_back(columns, rows);
    }
  }
  std::stable_sort(sizes.begin(), sizes.end(),
                   [](const auto& a, const auto& b) { return a.first * a.second > b.first * b.second; });
  return sizes;
}

/// The size that most images have; of two equally frequent ones the larger.
std::pair<int, int> usual_size(std::span<const ChessboardView> views) {
  std::map<std::pair<int, int>, int> count;
  for (const ChessboardView& view : views) ++count[{view.width, view.height}];
  const auto most = std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second, a.first) < std::pair(b.second, b.first);
  });
  return most->first;
}

/// Corners on the board and in the images, as OpenCV takes them.
struct Correspondences {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> in_image;

  void add(const ChessboardView& view, double square) {
    std::vector<cv::Point3f>& board = on_board.emplace_back();
    std::vector<cv::Point2f>& image = in_image.emplace_back();
    for (int row = 0; row < view.rows; ++row) {
      for (int column = 0; column < view.columns; ++column) {
        board.emplace_back(static_cast<float>(column * square), static_cast<float>(row * square), 0.0F);
      }
    }
    for (const Eigen::Vector2d& corner : view.corners) {
      image.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    }
  }
};

struct Solution {
  double rms = 0;
  cv::Mat camera;
  cv::Mat distortion;
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  cv::Mat sigma;
  cv::Mat view_rms;
};

Error undetermined(const std::string& why) {
  return input_error("chessboards", fmt::format("they do not determine the lens: {}", why),
                     "show the board tilted to all sides and near the image's corners");
}

Solution solve(const Correspondences& seen, const cv::Size& size) {
  Solution s;
  try {
    cv::Mat ignored;
    s.rms = cv::calibrateCamera(seen.on_board, seen.in_image, size, s.camera, s.distortion, s.rotations,
                                s.translations, s.sigma, ignored, s.view_rms, cv::CALIB_FIX_K3);
  } catch (const cv::Exception& e) {
    throw undetermined(e.err);
  }
  return s;
}

void check(const ChessboardCalibration& result) {
  const CameraIntrinsics& c = result.camera;
  bool finite = std::isfinite(result.rms_px) && std::isfinite(c.cx) && std::isfinite(c.cy);
  for (const double k : c.distortion) finite = finite && std::isfinite(k);
  for (const double s : result.sigma) finite = finite && std::isfinite(s);
  const double focal = std::min(c.fx, c.fy);
  constexpr double kLargestShare = 0.05;
  if (!finite || !(focal > 0) || !(std::max(result.sigma[0], result.sigma[1]) < kLargestShare * focal)) {
    throw undetermined("the focal length stays uncertain");
  }
}

/// Boards that all stand alike leave the focal length to their distance, whatever the sigmas say.
void check_tilts(const std::vector<cv::Mat>& rotations) {
  constexpr double kLeastTilt = 0.15;  // [rad] between some two of them
  std::vector<cv::Vec3d> normals;
  for (const cv::Mat& rotation : rotations) {
    cv::Matx33d turn;
    cv::Rodrigues(rotation, turn);
    normals.emplace_back(turn(0, 2), turn(1, 2), turn(2, 2));
  }
  for (const cv::Vec3d& a : normals) {
    for (const cv::Vec3d& b : normals) {
      if (cv::norm(a.cross(b)) > kLeastTilt) return;
    }
  }
  throw undetermined("the boards are all tilted alike");
}

}  // namespace

std::optional<ChessboardView> find_chessboard(const ImageView& image, const ChessboardConfig& config) {
  const cv::Mat grey = grey_of(image);
  for (const auto& [columns, rows] : patterns(config)) {
    std::vector<cv::Point2f> corners;
    bool found = false;
    try {
      found =
          cv::findChessboardCornersSB(grey, cv::Size(columns, rows), corners, cv::CALIB_CB_NORMALIZE_IMAGE);
    } catch (const cv::Exception&) {  // an image of a few pixels
      return {};
    }
    if (!found) continue;
    ChessboardView view{image.width, image.height, columns, rows, {}};
    for (const cv::Point2f& corner : corners) view.corners.emplace_back(corner.x, corner.y);
    return view;
  }
  return {};
}

ChessboardCalibration calibrate_with_chessboards(std::span<const ChessboardView> views,
                                                 const ChessboardConfig& config) {
  ChessboardCalibration result;
  Correspondences seen;
  const auto [width, height] = views.empty() ? std::pair(0, 0) : usual_size(views);
  for (const ChessboardView& view : views) {
    const bool used = std::abs(view.width - width) <= config.size_tolerance &&
                      std::abs(view.height - height) <= config.size_tolerance;
    if (used) seen.add(view, config.square);
    result.views.push_back({used, 0, 0});
  }
  if (seen.in_image.size() < kFewestViews) {
    throw input_error("chessboards", fmt::format("only {} images of one size show one", seen.in_image.size()),
                      fmt::format("at least {} are needed", kFewestViews));
  }
  const Solution s = solve(seen, {width, height});
  const auto k = [&s](int i) { return s.distortion.at<double>(i); };
  result.camera = {width,
                   height,
                   s.camera.at<double>(0, 0),
                   s.camera.at<double>(1, 1),
                   s.camera.at<double>(0, 2),
                   s.camera.at<double>(1, 2),
                   {k(0), k(1), k(2), k(3), 0}};
  result.rms_px = s.rms;
  const double scale = std::max(1.0, kLeastCornerError / std::max(s.rms, 1e-12));
  for (std::size_t i = 0; i < result.sigma.size(); ++i) {
    result.sigma[i] = scale * s.sigma.at<double>(static_cast<int>(i));
  }
  result.views_used = static_cast<int>(seen.in_image.size());
  int solved = 0;
  for (ChessboardCalibration::ViewFit& view : result.views) {
    if (!view.used) continue;
    view.rms_px = s.view_rms.at<double>(solved);
    view.distance = cv::norm(s.translations[static_cast<std::size_t>(solved)]);
    ++solved;
  }
  check(result);
  check_tilts(s.rotations);
  return result;
}

}  // namespace lanefuse
