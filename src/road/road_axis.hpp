// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace lanefuse {

/// Linear interpolation between knots that stand `spacing` apart, the first at `begin`; constant beyond the
/// ends.
struct KnotWeights {
  int first = 0;  ///< and the one after it
  double of_first = 1;
  double of_second = 0;
};
KnotWeights knot_weights(double at, double begin, double spacing, int count);

/// How much a knot's hat function of width `spacing`, which stands at `centre`, comes to at `station` when it
/// is integrated from the car, once: a curvature's turn; and twice: its lever, how far it moves the curve
/// aside.
double hat_turn(double centre, double spacing, double station);
double hat_lever(double centre, double spacing, double station);

/// The road's axis: the curve through the car's origin that runs along the road, given by its curvature along
/// the arc. Being followed by arc length, it holds in bends in which no cubic over x does.
class RoadAxis {
 public:
  static constexpr int kKnots = 10;
  static constexpr double kKnotSpacing = 20;  ///< [m]
  static constexpr double kBegin = -20;       ///< [m] of arc: the axis is known from here
  static constexpr double kEnd = 165;         ///< [m] to here

  /// A place on the axis, in the vehicle frame.
  struct Place {
    double station = 0;  ///< [m] of arc from the car
    Eigen::Vector2d point;
    Eigen::Vector2d tangent;
    [[nodiscard]] Eigen::Vector2d normal() const { return {-tangent.y(), tangent.x()}; }
  };
  /// A point beside the axis.
  struct Foot {
    Place place;
    double lateral = 0;  ///< [m] left of the axis
  };

  /// `heading` [rad] of the car along the axis; `curvatures` [1/m] at the knots, of which the first stands at
  /// `first_knot` [m] of arc from the car.
  void rebuild(double heading, std::span<const double> curvatures, double first_knot);

  [[nodiscard]] Place at(double station) const;
  [[nodiscard]] double heading_at(double station) const;
  [[nodiscard]] double curvature_at(double station) const;
  /// The axis' place nearest to a point of the vehicle frame.
  [[nodiscard]] Foot project(const Eigen::Vector2d& point) const;

  /// How far the axis moves to its left at `station` when the curvature at that knot grows by one.
  [[nodiscard]] double curvature_lever(int knot, double station) const {
    return hat_lever(first_knot_ + knot * kKnotSpacing, kKnotSpacing, station);
  }
  /// How far it moves to the right when the car's heading along it grows by one radian.
  [[nodiscard]] double heading_lever(const Place& place) const { return place.point.dot(place.tangent); }

 private:
  static constexpr double kStep = 2.5;
  static constexpr int kSteps = static_cast<int>((kEnd - kBegin) / kStep) + 1;
  static constexpr int kOrigin = static_cast<int>(-kBegin / kStep);

  struct Sample {
    double x = 0;
    double y = 0;
    double heading = 0;
    double curvature = 0;
  };
  [[nodiscard]] double knot_curvature(double station) const;

  std::array<double, kKnots> curvatures_{};
  double first_knot_ = 0;
  std::array<Sample, kSteps> samples_{};
};

}  // namespace lanefuse
