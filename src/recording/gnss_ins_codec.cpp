// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/gnss_ins_codec.hpp"

#include <numbers>

#include "foxglove/location_fix.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Matrix3d take_position_covariance(const foxglove::LocationFix& message) {
  if (message.position_covariance_size() != 9) refuse(message.GetTypeName(), "its covariance is not 3 x 3");
  Eigen::Matrix3d covariance;
  for (int i = 0; i < 9; ++i) covariance(i / 3, i % 3) = message.position_covariance(i);
  return covariance;
}

}  // namespace

mcap::Bytes encode_gnss_ins(const GnssInsFix& fix) {
  foxglove::LocationFix message;
  put(fix.stamp.measured_at, *message.mutable_timestamp());
  message.set_latitude(fix.latitude / kDegree);
  message.set_longitude(fix.longitude / kDegree);
  message.set_altitude(fix.height);
  for (int i = 0; i < 9; ++i) message.add_position_covariance(fix.position_covariance(i / 3, i % 3));
  message.set_position_covariance_type(foxglove::LocationFix::KNOWN);
  v1::InsState& ins = *message.mutable_lanefuse_ins();
  ins.set_heading(fix.heading);
  ins.set_heading_sigma(fix.heading_sigma);
  ins.set_fix_kind(static_cast<v1::InsState::FixKind>(fix.kind));
  return to_bytes(message);
}

GnssInsFix decode_gnss_ins(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<foxglove::LocationFix>(bytes);
  if (!message.has_lanefuse_ins()) refuse(message.GetTypeName(), "it has no heading (lanefuse_ins)");
  const v1::InsState& ins = message.lanefuse_ins();
  if (!v1::InsState::FixKind_IsValid(ins.fix_kind())) {
    refuse(message.GetTypeName(), "its kind of fix is unknown");
  }
  return {.stamp = stamp,
          .latitude = message.latitude() * kDegree,
          .longitude = message.longitude() * kDegree,
          .height = message.altitude(),
          .heading = ins.heading(),
          .position_covariance = take_position_covariance(message),
          .heading_sigma = ins.heading_sigma(),
          .kind = static_cast<FixKind>(ins.fix_kind())};
}

}  // namespace lanefuse
