// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

using Curvatures = std::array<double, RoadAxis::kKnots>;

Curvatures constant(double curvature) {
  Curvatures curvatures{};
  curvatures.fill(curvature);
  return curvatures;
}

/// The curve by many small steps.
struct Walked {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double heading = 0;
};

/// The curvature between knots runs straight, and beyond them it stays.
double curvature_of(const Curvatures& curvatures, double first_knot, double station) {
  const double place =
      std::clamp((station - first_knot) / RoadAxis::kKnotSpacing, 0.0, RoadAxis::kKnots - 1.0);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(place), RoadAxis::kKnots - 2);
  const double fraction = place - static_cast<double>(i);
  return (1 - fraction) * curvatures[i] + fraction * curvatures[i + 1];
}

Walked walk(const Curvatures& curvatures, double first_knot, double heading, double station) {
  constexpr int kPieces = 20000;
  const double step = station / kPieces;
  Walked walked{{0, 0}, -heading};
  for (int i = 0; i < kPieces; ++i) {
    const double turn = step * curvature_of(curvatures, first_knot, (i + 0.5) * step);
    walked.point +=
        step * Eigen::Vector2d(std::cos(walked.heading + turn / 2), std::sin(walked.heading + turn / 2));
    walked.heading += turn;
  }
  return walked;
}

TEST(RoadAxis, IsExactOnAStraightRoad) {
  RoadAxis axis;
  const double heading = 0.05;
  axis.rebuild(heading, constant(0), -10);
  for (double station = RoadAxis::kBegin; station <= RoadAxis::kEnd; station += 3.7) {
    const RoadAxis::Place place = axis.at(station);
    EXPECT_NEAR(place.point.x(), station * std::cos(heading), 1e-9);
    EXPECT_NEAR(place.point.y(), -station * std::sin(heading), 1e-9);
    EXPECT_NEAR(axis.heading_at(station), -heading, 1e-12);
    const RoadAxis::Foot foot = axis.project(place.point + 3.5 * place.normal());
    EXPECT_NEAR(foot.place.station, station, 1e-6);
    EXPECT_NEAR(foot.lateral, 3.5, 1e-9);
  }
}

class Arc : public ::testing::TestWithParam<double> {
 protected:
  void SetUp() override { axis_.rebuild(0, constant(1 / GetParam()), -13); }
  RoadAxis axis_;
};

TEST_P(Arc, IsTheCircle) {
  for (double station = RoadAxis::kBegin; station <= RoadAxis::kEnd; station += 1.1) {
    const double radius = GetParam();
    const double angle = station / radius;
    const RoadAxis::Place place = axis_.at(station);
    EXPECT_NEAR(place.point.x(), radius * std::sin(angle), 0.01) << station;
    EXPECT_NEAR(place.point.y(), radius * (1 - std::cos(angle)), 0.01) << station;
    EXPECT_NEAR(place.tangent.norm(), 1, 1e-12);
    EXPECT_NEAR(std::atan2(place.tangent.y(), place.tangent.x()), angle, 1e-6) << station;
    EXPECT_NEAR(axis_.heading_at(station), angle, 1e-9);
    EXPECT_NEAR(axis_.curvature_at(station), 1 / radius, 1e-12);
  }
}

