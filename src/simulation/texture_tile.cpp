// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/texture_tile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/random.hpp"

namespace lanefuse {
namespace {

int power_of(int two_to_the) {
  int power = 0;
  while (1 << power < two_to_the) ++power;
  return power;
}

/// Averages pairs of neighbours: `stride` apart, in `count` pairs a line.
std::vector<float> halved_along(const std::vector<float>& values, int along, int across) {
  std::vector<float> half(static_cast<std::size_t>(along / 2) * across);
  for (int i = 0; i < along / 2; ++i) {
    for (int j = 0; j < across; ++j) {
      half[i * across + j] = (values[2 * i * across + j] + values[(2 * i + 1) * across + j]) / 2;
    }
  }
  return half;
}

std::vector<float> halved_across(const std::vector<float>& values, int along, int across) {
  std::vector<float> half(static_cast<std::size_t>(along) * (across / 2));
  for (std::size_t i = 0; i < half.size(); ++i) half[i] = (values[2 * i] + values[2 * i + 1]) / 2;
  return half;
}

void normalise(std::vector<float>& values) {
  double sum = 0, squares = 0;
  for (const float value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const float value : values) squares += (value - mean) * (value - mean);
  const double sigma = std::sqrt(squares / static_cast<double>(values.size()));
  for (float& value : values) value = static_cast<float>((value - mean) / sigma);
}

}  // namespace

TextureTile::TextureTile(const Shape& shape, const std::vector<Octave>& octaves, std::uint64_t seed,
                         std::string_view stream)
    : shape_(shape), along_levels_(power_of(shape.along) + 1), across_levels_(power_of(shape.across) + 1) {
  Random random(seed, stream);
  std::vector<float> values(static_cast<std::size_t>(shape.along) * shape.across);
  for (const Octave& octave : octaves) add_octave(octave, values, random);
  normalise(values);
  average(values);
}

/// Noise at every so many texels, smooth in between.
void TextureTile::add_octave(const Octave& octave, std::vector<float>& values, Random& random) const {
  const int rows = shape_.along / octave.texels;
  const int columns = shape_.across / octave.texels;
  std::vector<float> coarse(static_cast<std::size_t>(rows) * columns);
  for (float& value : coarse) value = octave.weight * static_cast<float>(random.uniform(-1, 1));
  const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
  for (int i = 0; i < shape_.along; ++i) {
    const int i0 = i / octave.texels;
    const int i1 = (i0 + 1) % rows;
    const float a = smooth(static_cast<float>(i % octave.texels) / static_cast<float>(octave.texels));
    for (int j = 0; j < shape_.across; ++j) {
      const int j0 = j / octave.texels;
      const int j1 = (j0 + 1) % columns;
      const float c = smooth(static_cast<float>(j % octave.texels) / static_cast<float>(octave.texels));
      const float low = coarse[i0 * columns + j0] * (1 - c) + coarse[i0 * columns + j1] * c;
      const float high = coarse[i1 * columns + j0] * (1 - c) + coarse[i1 * columns + j1] * c;
      values[i * shape_.across + j] += low * (1 - a) + high * a;
    }
  }
}

void TextureTile::average(const std::vector<float>& values) {
  std::vector<float> across_mean = values;
  for (int c = 0; c < across_levels_; ++c) {
    const int across = shape_.across >> c;
    if (c > 0) across_mean = halved_across(across_mean, shape_.along, across * 2);
    std::vector<float> mean = across_mean;
    for (int a = 0; a < along_levels_; ++a) {
      if (a > 0) mean = halved_along(mean, shape_.along >> (a - 1), across);
      std::vector<std::int16_t> stored(mean.size());
      std::transform(mean.begin(), mean.end(), stored.begin(), [](float value) {
        return static_cast<std::int16_t>(std::floor(std::clamp(value, -7.9F, 7.9F) * 4096 + 0.5F));
      });
      levels_.push_back(std::move(stored));
    }
  }
}

TextureTile::Level TextureTile::level(double along, double across) const {
  const auto power = [this](double size, int levels) {
    return std::clamp(static_cast<int>(std::lround(std::log2(std::max(size, 1e-6) / shape_.texel))), 0,
                      levels - 1);
  };
  const int a = power(along, along_levels_);
  const int c = power(across, across_levels_);
  Level level;
  level.data_ = levels_[static_cast<std::size_t>(c * along_levels_ + a)].data();
  level.along_mask_ = (shape_.along >> a) - 1;
  level.across_mask_ = (shape_.across >> c) - 1;
  level.along_scale_ = 1 / (shape_.texel * (1 << a));
  level.across_scale_ = 1 / (shape_.texel * (1 << c));
  return level;
}

}  // namespace lanefuse
