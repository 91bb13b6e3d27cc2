// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/image.hpp"

namespace lanefuse {

struct StillMaskConfig {
  int row_step = 8;          ///< [px] between the rows that are learned
  double first_row = 0.33;   ///< share of the height above which nothing is learned
  double spacing = 2;        ///< [m] that the car moves between two looks
  int looks = 32;            ///< that a row is remembered for, and must have had
  double contrast_min = 6;   ///< [grey levels] of an edge
  double steadiness = 0.85;  ///< of an edge: what is left of its gradient after averaging, of 1
};

/// What never moves in the image while the car does is no road: the bonnet, dirt, reflections in the
/// windscreen. Remembers, pixel by pixel, how steady gradients are. A solid line holds no gradient in place
/// for long: the car's pitch and its way within the lane move it by more than a pixel or two.
class StillMask {
 public:
  StillMask(int width, int height, const StillMaskConfig& config = {});

  /// Looks at a quarter of the learned rows each time that the car has moved far enough.
  void learn(const ImageView& image, double distance_moved);

  /// Whether a bright bar with these edges [px] has been at the very same place for long.
  [[nodiscard]] bool is_still(int row, double left, double right) const;

  void reset();

 private:
  StillMaskConfig config_;
  int width_;
  int first_row_;
  double moved_ = 0;
  int phase_ = 0;
  std::vector<std::int16_t> mean_;  ///< of the gradient, in parts of a grey level
  std::vector<std::int16_t> size_;  ///< of its size
  std::vector<int> looks_;          ///< by row

  void learn_row(const ImageView& image, std::size_t index);
  [[nodiscard]] bool holds_edge(std::size_t index, double column, int sign) const;
};

}  // namespace lanefuse
