// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/marking_extractor.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "camera/painted_frame.hpp"

namespace lanefuse {
namespace {

using testing::motorway;
using testing::PaintedLine;
using testing::PaintedRoad;
using testing::RoadPainter;

const CameraModel kCamera({2560, 900, 2875, 2875, 1279.5, 449.5, {-0.05, 0.01, 0, 0, 0}});

/// A pose that is known as well as poses ever are.
CameraPose known_pose(Random& random) {
  CameraPose pose;
  pose.mounting = {
      0, 0, 1.25, random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), random.uniform(-0.005, 0.005)};
  pose.covariance.diagonal().setConstant(1e-12);
  return pose;
}

/// A pose as online calibration knows it.
CameraPose estimated_pose(Random& random) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Eigen::Vector4d sigma(0.01, 0.15 * kDegree, 0.12 * kDegree, 0.12 * kDegree);
  CameraPose pose = known_pose(random);
  pose.covariance.diagonal() = sigma.array().square();
  pose.vertical_curvature_sigma = 1.7e-5;
  return pose;
}

CameraPose drawn_from(const CameraPose& pose, Random& random) {
  CameraPose drawn = pose;
  drawn.mounting.z += random.normal(std::sqrt(pose.covariance(0, 0)));
  drawn.mounting.roll += random.normal(std::sqrt(pose.covariance(1, 1)));
  drawn.mounting.pitch += random.normal(std::sqrt(pose.covariance(2, 2)));
  drawn.mounting.yaw += random.normal(std::sqrt(pose.covariance(3, 3)));
  drawn.vertical_curvature += random.normal(pose.vertical_curvature_sigma);
  return drawn;
}

/// The line of the road nearest to a feature, and how far off it is across the road [m].
struct Match {
  const PaintedLine* line = nullptr;
  double off = 1e9;
};
Match match(const PaintedRoad& road, const Eigen::Vector2d& place) {
  Match best;
  for (const PaintedLine& line : road.lines) {
    const double off =
        (place.y() - road.y(line, place.x())) * std::cos(std::atan(road.course.slope(place.x())));
    if (std::abs(off) < std::abs(best.off)) best = {&line, off};
  }
  return best;
}

double across(const Feature& feature, double heading) {
  const Eigen::Vector2d normal(-std::sin(heading), std::cos(heading));
  return normal.dot(feature.covariance.topLeftCorner<2, 2>() * normal);
}

/// Of the heading against the road's where the feature is believed to be: on a bend that depends on x, too.
double turn_variance(const Feature& feature, double curvature) {
  const Eigen::Vector3d by(-curvature, 0, 1);
  return by.dot(feature.covariance * by);
}

TEST(MarkingExtractor, FindsPaintToAFractionOfAPixel) {
  Random random(1, "roads");
  RoadPainter painter(kCamera, 1);
  MarkingExtractor extractor(kCamera.intrinsics());
  std::map<int, std::pair<double, int>> squares;  // of pixels, by 40 m
  int wrong = 0;
  int all = 0;
  for (int frame = 0; frame < 8; ++frame) {
    const PaintedRoad road = motorway(random);
    const CameraPose pose = known_pose(random);
    const GroundProjection projection(kCamera, pose);
    for (const Feature& feature : extractor.extract({painter.paint(road, pose).view(), pose, {}, 2})) {
      const Match found = match(road, {feature.x, feature.y});
      const auto seen = projection.pixel({feature.x, feature.y});
      const auto truth = projection.pixel({feature.x, road.y(*found.line, feature.x)});
      const double off = (*seen - *truth).norm();
      ++all;
      if (off > 8) {
        ++wrong;
        continue;
      }
      auto& [sum, count] = squares[static_cast<int>(feature.x / 40)];
      sum += off * off;
      ++count;
    }
  }
  EXPECT_GT(all, 8 * 120);
  EXPECT_LT(wrong, 0.02 * all);
  ASSERT_EQ(squares.count(2), 1U);
  EXPECT_LT(std::sqrt(squares[0].first / squares[0].second), 0.3);
  EXPECT_LT(std::sqrt(squares[1].first / squares[1].second), 0.5);
  EXPECT_LT(std::sqrt(squares[2].first / squares[2].second), 1.0);
}

