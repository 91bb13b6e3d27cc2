// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace lanefuse {

/// Weather and light of rendered images.
enum class ImageConditions : std::uint8_t {
  clear = 0,    ///< high sun, dry road
  low_sun = 1,  ///< sun near the horizon ahead: glare, long shadows, little contrast
  wet = 2,      ///< overcast; the dark road mirrors the sky
  night = 3,    ///< own headlights, 60-70 m
};
inline constexpr std::array kAllImageConditions{ImageConditions::clear, ImageConditions::low_sun,
                                                ImageConditions::wet, ImageConditions::night};
/// "clear", "low-sun", "wet", "night".
const char* to_string(ImageConditions conditions);
std::optional<ImageConditions> image_conditions(std::string_view word);

}  // namespace lanefuse
