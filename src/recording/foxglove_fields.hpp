// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <google/protobuf/timestamp.pb.h>

#include "core/time.hpp"
#include "foxglove/geometry.pb.h"

namespace lanefuse {

/// Private to this folder: the parts that several Foxglove messages hold.

/// The name of the vehicle frame in every message for viewers.
inline constexpr char kVehicleFrame[] = "vehicle";

void put(Time time, google::protobuf::Timestamp& message);

struct Rgba {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;
};
void put(const Rgba& colour, foxglove::Color& message);

/// A pose on the road plane.
void put_pose(double x, double y, double heading, foxglove::Pose& message);

}  // namespace lanefuse