TEST(MarkingExtractor, FindsMostOfWhatIsPainted) {
  Random random(2, "roads");
  RoadPainter painter(kCamera, 2);
  MarkingExtractor extractor(kCamera.intrinsics());
  std::map<bool, std::pair<int, int>> found;  // beyond 60 m: found, of all
  for (int frame = 0; frame < 6; ++frame) {
    const PaintedRoad road = motorway(random);
    const CameraPose pose = known_pose(random);
    const GroundProjection projection(kCamera, pose);
    const auto& features = extractor.extract({painter.paint(road, pose).view(), pose, {}, 2});
    for (const PaintedLine& line : road.lines) {
      for (double x = 9; x < 110; x += std::max(1.0, x * x / 3600)) {
        const double row = x * x / 3600;  // [m] of road that a row covers
        const Eigen::Vector2d place(x, road.y(line, x));
        const auto pixel = projection.pixel(place);
        const bool whole = road.painted(line, x - row / 2) && road.painted(line, x + row / 2);
        if (!whole || !pixel || pixel->x() < 80 || pixel->x() > 2480 || pixel->y() > 890) continue;
        auto& [hits, all] = found[x > 60];
        ++all;
        hits += std::any_of(features.begin(), features.end(), [&](const Feature& feature) {
          return std::abs(feature.x - x) < std::max(1.1, 1.1 * row) && std::abs(feature.y - place.y()) < 0.3;
        });
      }
    }
  }
  EXPECT_GT(found[false].first, 0.95 * found[false].second);
  EXPECT_GT(found[true].first, 0.80 * found[true].second);
}

TEST(MarkingExtractor, CovarianceHoldsWhatTheErrorsAre) {
  Random random(3, "roads");
  RoadPainter painter(kCamera, 3);
  MarkingExtractor extractor(kCamera.intrinsics());
  int within = 0;
  int headings_within = 0;
  int all = 0;
  for (int frame = 0; frame < 30; ++frame) {
    const PaintedRoad road = motorway(random);
    const CameraPose pose = estimated_pose(random);
    const Image image = painter.paint(road, drawn_from(pose, random));
    for (const Feature& feature : extractor.extract({image.view(), pose, {}, 2})) {
      const double heading = std::atan(road.course.slope(feature.x));
      const double variance = across(feature, heading);
      const double off = match(road, {feature.x, feature.y}).off;
      const double turned = feature.heading - heading;
      within += off * off < 3.84 * variance;
      headings_within += turned * turned < 3.84 * turn_variance(feature, road.course.curvature_at(feature.x));
      ++all;
    }
  }
  // Errors of a frame lean together: of 30 frames this is no more than a rough look.
  EXPECT_GT(within, 0.85 * all);
  EXPECT_LT(within, 0.999 * all);
  EXPECT_GT(headings_within, 0.85 * all);
}

TEST(MarkingExtractor, CovarianceGrowsWithWhatIsUncertain) {
  Random random(4, "roads");
  RoadPainter painter(kCamera, 4);
  const PaintedRoad road = motorway(random);
  CameraPose pose = known_pose(random);
  const Image image = painter.paint(road, pose);
  MarkingExtractor extractor(kCamera.intrinsics());
  const std::vector<Feature> sure = extractor.extract({image.view(), pose, {}, 2});
  pose.covariance(3, 3) = 1e-6;  // 1 mrad of yaw
  const std::vector<Feature> unsure = extractor.extract({image.view(), pose, {}, 2});
  ASSERT_EQ(sure.size(), unsure.size());
  for (std::size_t i = 0; i < sure.size(); ++i) {
    EXPECT_NEAR(unsure[i].covariance(1, 1) - sure[i].covariance(1, 1), 1e-6 * sure[i].x * sure[i].x,
                1e-3 * unsure[i].covariance(1, 1));
    EXPECT_NEAR(unsure[i].covariance(2, 2) - sure[i].covariance(2, 2), 1e-6, 1e-8);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(unsure[i].covariance).eigenvalues().minCoeff(),
              0);
  }
}

