// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "roadmap/road_map.hpp"
#include "roadmap/survey_drive.hpp"

namespace lanefuse {

/// Where on Earth a survey that begins with this drive has its origin: the drive's own, else its first fix.
/// Throws Error (input) where there is neither.
GeoOrigin survey_origin(const std::filesystem::path& drive);

/// Reads a drive and keeps what a survey needs. Throws Error (input) where it is damaged or holds too little.
SurveyedDrive read_surveyed(const std::filesystem::path& drive, const GeoOrigin& origin);

/// The exact road of a drive as a map. Throws Error (input) where the drive has none.
RoadMap exact_map(const std::filesystem::path& drive);

/// A map file, or the exact road of a drive (.mcap).
RoadMap read_map_or_exact(const std::filesystem::path& path);

}  // namespace lanefuse