TEST_P(Arc, GivesEachPointItsFoot) {
  for (double station = RoadAxis::kBegin + 5; station <= RoadAxis::kEnd - 5; station += 1.3) {
    const RoadAxis::Place place = axis_.at(station);
    for (const double lateral : {-9.0, -1.8, 0.0, 1.8, 9.0}) {
      const RoadAxis::Foot foot = axis_.project(place.point + lateral * place.normal());
      EXPECT_NEAR(foot.place.station, station, 0.02) << lateral;
      EXPECT_NEAR(foot.lateral, lateral, 2e-3) << station;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, Arc, ::testing::Values(250.0, -250.0, 700.0, -3000.0));

TEST(RoadAxis, FollowsAClothoid) {
  // Curvature that grows along the arc is met exactly between knots: from straight to a radius of 300 m.
  constexpr double kRate = 1.0 / 300 / 180;
  constexpr double kFirst = -12;
  Curvatures curvatures{};
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    curvatures[static_cast<std::size_t>(k)] = kRate * (kFirst + k * RoadAxis::kKnotSpacing);
  }
  RoadAxis axis;
  axis.rebuild(0, curvatures, kFirst);
  for (double station = 0; station <= 150; station += 12.5) {
    const Walked there = walk(curvatures, kFirst, 0, station);
    EXPECT_NEAR(axis.heading_at(station), kRate * station * station / 2, 2e-6) << station;
    EXPECT_LT((axis.at(station).point - there.point).norm(), 0.005) << station;
  }
}

TEST(RoadAxis, FollowsAnyCourse) {
  Random random(1, "course");
  for (int trial = 0; trial < 5; ++trial) {
    Curvatures curvatures{};
    for (double& curvature : curvatures) curvature = random.normal(1e-3);
    const double heading = random.normal(0.05);
    const double first = -random.uniform(0, RoadAxis::kKnotSpacing);
    RoadAxis axis;
    axis.rebuild(heading, curvatures, first);
    for (const double station : {-15.0, -3.0, 8.0, 41.0, 77.0, 120.0, 160.0}) {
      const Walked there = walk(curvatures, first, heading, station);
      EXPECT_LT((axis.at(station).point - there.point).norm(), 0.02) << station;
      EXPECT_NEAR(axis.heading_at(station), there.heading, 1e-3) << station;
    }
  }
}

/// A hat by its definition.
double hat(double centre, double spacing, double at) {
  return std::max(0.0, 1 - std::abs(at - centre) / spacing);
}

TEST(Hat, TurnAndLeverAreItsIntegralsFromTheCar) {
  for (const double spacing : {20.0, 40.0}) {
    for (const double centre : {-33.0, -7.0, 0.0, 12.0, 55.0, 140.0}) {
      for (const double station : {-18.0, -2.0, 0.0, 5.0, 47.0, 90.0, 160.0}) {
        constexpr int kPieces = 20000;
        const double step = station / kPieces;
        double turn = 0;
        double lever = 0;
        for (int i = 0; i < kPieces; ++i) {
          const double before = turn;
          turn += step * hat(centre, spacing, (i + 0.5) * step);
          lever += step * (before + turn) / 2;
        }
        EXPECT_NEAR(hat_turn(centre, spacing, station), turn, 1e-5) << centre << ' ' << station;
        EXPECT_NEAR(hat_lever(centre, spacing, station), lever, 1e-3) << centre << ' ' << station;
      }
    }
  }
}

TEST(RoadAxis, MovesByItsLevers) {
  const Curvatures curvatures = constant(2e-4);
  constexpr double kFirst = -11;
  RoadAxis axis;
  axis.rebuild(0.01, curvatures, kFirst);
  for (const double station : {10.0, 40.0, 90.0, 140.0}) {
    const RoadAxis::Place place = axis.at(station);
    for (int k = 1; k + 1 < RoadAxis::kKnots; ++k) {
      Curvatures more = curvatures;
      constexpr double kStep = 1e-5;
      more[static_cast<std::size_t>(k)] += kStep;
      RoadAxis moved;
      moved.rebuild(0.01, more, kFirst);
      const double aside = place.normal().dot(moved.at(station).point - place.point) / kStep;
      const double lever = axis.curvature_lever(k, station);
      EXPECT_NEAR(aside, lever, 1 + 0.02 * std::abs(lever)) << "knot " << k << " at " << station;
    }
    RoadAxis turned;
    turned.rebuild(0.01 + 1e-5, curvatures, kFirst);
    const double aside = place.normal().dot(turned.at(station).point - place.point) / 1e-5;
    EXPECT_NEAR(aside, -axis.heading_lever(place), 1e-2) << station;
  }
}

TEST(KnotWeights, InterpolateBetweenAndStayBeyond) {
  const KnotWeights between = knot_weights(15, -20, 20, 10);
  EXPECT_EQ(between.first, 1);
  EXPECT_DOUBLE_EQ(between.of_first, 0.25);
  EXPECT_DOUBLE_EQ(between.of_second, 0.75);
  const KnotWeights before = knot_weights(-100, -20, 20, 10);
  EXPECT_EQ(before.first, 0);
  EXPECT_DOUBLE_EQ(before.of_first, 1);
  const KnotWeights after = knot_weights(1000, -20, 20, 10);
  EXPECT_EQ(after.first, 8);
  EXPECT_DOUBLE_EQ(after.of_second, 1);
}

}  // namespace
}  // namespace lanefuse
