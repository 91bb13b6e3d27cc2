// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roadmap/station_series.hpp"
#include "roadmap/survey_axis.hpp"
#include "roadmap/survey_drive.hpp"

namespace lanefuse {

/// How often a marking was called what, at one station.
struct MarkingVotes {
  std::array<std::uint32_t, 5> types{};    ///< by MarkingType
  std::array<std::uint32_t, 3> colours{};  ///< by MarkingColour
  void add(const MarkingEvidence& marking);
  MarkingVotes& operator+=(const MarkingVotes& other);
  [[nodiscard]] MarkingEvidence winner() const;
};

/// One line of paint as one drive saw it, without a jump: what it was on this side of the car, until the car
/// left its lane.
struct SurveyTrace {
  std::size_t drive = 0;
  Side side = Side::none;
  double paint_width = 0;  ///< [m]; 0: not measured, and the trace follows the paint's inner edge
  StationSeries lateral;   ///< [m] beside the axis
  std::vector<MarkingVotes> votes;
};

/// What of a drive its traces are made of.
struct TraceInput {
  const SurveyedDrive& drive;
  std::size_t index = 0;  ///< of the drive
  const SurveyAxis& axis;
  const StationSeries& yaw;  ///< [rad] of the drive's camera, to be taken off; 0 where it is not known
};

/// The traces of a drive that are at least `shortest` stations long.
std::vector<SurveyTrace> traces_of(const TraceInput& input, std::size_t shortest);

}  // namespace lanefuse
