// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/settings_section.hpp"
#include "sources/object_source.hpp"

namespace lanefuse {

/// The settings of when radars and object cameras are believed.
void add_trust_settings(const Section& s, SensorTrustConfig& c);

/// The settings of what is learned of radars' mountings.
void add_alignment_settings(const Section& s, RadarAlignmentConfig& c);

}  // namespace lanefuse
