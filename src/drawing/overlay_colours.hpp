// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drawing/canvas.hpp"

/// The colours of overlays: told apart by people who do not see red or green (after Okabe and Ito), and never
/// alone, as shapes and dashes differ too. One colour has one meaning in the image and in the view from
/// above.
namespace lanefuse::overlay_colour {

inline constexpr Colour kPage{20, 24, 31};
inline constexpr Colour kGrid{48, 56, 67};
inline constexpr Colour kText{228, 231, 235};
inline constexpr Colour kMuted{154, 165, 180};
inline constexpr Colour kBoundary{47, 219, 165};        ///< bluish green
inline constexpr Colour kTruth{255, 106, 193};          ///< pink; always dashed
inline constexpr Colour kHighResolution{240, 150, 10};  ///< orange: bars of paint and their features
inline constexpr Colour kSerial{86, 190, 245};          ///< sky blue: search windows and their features
inline constexpr Colour kVehicle{240, 228, 66};         ///< yellow: boxes, and what vehicles bear witness of
inline constexpr Colour kOther{203, 210, 217};          ///< the own path, and what has no colour of its own
inline constexpr Colour kAlarm{255, 125, 70};

}  // namespace lanefuse::overlay_colour
