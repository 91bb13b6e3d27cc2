// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace lanefuse {

/// Something that lies along a simulated road, once or again and again.
struct RoadEvent {
  enum class Kind : std::uint8_t {
    exit = 0,           ///< a lane that opens on the right and leaves the road
    entry = 1,          ///< a lane that joins the road from the right and ends
    lane_drop = 2,      ///< one more lane on the right, which ends: four become three
    construction = 3,   ///< narrowed, shifted lanes between yellow lines, with the old white ones still there
    missing_paint = 4,  ///< stretches without paint
    rail_ghosts = 5,    ///< guard rails that look like paint
  };
  /// Of which lines the paint is missing.
  enum class Lines : std::uint8_t {
    all = 0,
    right_of_ego = 1,  ///< the right line of the middle lane, where the ego car starts, and all beyond it
  };

  Kind kind = Kind::exit;
  double first = 600;                 ///< [m] from the start of the drive to where it begins
  double every = 0;                   ///< [m] from one beginning to the next; 0: there is only one
  double length = 0;                  ///< [m]; 0: as usual, for missing paint to the end of the road
  double share = 1;                   ///< of the length that has no paint, in (0, 1]; only for missing paint
  Lines lines = Lines::all;           ///< only for missing paint
  std::string place = "road events";  ///< where it was asked for, for errors
};
const char* to_string(RoadEvent::Kind kind);

/// [m] of the road that one event takes, `length` being what was asked for or 0.
double usual_length(RoadEvent::Kind kind);

}  // namespace lanefuse
