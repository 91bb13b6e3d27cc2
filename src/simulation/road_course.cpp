// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanefuse {
namespace {

constexpr double kStraightShare = 0.25;     ///< of the transitions lead into a straight instead of an S-curve
constexpr Range kStraightLength{200, 800};  ///< [m]
constexpr Range kArcLength{250, 900};       ///< [m]
constexpr Range kParameterByRadius{1.0 / 3,
                                   0.5};  ///< A/R of the transitions; sharp end of the rules' [1/3, 1]
constexpr double kTurnLimit = 0.6;        ///< [rad] of one arc
constexpr double kHeadingLimit = 0.6;     ///< [rad] from here on the next arc bends back

/// Appends elements so that curvature and heading never jump.
class CourseBuilder {
 public:
  void straight(double length) { append({std::round(length), curvature_, 0}); }
  void arc(double length) { straight(length); }
  void transition(double length, double to_curvature) {
    const double whole = std::max(1.0, std::round(length));
    append({whole, curvature_, (to_curvature - curvature_) / whole});
    curvature_ = to_curvature;
  }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double heading() const { return heading_; }
  std::vector<RoadElement> take() { return std::move(elements_); }

 private:
  std::vector<RoadElement> elements_;
  double length_ = 0;
  double heading_ = 0;
  double curvature_ = 0;

  void append(const RoadElement& element) {
    elements_.push_back(element);
    length_ += element.length;
    heading_ += element.length * (element.curvature + element.length * element.curvature_rate / 2);
  }
};

double draw_radius(Range radius, Random& random) {
  return std::exp(random.uniform(std::log(radius.low), std::log(radius.high)));
}

double draw_direction(double heading, Random& random) {
  if (std::abs(heading) > kHeadingLimit) return heading > 0 ? -1 : 1;
  return random.chance(0.5) ? 1 : -1;
}

double draw_transition_length(double radius, Random& random) {
  const double parameter = radius * random.uniform(kParameterByRadius.low, kParameterByRadius.high);
  return parameter * parameter / radius;
}

}  // namespace

std::vector<RoadElement> draw_road_course(Range radius, double length, Random& random) {
  CourseBuilder course;
  course.straight(random.uniform(kStraightLength.low, kStraightLength.high));
  while (course.length() < length) {
    const double r = draw_radius(radius, random);
    const double in_out = draw_transition_length(r, random);
    course.transition(in_out, draw_direction(course.heading(), random) / r);
    course.arc(std::min(kTurnLimit * r, random.uniform(kArcLength.low, kArcLength.high)));
    course.transition(in_out, 0);
    if (random.chance(kStraightShare))
      course.straight(random.uniform(kStraightLength.low, kStraightLength.high));
  }
  return course.take();
}

}  // namespace lanefuse
