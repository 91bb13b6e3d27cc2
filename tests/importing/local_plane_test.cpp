// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/local_plane.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

// San Francisco, 37.721 degrees north, 122.472299 degrees west: the first pose of comma2k19's example.
const Eigen::Vector3d kSanFrancisco(-2712087.5168, -4261670.0560, 3881014.4539);

TEST(LocalPlane, KnowsTheGeodeticLatitude) {
  EXPECT_NEAR(geodetic_latitude(kSanFrancisco) * 180 / std::numbers::pi, 37.7210000, 1e-6);
}

TEST(LocalPlane, LatitudeOfThePoleAndTheEquator) {
  EXPECT_NEAR(geodetic_latitude({0, 0, 6356752.314}), std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(geodetic_latitude({6378137, 0, 0}), 0, 1e-12);
}

TEST(LocalPlane, StartsAtItsOrigin) {
  EXPECT_LT(LocalPlane(kSanFrancisco).position(kSanFrancisco).norm(), 1e-9);
}

TEST(LocalPlane, PointsEastNorthUp) {
  // At longitude 0 on the equator: east is y, north is z, up is x.
  const LocalPlane plane({6378137, 0, 0});
  EXPECT_TRUE(plane.direction({0, 1, 0}).isApprox(Eigen::Vector3d(1, 0, 0), 1e-12));
  EXPECT_TRUE(plane.direction({0, 0, 1}).isApprox(Eigen::Vector3d(0, 1, 0), 1e-12));
  EXPECT_TRUE(plane.direction({1, 0, 0}).isApprox(Eigen::Vector3d(0, 0, 1), 1e-12));
}

TEST(LocalPlane, KeepsDistances) {
  const Eigen::Vector3d step(3, -4, 12);
  EXPECT_NEAR(LocalPlane(kSanFrancisco).position(kSanFrancisco + step).norm(), 13, 1e-9);
}

}  // namespace
}  // namespace lanefuse
