// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "roadmap/opendrive.hpp"
#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {

PlanView exact_plan_view(const ExactPlan& plan);

/// A smooth line near the longest of the boundaries, long enough that all of them begin and end beside it.
/// Throws, naming `place`, where none runs along the whole road.
PlanView smooth_plan_view(const std::vector<const MapBoundary*>& boundaries, const std::string& place);

/// The <planView> element.
std::string plan_view_text(const PlanView& plan);

}  // namespace lanefuse
