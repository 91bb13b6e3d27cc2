// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_kernels.hpp"

#include "graph/window_loops.hpp"

namespace lanefuse {

namespace {

// An attribute and half a name cannot stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define LANEFUSE_KERNELS(NAME, TARGET)                                                                \
  TARGET double NAME##_linearize(const WindowGraph& graph, WindowSystem& system) {                    \
    return window_loops::linearize(graph, system);                                                    \
  }                                                                                                   \
  TARGET double NAME##_cost(const WindowGraph& graph, const WindowSystem& system) {                   \
    return window_loops::cost(graph, system);                                                         \
  }                                                                                                   \
  TARGET void NAME##_reduce_diagonal(WindowSystem& system) { window_loops::reduce_diagonal(system); } \
  TARGET void NAME##_spread(WindowSystem& system, std::size_t begin, std::size_t end,                 \
                            std::span<const Quad> by_landmark, std::span<Quad> by_pose) {             \
    window_loops::spread(system, begin, end, by_landmark, by_pose);                                   \
  }                                                                                                   \
  TARGET void NAME##_gather(WindowSystem& system, std::size_t begin, std::size_t end,                 \
                            std::span<const Quad> by_pose, std::span<Quad> by_landmark) {             \
    window_loops::gather(system, begin, end, by_pose, by_landmark);                                   \
  }                                                                                                   \
  TARGET void NAME##_product(WindowSystem& system, std::span<const Quad> by_pose,                     \
                             std::span<Quad> eliminated, std::span<Quad> product) {                   \
    window_loops::product(system, by_pose, eliminated, product);                                      \
  }                                                                                                   \
  TARGET void NAME##_rest(WindowSystem& system, std::size_t begin, std::size_t end,                   \
                          std::span<const Quad> by_pose, std::span<const Quad> by_landmark,           \
                          std::span<Quad> product) {                                                  \
    window_loops::rest(system, begin, end, by_pose, by_landmark, product);                            \
  }                                                                                                   \
  constexpr WindowKernels NAME{NAME##_linearize, NAME##_cost,   NAME##_reduce_diagonal,               \
                               NAME##_spread,    NAME##_gather, NAME##_product,                       \
                               NAME##_rest};
// NOLINTEND(bugprone-macro-parentheses)

LANEFUSE_KERNELS(kPlain, )
#if defined(__x86_64__)
LANEFUSE_KERNELS(kAvx2, [[gnu::target("avx2")]])
#endif
#undef LANEFUSE_KERNELS

}  // namespace

const WindowKernels& window_kernels() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return kAvx2;
#endif
  return kPlain;
}

const WindowKernels& plain_kernels() { return kPlain; }

}  // namespace lanefuse
