// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mounting_fields.hpp"

#include "recording/message_bytes.hpp"

namespace lanefuse {

void put(const Mounting& mounting, v1::Mounting& message) {
  message.set_x(mounting.x);
  message.set_y(mounting.y);
  message.set_z(mounting.z);
  message.set_roll(mounting.roll);
  message.set_pitch(mounting.pitch);
  message.set_yaw(mounting.yaw);
}

Mounting take(const v1::Mounting& message) {
  for (const double number :
       {message.x(), message.y(), message.z(), message.roll(), message.pitch(), message.yaw()}) {
    finite(number, message.GetTypeName());
  }
  return {message.x(), message.y(), message.z(), message.roll(), message.pitch(), message.yaw()};
}

}  // namespace lanefuse
