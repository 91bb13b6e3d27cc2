// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/clothoid.hpp"
#include "core/feature.hpp"
#include "lanefuse/clothoid.pb.h"
#include "lanefuse/feature.pb.h"
#include "recording/message_bytes.hpp"

namespace lanefuse {

/// Private to this folder: the types of core, which several messages hold, as parts of messages. What has no
/// counterpart (an enumerator of a later version, a covariance of the wrong length) is refused with an Error
/// (input).

void put(const Clothoid& clothoid, v1::Clothoid& message);
Clothoid take(const v1::Clothoid& message);

void put(const MarkingEvidence& marking, v1::Marking& message);
MarkingEvidence take(const v1::Marking& message);

void put(const Feature& feature, v1::Feature& message);
Feature take(const v1::Feature& message);

Side take_side(v1::Side side);

using Numbers = google::protobuf::RepeatedField<double>;

/// A symmetric matrix as its upper triangle, row by row. The lower triangle is not looked at.
template <int N>
void put_covariance(const Eigen::Matrix<double, N, N>& covariance, Numbers& triangle) {
  triangle.Clear();
  for (int row = 0; row < N; ++row) {
    for (int column = row; column < N; ++column) triangle.Add(covariance(row, column));
  }
}

template <int N>
Eigen::Matrix<double, N, N> take_covariance(const Numbers& triangle, const std::string& type) {
  if (triangle.size() != N * (N + 1) / 2) refuse(type, "its covariance is no upper triangle");
  Eigen::Matrix<double, N, N> covariance;
  int i = 0;
  for (int row = 0; row < N; ++row) {
    for (int column = row; column < N; ++column) {
      covariance(row, column) = covariance(column, row) = triangle[i++];
    }
  }
  return covariance;
}

}  // namespace lanefuse
