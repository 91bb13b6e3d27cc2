// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/feature.hpp"
#include "core/time.hpp"
#include "osi3/osi_common.pb.h"
#include "osi3/osi_lane.pb.h"

namespace lanefuse {

/// Private to this folder: the parts that several OSI messages hold.

void put_osi_version(osi3::InterfaceVersion& version);
void put(Time time, osi3::Timestamp& message);

/// A point of the plane; z stays absent.
void put(double x, double y, osi3::Vector3d& message);

/// OSI knows more types and colours than Lanefuse: those that have no counterpart come back as unknown.
void put(const MarkingEvidence& marking, osi3::LaneBoundary::Classification& message);
MarkingEvidence take(const osi3::LaneBoundary::Classification& message);

/// OSI's identifiers have no sign: throws Error (input) for a negative one.
std::uint64_t osi_identifier(std::int64_t id);

}  // namespace lanefuse
