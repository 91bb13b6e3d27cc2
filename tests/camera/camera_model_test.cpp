// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_model.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

CameraIntrinsics distorted_camera() {
  return {1280, 720, 1160, 1155, 668, 388, {-0.27, 0.05, 0.0006, -0.0008, -0.01}};
}

TEST(CameraModel, DirectionsAndPixelsAreInverseOverTheWholeImage) {
  const CameraModel camera(distorted_camera());
  Random random(1, "pixels");
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d pixel(random.uniform(0, 1280), random.uniform(0, 720));
    const auto back = camera.pixel(camera.direction(pixel));
    ASSERT_TRUE(back);
    EXPECT_LT((*back - pixel).norm(), 1e-5) << pixel.transpose();
  }
}

TEST(CameraModel, JacobianEqualsFiniteDifferences) {
  const CameraModel camera(distorted_camera());
  Random random(2, "directions");
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d direction(random.uniform(-0.5, 0.5), random.uniform(-0.3, 0.3));
    const Eigen::Matrix2d jacobian = camera.jacobian(direction);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d step = 1e-6 * Eigen::Vector2d::Unit(k);
      const Eigen::Vector2d difference =
          (*camera.pixel(direction + step) - *camera.pixel(direction - step)) / 2e-6;
      EXPECT_LT((jacobian.col(k) - difference).norm(), 1e-3);
    }
  }
}

TEST(CameraModel, ShowsNothingWhereTheDistortionTurnsBack) {
  const CameraModel camera(distorted_camera());
  EXPECT_FALSE(camera.pixel({2.5, 0}));
  EXPECT_FALSE(camera.pixel({std::nan(""), 0}));
}

TEST(CameraModel, RefusesALensThatIsNone) {
  CameraIntrinsics camera = distorted_camera();
  camera.fx = 0;
  EXPECT_THROW(CameraModel{camera}, Error);
}

}  // namespace
}  // namespace lanefuse
