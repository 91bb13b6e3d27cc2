// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "camera/image.hpp"
#include "sensors/camera_intrinsics.hpp"

namespace lanefuse {

struct ChessboardConfig {
  int columns = 9;         ///< inner corners across the board
  int rows = 6;            ///< inner corners along it
  int may_miss = 2;        ///< so many columns and rows may be out of the picture
  double square = 1;       ///< [m] side of a square; the lens does not depend on it, the distances do
  int size_tolerance = 1;  ///< [px] by which an image may differ from the others' size and still count
};

/// A chessboard as one image shows it.
struct ChessboardView {
  int width = 0;                         ///< [px] of the image
  int height = 0;                        ///< [px] of the image
  int columns = 0;                       ///< inner corners seen
  int rows = 0;                          ///< inner corners seen
  std::vector<Eigen::Vector2d> corners;  ///< [px] row by row
};

/// The board with the most corners that the image shows; nothing where there is none.
std::optional<ChessboardView> find_chessboard(const ImageView& image, const ChessboardConfig& config = {});

struct ChessboardCalibration {
  CameraIntrinsics camera;
  /// One standard deviation of (fx, fy, cx, cy, k1, k2, p1, p2) if corners erred independently; a board that
  /// is not flat makes them err together.
  std::array<double, 8> sigma{};
  double rms_px = 0;  ///< of the corners' reprojection errors
  int views_used = 0;
  struct ViewFit {
    bool used = false;  ///< false: an image of another size
    double rms_px = 0;
    double distance = 0;  ///< [m] of the board, in terms of ChessboardConfig::square
  };
  std::vector<ViewFit> views;  ///< as they were handed in
};

/// The lens that explains the views best: a pinhole with k1, k2, p1, p2 [Zhang 2000, in OpenCV's terms]. k3
/// stays zero: boards that do not fill the image's corners do not determine it.
///
/// Throws an input Error where fewer than three views share a size, or the views do not determine the lens.
ChessboardCalibration calibrate_with_chessboards(std::span<const ChessboardView> views,
                                                 const ChessboardConfig& config = {});

}  // namespace lanefuse
