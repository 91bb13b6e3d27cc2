// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/foxglove_fields.hpp"

#include <cmath>

namespace lanefuse {

void put(Time time, google::protobuf::Timestamp& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time.time_since_epoch());
  message.set_seconds(seconds.count());
  message.set_nanos(static_cast<std::int32_t>((time.time_since_epoch() - seconds).count()));
}

void put(const Rgba& colour, foxglove::Color& message) {
  message.set_r(colour.red);
  message.set_g(colour.green);
  message.set_b(colour.blue);
  message.set_a(colour.alpha);
}

void put_pose(double x, double y, double heading, foxglove::Pose& message) {
  message.mutable_position()->set_x(x);
  message.mutable_position()->set_y(y);
  message.mutable_orientation()->set_z(std::sin(heading / 2));
  message.mutable_orientation()->set_w(std::cos(heading / 2));
}

}  // namespace lanefuse
