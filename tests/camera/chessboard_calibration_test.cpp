// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/chessboard_calibration.hpp"

#include <algorithm>
#include <filesystem>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "camera/camera_model.hpp"
#include "camera/image_codec.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "support/files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

constexpr CameraIntrinsics kLens{1280, 720, 1160, 1155, 667, 388, {-0.27, 0.08, 0.0006, -0.0008, 0}};
constexpr double kSquare = 0.03;

/// A board of 9x6 inner corners, its middle `distance` ahead, tilted.
struct Board {
  Eigen::Matrix3d tilt;
  Eigen::Vector3d middle;

  [[nodiscard]] Eigen::Vector3d at(double column, double row) const {
    return middle + tilt * Eigen::Vector3d((column - 4) * kSquare, (row - 2.5) * kSquare, 0);
  }
};

Board random_board(Random& random, double largest_tilt) {
  const auto angle = [&] { return random.uniform(-largest_tilt, largest_tilt); };
  const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(angle() / 2, Eigen::Vector3d::UnitZ()))
                                   .toRotationMatrix();
  return {tilt, {random.uniform(-0.1, 0.1), random.uniform(-0.05, 0.05), random.uniform(0.4, 0.6)}};
}

ChessboardView view_of(const Board& board, int columns = 9, int rows = 6) {
  const CameraModel camera(kLens);
  ChessboardView view{kLens.width, kLens.height, columns, rows, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3d p = board.at(column, row);
      view.corners.push_back(*camera.pixel(Eigen::Vector2d(p.head<2>() / p.z())));
    }
  }
  return view;
}

std::vector<ChessboardView> many_views(double largest_tilt) {
  Random random(7, "boards");
  std::vector<ChessboardView> views;
  for (int i = 0; i < 12; ++i) {
    views.push_back(view_of(random_board(random, largest_tilt), i % 3 == 0 ? 7 : 9, i % 4 == 0 ? 5 : 6));
  }
  return views;
}

/// Fields of black and white, seen by the lens, with its own light gradient.
Image drawing_of(const Board& board) {
  const CameraModel camera(kLens);
  const Eigen::Vector3d normal = board.tilt.col(2);
  Image image(kLens.width, kLens.height, 3);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const Eigen::Vector3d ray = camera.direction({u, v}).homogeneous();
      const Eigen::Vector3d hit = ray * (board.middle.dot(normal) / ray.dot(normal));
      const Eigen::Vector3d on_board = board.tilt.transpose() * (hit - board.middle) / kSquare;
      const double column = on_board.x() + 5;
      const double row = on_board.y() + 3.5;
      const bool inside = column > 0 && column < 10 && row > 0 && row < 7;
      const bool black = inside && (static_cast<int>(column) + static_cast<int>(row)) % 2 == 0;
      std::fill_n(image.row(v) + 3 * u, 3, static_cast<std::uint8_t>((black ? 20 : 190) + u / 32));
    }
  }
  return image;
}

TEST(ChessboardCalibration, ExactCornersGiveTheLensExactly) {
  const auto result = calibrate_with_chessboards(many_views(0.5), {.square = kSquare});
  EXPECT_LT(result.rms_px, 1e-3);
  EXPECT_EQ(result.views_used, 12);
  EXPECT_NEAR(result.camera.fx, kLens.fx, 0.1);
  EXPECT_NEAR(result.camera.fy, kLens.fy, 0.1);
  EXPECT_NEAR(result.camera.cx, kLens.cx, 0.1);
  EXPECT_NEAR(result.camera.cy, kLens.cy, 0.1);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(result.camera.distortion[i], kLens.distortion[i], 2e-3) << i;
  }
  for (const auto& view : result.views) EXPECT_NEAR(view.distance, 0.5, 0.25);
}

TEST(ChessboardCalibration, ImagesOfAnotherSizeAreLeftOutButOnePixelIsForgiven) {
  std::vector<ChessboardView> views = many_views(0.5);
  views[2].width += 1;
  views[2].height += 1;
  views[5].width = 1920;
  const auto result = calibrate_with_chessboards(views);
  EXPECT_EQ(result.views_used, 11);
  EXPECT_TRUE(result.views[2].used);
  EXPECT_FALSE(result.views[5].used);
  EXPECT_EQ(result.camera.width, 1280);
  EXPECT_EQ(result.camera.height, 720);
}

TEST(ChessboardCalibration, RefusesWhatDoesNotDetermineTheLens) {
  EXPECT_THROW(calibrate_with_chessboards({}), Error);
  const std::vector<ChessboardView> two = {many_views(0.5)[0], many_views(0.5)[1]};
  EXPECT_THROW(calibrate_with_chessboards(two), Error);
  EXPECT_THROW(calibrate_with_chessboards(many_views(0)), Error) << "all boards face the camera";
}

TEST(ChessboardCalibration, FindsTheBoardWhereItIs) {
  Random random(8, "boards");
  Board board = random_board(random, 0.4);
  board.middle = {0.02, -0.01, 0.6};  // all of it is in the image
  const auto view = find_chessboard(drawing_of(board).view());
  ASSERT_TRUE(view);
  EXPECT_EQ(view->columns, 9);
  EXPECT_EQ(view->rows, 6);
  ChessboardView expected = view_of(board);
  if ((view->corners.front() - expected.corners.front()).norm() > 5) {
    std::reverse(expected.corners.begin(), expected.corners.end());  // a board has no upper side
  }
  for (std::size_t i = 0; i < expected.corners.size(); ++i) {
    EXPECT_LT((view->corners[i] - expected.corners[i]).norm(), 0.3) << i;
  }
}

TEST(ChessboardCalibration, FindsThePartOfABoardThatIsInTheImage) {
  Board board{Eigen::Matrix3d::Identity(), {0, 0, 0.4}};
  board.middle.y() = -0.09;  // its first row of corners lies over the image's upper edge
  const auto view = find_chessboard(drawing_of(board).view());
  ASSERT_TRUE(view);
  EXPECT_EQ(view->columns, 9);
  EXPECT_EQ(view->rows, 5);
}

TEST(ChessboardCalibration, FindsNoBoardWhereThereIsNone) {
  EXPECT_FALSE(find_chessboard(Image(320, 180, 3).view(), {.may_miss = 0}));
  EXPECT_FALSE(find_chessboard(Image(2, 2, 3).view()));
}

TEST(ChessboardCalibration, AgreesWithTheReferenceOnRealBoards) {
  const auto folder = testing::real_data("highway_video/calibration");
  LANEFUSE_NEEDS_DATA(folder);
  std::vector<ChessboardView> views;
  for (int i = 1; i <= 20; i += 2) {  // all of them: tests/cli
    const auto image =
        decode_image(testing::read_file(folder / ("calibration" + std::to_string(i) + ".jpg")));
    ASSERT_TRUE(image);
    if (const auto view = find_chessboard(image->view())) views.push_back(*view);
  }
  const auto result = calibrate_with_chessboards(views);
  EXPECT_GE(result.views_used, 9);
  EXPECT_LT(result.rms_px, 1.1);
  EXPECT_NEAR(result.camera.fx, 1160, 0.01 * 1160);
  EXPECT_NEAR(result.camera.fy, 1155, 0.01 * 1155);
  EXPECT_NEAR(result.camera.distortion[0], -0.27, 0.05);
}

}  // namespace
}  // namespace lanefuse
