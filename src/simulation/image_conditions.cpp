// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_conditions.hpp"

namespace lanefuse {

const char* to_string(ImageConditions conditions) {
  switch (conditions) {
    case ImageConditions::clear:
      return "clear";
    case ImageConditions::low_sun:
      return "low-sun";
    case ImageConditions::wet:
      return "wet";
    case ImageConditions::night:
      return "night";
  }
  return "?";
}

std::optional<ImageConditions> image_conditions(std::string_view word) {
  for (const ImageConditions conditions : kAllImageConditions) {
    if (word == to_string(conditions)) return conditions;
  }
  return {};
}

}  // namespace lanefuse
