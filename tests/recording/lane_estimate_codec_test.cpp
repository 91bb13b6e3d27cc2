// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/lane_estimate_codec.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "lanefuse/lane_estimate.pb.h"
#include "random_recording.hpp"
#include "recording/debug_view_codec.hpp"

namespace lanefuse {
namespace {

mcap::Bytes bytes_of(const v1::LaneEstimate& message) {
  mcap::Bytes bytes(message.ByteSizeLong());
  EXPECT_TRUE(message.SerializeToArray(bytes.data(), static_cast<int>(bytes.size())));
  return bytes;
}

RC_GTEST_PROP(LaneEstimateCodec, EstimateComesBackExactly, ()) {
  const LaneEstimate estimate = testing::random_estimate();
  RC_ASSERT(fields(decode_lane_estimate(encode_lane_estimate(estimate), estimate.time)) == fields(estimate));
}

RC_GTEST_PROP(LaneEstimateCodec, DebugViewComesBackExactly, ()) {
  const DebugView view = testing::random_debug_view();
  DebugView back = testing::random_debug_view();
  decode_fused_features(encode_fused_features(view), back);
  decode_switches(encode_switches(view), back);
  decode_road_course(encode_road_course(view), back);
  RC_ASSERT(fields(back) == fields(view));
}

TEST(LaneEstimateCodec, BoundaryThatIsNotFiniteIsRefused) {
  LaneEstimate estimate;
  estimate.boundaries.resize(1);
  estimate.boundaries[0].covariance(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(decode_lane_estimate(encode_lane_estimate(estimate), Time{}), Error);
}

TEST(LaneEstimateCodec, WhatALaterVersionMayAddIsRefusedByName) {
  v1::LaneEstimate message;
  message.set_reason(static_cast<v1::StatusReason>(99));
  try {
    decode_lane_estimate(bytes_of(message), Time{});
    FAIL() << "an unknown reason was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("reason"), std::string::npos) << error.what();
  }
}

TEST(LaneEstimateCodec, WhatOldFilesDoNotSayIsNotThere) {
  v1::LaneEstimate message;
  message.add_lanes()->set_id(7);
  v1::Boundary& boundary = *message.add_boundaries();
  for (int i = 0; i < 10; ++i) boundary.add_covariance(0);
  boundary.add_points()->set_x(4);
  const LaneEstimate estimate = decode_lane_estimate(bytes_of(message), Time{});
  EXPECT_EQ(estimate.boundaries.at(0).points.at(0).protection, 0);
  EXPECT_EQ(estimate.lanes.at(0).id, 7U);
  EXPECT_TRUE(estimate.lanes.at(0).centre.empty());
  EXPECT_EQ(estimate.lanes.at(0).availability, 0);
}

TEST(LaneEstimateCodec, LaneThatIsNotFiniteIsRefused) {
  LaneEstimate estimate;
  estimate.lanes.resize(1);
  estimate.lanes[0].centre.push_back({0, 0, 0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_THROW(decode_lane_estimate(encode_lane_estimate(estimate), Time{}), Error);
}

TEST(LaneEstimateCodec, CovarianceOfTheWrongLengthIsRefused) {
  v1::LaneEstimate message;
  message.add_boundaries()->add_covariance(1);
  EXPECT_THROW(decode_lane_estimate(bytes_of(message), Time{}), Error);
}

TEST(LaneEstimateCodec, SourcesThatAFileDoesNotKnowAreUnavailable) {
  const LaneEstimate estimate = decode_lane_estimate({}, Time{});
  for (const SourceStatus status : estimate.sources) EXPECT_EQ(status, SourceStatus::unavailable);
}

}  // namespace
}  // namespace lanefuse
