// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace lanefuse {

/// A piece of noise of mean 0 and sigma 1 that repeats along and across the road, with copies of itself that
/// are averaged along and across by powers of two, so that what one pixel covers is one look-up.
class TextureTile {
 public:
  struct Shape {
    int along = 512;      ///< texels, a power of two
    int across = 256;     ///< texels, a power of two
    double texel = 0.02;  ///< [m]
  };
  /// How much of the noise is of which size.
  struct Octave {
    int texels = 1;  ///< a power of two
    float weight = 1;
  };
  TextureTile(const Shape& shape, const std::vector<Octave>& octaves, std::uint64_t seed,
              std::string_view stream);

  /// A copy that is averaged to fit pixels of a size.
  class Level {
   public:
    /// `along` and `across` [m] on the road.
    [[nodiscard]] float at(double along, double across) const {
      return read(fixed(along * along_scale_), fixed(across * across_scale_));
    }
    /// The same at `count` places, the first at (along, across) and each one step further.
    struct Run {
      double along = 0;        ///< [m]
      double across = 0;       ///< [m]
      double along_step = 0;   ///< [m]
      double across_step = 0;  ///< [m]
    };
    void read_run(const Run& run, int count, float* values) const {
      std::int64_t a = fixed(run.along * along_scale_);
      std::int64_t c = fixed(run.across * across_scale_);
      const std::int64_t along_step = fixed(run.along_step * along_scale_);
      const std::int64_t across_step = fixed(run.across_step * across_scale_);
      for (int i = 0; i < count; ++i, a += along_step, c += across_step) values[i] = read(a, c);
    }

   private:
    friend class TextureTile;
    static constexpr int kFraction = 16;  ///< bits of a place's fraction
    static constexpr float kUnit = 1.0F / 4096;
    const std::int16_t* data_ = nullptr;
    std::int64_t along_mask_ = 0;
    std::int64_t across_mask_ = 0;
    double along_scale_ = 0;
    double across_scale_ = 0;

    static std::int64_t fixed(double texels) {
      return static_cast<std::int64_t>(std::floor(texels * (1 << kFraction)));
    }
    [[nodiscard]] float read(std::int64_t a, std::int64_t c) const {
      constexpr std::int64_t kMask = (1 << kFraction) - 1;
      constexpr float kStep = 1.0F / (1 << kFraction);
      const std::int64_t i = a >> kFraction;
      const std::int64_t j = c >> kFraction;
      const float fa = kStep * static_cast<float>(static_cast<std::int32_t>(a & kMask));
      const float fc = kStep * static_cast<float>(static_cast<std::int32_t>(c & kMask));
      const std::int16_t* low = data_ + (i & along_mask_) * (across_mask_ + 1);
      const std::int16_t* high = data_ + ((i + 1) & along_mask_) * (across_mask_ + 1);
      const std::int64_t j0 = j & across_mask_;
      const std::int64_t j1 = (j + 1) & across_mask_;
      const auto mix = [](float x, float y, float f) { return x + f * (y - x); };
      return kUnit * mix(mix(low[j0], low[j1], fc), mix(high[j0], high[j1], fc), fa);
    }
  };
  /// For pixels that cover so much ground [m].
  [[nodiscard]] Level level(double along, double across) const;

 private:
  Shape shape_;
  int along_levels_ = 0;
  int across_levels_ = 0;
  std::vector<std::vector<std::int16_t>> levels_;  ///< by across * along_levels_ + along

  void add_octave(const Octave& octave, std::vector<float>& values, class Random& random) const;
  void average(const std::vector<float>& values);
};

}  // namespace lanefuse
