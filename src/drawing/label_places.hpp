// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "drawing/svg.hpp"

namespace lanefuse {

/// Finds room for labels beside lines, so that they hide no other label and as little as can be of the lines.
class LabelPlaces {
 public:
  explicit LabelPlaces(const Box& frame) : frame_(frame) {}

  /// Where lines are: labels had better not lie there.
  void occupy(const std::vector<Pixel>& line);

  /// A place above or below one of the line's points, where `text` as a tick fits; it is taken from then on.
  /// Nothing where all are.
  std::optional<Box> beside(const std::vector<Pixel>& line, std::string_view text);

 private:
  Box frame_;
  std::vector<Pixel> lines_;
  std::vector<Box> labels_;

  [[nodiscard]] std::optional<std::size_t> cost(const Box& place) const;
};

}  // namespace lanefuse
