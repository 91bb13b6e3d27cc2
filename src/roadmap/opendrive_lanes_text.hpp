// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "roadmap/group_layout.hpp"

namespace lanefuse {

/// The <lanes> element of a road: offset, sections, lanes with width, paint and links. Throws, naming
/// `place`, where lanes overlap or follow one another at different places.
std::string opendrive_lanes_text(const RoadMap& map, const GroupLayout& layout, const std::string& place);

}  // namespace lanefuse