TEST(MarkingExtractor, TellsColourAndKind) {
  PaintedRoad road;
  road.lines = {{1.8, 0.15, 0, 0, 0, 80, true}, {-1.8, 0.15, 6, 12, 3, 80, false}};
  Random random(5, "roads");
  const CameraPose pose = known_pose(random);
  RoadPainter painter(kCamera, 5);
  MarkingExtractor extractor(kCamera.intrinsics());
  int left = 0;
  int right = 0;
  for (const Feature& feature : extractor.extract({painter.paint(road, pose).view(), pose, {}, 2})) {
    if (feature.x > 50) continue;
    const bool is_left = feature.y > 0;
    EXPECT_EQ(feature.marking.colour, is_left ? MarkingColour::yellow : MarkingColour::white) << feature.x;
    EXPECT_EQ(feature.marking.type, is_left ? MarkingType::solid : MarkingType::dashed) << feature.x;
    ++(is_left ? left : right);
  }
  EXPECT_GT(left, 25);
  EXPECT_GT(right, 6);
}

TEST(MarkingExtractor, BelievesNothingOnABareRoad) {
  Random random(6, "roads");
  RoadPainter painter(kCamera, 6);
  MarkingExtractor extractor(kCamera.intrinsics());
  std::size_t believed = 0;
  for (int frame = 0; frame < 5; ++frame) {
    PaintedRoad bare;
    bare.noise = 2 + 3 * frame;
    const CameraPose pose = known_pose(random);
    believed += extractor.extract({painter.paint(bare, pose).view(), pose, {}, 2}).size();
  }
  EXPECT_LT(believed, 10U);
}

TEST(MarkingExtractor, LooksBesideVehiclesButNotThroughThem) {
  Random random(7, "roads");
  PaintedRoad road;
  road.lines = {{1.8}, {-1.8}, {-5.4}};
  const CameraPose pose = known_pose(random);
  RoadPainter painter(kCamera, 7);
  const Image image = painter.paint(road, pose);
  const GroundProjection projection(kCamera, pose);
  // To the right, 20 m ahead: its box reaches over the right line, which runs free beside it.
  const Eigen::Vector2d foot = *projection.pixel({20, -2.7});
  const Eigen::Vector2d far_foot = *projection.pixel({20, -4.5});
  const Eigen::Vector2d front = *projection.pixel({36, -2.7});
  const VehicleBox truck{front.x(), foot.y() - 500, far_foot.x(), foot.y(), 20, -3.6, 1.8, 1};
  MarkingExtractor extractor(kCamera.intrinsics());
  int beside = 0;
  for (const Feature& feature : extractor.extract({image.view(), pose, {&truck, 1}, 2})) {
    beside += feature.y < -1 && feature.y > -2.4 && feature.x > 21 && feature.x < 35;
    const auto pixel = projection.pixel({feature.x, feature.y});
    const bool behind = pixel->x() > foot.x() && pixel->x() < truck.right && pixel->y() < truck.bottom;
    EXPECT_FALSE(behind) << feature.x << " " << feature.y;
  }
  EXPECT_GT(beside, 10);
}

TEST(MarkingExtractor, SameImageSameFeatures) {
  Random random(8, "roads");
  const PaintedRoad road = motorway(random);
  const CameraPose pose = known_pose(random);
  RoadPainter painter(kCamera, 8);
  const Image image = painter.paint(road, pose);
  MarkingExtractor fresh(kCamera.intrinsics());
  MarkingExtractor used(kCamera.intrinsics());
  used.extract({painter.paint(motorway(random), pose).view(), pose, {}, 2});
  const auto& a = fresh.extract({image.view(), pose, {}, 2});
  const auto& b = used.extract({image.view(), pose, {}, 2});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].x, b[i].x);
    EXPECT_EQ(a[i].y, b[i].y);
    EXPECT_EQ(a[i].covariance, b[i].covariance);
  }
}

}  // namespace
}  // namespace lanefuse
