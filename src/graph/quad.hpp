// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace lanefuse {

/// Four numbers side by side, worked on at once where the processor can. Every lane is rounded as a single
/// number would be, so that the result does not depend on the processor.
using Quad = double __attribute__((vector_size(32)));

/// Where Quads begin in memory. The compiler by itself aligns them as the least of the processors needs it.
inline constexpr std::size_t kQuadAlignment = 32;

template <typename T>
struct QuadAllocator {
  using value_type = T;  // NOLINT(readability-identifier-naming): the standard's name
  QuadAllocator() = default;
  template <typename Other>
  QuadAllocator(const QuadAllocator<Other>& /*other*/) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{kQuadAlignment}));
  }
  void deallocate(T* memory, std::size_t /*count*/) {
    ::operator delete (memory, std::align_val_t{kQuadAlignment});
  }
  friend bool operator==(const QuadAllocator&, const QuadAllocator&) { return true; }
};
using Quads = std::vector<Quad, QuadAllocator<Quad>>;

/// A kernel is inlined into one function per instruction set (see window_kernels.cpp). Quads go by reference:
/// by value they would be passed differently from one instruction set to the next.
#define LANEFUSE_INLINE [[gnu::always_inline]] inline

/// Rows become columns: four places (x, y, heading, -) become four xs, four ys, ...
LANEFUSE_INLINE void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Quad ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Quad cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// The sum of the four, always in the same order.
LANEFUSE_INLINE double sum(const Quad& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// Angles wrapped to [-pi, pi].
LANEFUSE_INLINE void wrap_angles(Quad& angle) {
  constexpr double kTurn = 6.283185307179586476925;
  constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const Quad turns = (angle * (1 / kTurn) + kRounder) - kRounder;
  angle -= turns * kTurn;
}

}  // namespace lanefuse
