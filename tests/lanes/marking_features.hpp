// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/clothoid.hpp"
#include "core/feature.hpp"

namespace lanefuse::testing {

/// Where features of one marking stand.
struct Paint {
  double from = 2;
  double to = 80;
  double spacing = 2;
  double confidence = 0.8;
};

/// Exact features of the marking that runs `offset` to the left of `course`.
inline std::vector<Feature> features_of(const Clothoid& course, double offset, const Paint& paint = {}) {
  std::vector<Feature> features;
  for (double x = paint.from; x <= paint.to; x += paint.spacing) {
    Feature feature{x, course.y(x) + offset, course.heading_at(x), paint.confidence};
    feature.source = Source::high_resolution_camera;
    features.push_back(feature);
  }
  return features;
}

inline void append(std::vector<Feature>& features, const std::vector<Feature>& more) {
  features.insert(features.end(), more.begin(), more.end());
}

/// Several markings of one road.
inline std::vector<Feature> road_of(const Clothoid& course, const std::vector<double>& offsets,
                                    const Paint& paint = {}) {
  std::vector<Feature> features;
  for (const double offset : offsets) append(features, features_of(course, offset, paint));
  return features;
}

/// The same features with noise on y and on the heading.
inline std::vector<Feature> shaken(std::vector<Feature> features, double y_sigma, double heading_sigma,
                                   unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (Feature& feature : features) {
    feature.y += y_sigma * normal(random);
    feature.heading += heading_sigma * normal(random);
  }
  return features;
}

/// How far two courses part within `range`, at most.
inline double parting(const Clothoid& a, const Clothoid& b, double range = 100) {
  double worst = 0;
  for (double x = 0; x <= range; x += 5) {
    worst = std::max(worst, std::abs((a.y(x) - a.y(0)) - (b.y(x) - b.y(0))));
  }
  return worst;
}

}  // namespace lanefuse::testing
