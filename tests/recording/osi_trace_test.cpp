// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include <google/protobuf/empty.pb.h>
#include <google/protobuf/message.h>
#include <google/protobuf/unknown_field_set.h>
#include <gtest/gtest.h>

#include "osi3/osi_groundtruth.pb.h"
#include "support/files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

/// The ground truths of a .osi trace of SensorViews: four bytes of length (little endian) before each
/// message, and in each the ground truth as field 7.
std::vector<osi3::GroundTruth> ground_truths(const std::vector<std::byte>& trace) {
  std::vector<osi3::GroundTruth> truths;
  for (std::size_t place = 0; place + 4 <= trace.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, &trace[place], 4);
    google::protobuf::Empty view;
    EXPECT_TRUE(view.ParseFromArray(&trace[place + 4], static_cast<int>(size)));
    const auto& fields = view.GetReflection()->GetUnknownFields(view);
    for (int i = 0; i < fields.field_count(); ++i) {
      const auto& field = fields.field(i);
      if (field.number() != 7) continue;
      EXPECT_TRUE(truths.emplace_back().ParseFromString(field.length_delimited()));
    }
    place += 4 + size;
  }
  return truths;
}

TEST(OsiTrace, AnotherToolsGroundTruthReadsByOurDefinitions) {
  const auto path = testing::real_data("osi/example_sv_trace.osi");
  LANEFUSE_NEEDS_DATA(path);
  const auto truths = ground_truths(testing::read_file(path));
  EXPECT_EQ(truths.size(), 547u);
  for (const osi3::GroundTruth& truth : truths) {
    EXPECT_EQ(truth.version().version_major(), 3u);
    const auto& objects = truth.moving_object();
    const auto is_host = [&](const auto& object) {
      return object.id().value() == truth.host_vehicle_id().value();
    };
    EXPECT_EQ(std::count_if(objects.begin(), objects.end(), is_host), 1);
    for (const osi3::MovingObject& object : objects) {
      EXPECT_EQ(object.type(), osi3::MovingObject::TYPE_VEHICLE);
      EXPECT_NEAR(object.base().dimension().length(), 5, 1);
      EXPECT_NEAR(object.base().position().z(), object.base().dimension().height() / 2, 1e-6);
      EXPECT_LE(std::abs(object.base().orientation().yaw()), 3.2);
    }
  }
}

}  // namespace
}  // namespace lanefuse
