// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/feature.hpp"
#include "drawing/svg.hpp"

namespace lanefuse {

/// The looks of all figures as CSS: one rule a class, with a second set of colours for dark surroundings.
/// Hues are told apart by people who do not see red or green, and never alone: shapes and dashes differ too.
std::string figure_css();

enum class Marker { circle, square, triangle, diamond, cross, bar };

struct SourceStyle {
  Marker marker;
  std::string_view css;
  std::string_view label;
};
SourceStyle style_of(Source source);

/// `size` is about the marker's half width [px].
void draw_marker(SvgWriter& svg, Marker marker, const Pixel& at, double size, std::string_view css);

}  // namespace lanefuse
