// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "roadmap/commonroad.hpp"
#include "roadmap/xml_element.hpp"

namespace lanefuse {

/// The dynamic obstacles with a trajectory of a CommonRoad file, of either version; `time_step` in seconds.
std::vector<RecordedVehicle> read_commonroad_vehicles(const XmlElement& root, double time_step);

}  // namespace lanefuse
