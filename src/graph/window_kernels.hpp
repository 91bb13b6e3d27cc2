// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "graph/window_system.hpp"

namespace lanefuse {

/// The loops over all observations: where a solve spends its time.
struct WindowKernels {
  /// Linearises all observations: fills `linear`, `information`, `landmark_rhs`, and adds to `pose_rhs`.
  /// Returns their cost.
  double (*linearize)(const WindowGraph& graph, WindowSystem& system);

  /// Their cost alone.
  double (*cost)(const WindowGraph& graph, const WindowSystem& system);

  /// Adds to `reduced_first` and `reduced_rest` what the elimination of each landmark by its `inverses`
  /// leaves on the diagonal of the poses that see it.
  void (*reduce_diagonal)(WindowSystem& system);

  /// For the runs [begin, end): adds T' Omega l to `by_pose` of each observation, l being `by_landmark`.
  void (*spread)(WindowSystem& system, std::size_t begin, std::size_t end, std::span<const Quad> by_landmark,
                 std::span<Quad> by_pose);

  /// For the runs [begin, end): Omega T p summed over each landmark's observations, p being `by_pose`.
  void (*gather)(WindowSystem& system, std::size_t begin, std::size_t end, std::span<const Quad> by_pose,
                 std::span<Quad> by_landmark);

  /// For untied landmarks all of a product with the Schur complement: `eliminated` = D^-1 Omega T p, and
  /// T' Omega (T p - eliminated) added to `product`.
  void (*product)(WindowSystem& system, std::span<const Quad> by_pose, std::span<Quad> eliminated,
                  std::span<Quad> product);

  /// For the runs [begin, end): T' Omega (T p - l) added to `product`.
  void (*rest)(WindowSystem& system, std::size_t begin, std::size_t end, std::span<const Quad> by_pose,
               std::span<const Quad> by_landmark, std::span<Quad> product);
};

/// The kernels for this processor. They differ from the plain ones in speed only: all give the same bytes.
const WindowKernels& window_kernels();

/// The kernels for any processor.
const WindowKernels& plain_kernels();

}  // namespace lanefuse
