// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "graph/pose_chain.hpp"
#include "graph/pose_graph.hpp"
#include "graph/solver.hpp"
#include "graph/tied_landmarks.hpp"
#include "graph/window_graph.hpp"
#include "graph/window_kernels.hpp"

namespace lanefuse {

/// Moves a WindowGraph towards the minimum of J(V) [IROS16, sec. II-E].
class WindowSolver {
 public:
  virtual ~WindowSolver() = default;
  /// On failure the graph is left bit by bit as it was.
  virtual SolveResult solve(WindowGraph& graph, const SolverConfig& config) = 0;
};

/// Gauss-Newton whose steps are found by conjugate gradients on the poses. The landmarks are eliminated, but
/// the Schur complement that this leaves is never formed: its products go through the observations, six
/// numbers each. The preconditioner is the chain of steps with the diagonal blocks of the complement, and a
/// handful of products is enough. Tied landmarks are eliminated by a sparse factorisation of their own.
/// Switches are closed forms. Where this finds no way down (see SolveResult::fallback), `direct` carries on.
class ConjugateGradientSolver final : public WindowSolver {
 public:
  ConjugateGradientSolver();

  SolveResult solve(WindowGraph& graph, const SolverConfig& config) override;

 private:
  enum class Step : std::uint8_t { found, singular, struggled, negative_curvature };

  bool prepare(const WindowGraph& graph);
  double linearize(const WindowGraph& graph, SwitchForm form);
  double cost(const WindowGraph& graph, SwitchForm form);
  bool invert_landmarks();
  bool make_preconditioner(const WindowGraph& graph);
  Step find_step(const WindowGraph& graph, const SolverConfig& config, SolveResult& result);
  void reduce(std::span<Quad> rhs);
  void multiply(const WindowGraph& graph, std::span<const Quad> p, std::span<Quad> product);
  bool descend(const WindowGraph& graph, const SolverConfig& config, bool last, SolveResult& result);
  void take_step(const WindowGraph& graph, double share);
  void place_turns(const WindowGraph& graph);
  [[nodiscard]] bool step_is_negligible() const;
  void write_back(WindowGraph& graph) const;
  SolveResult fall_back(WindowGraph& graph, const SolverConfig& config, SolveResult result,
                        SolveFallback reason);

  const WindowKernels& kernels_;
  WindowSystem system_;
  TiedLandmarks tied_;
  PoseChain chain_;

  Quads best_places_, best_landmarks_;
  Quads step_, residual_, direction_, preconditioned_, product_;  ///< by pose
  Quads landmark_step_, eliminated_;                              ///< by landmark

  std::unique_ptr<GraphSolver> direct_;
  PoseGraph fallback_graph_;
};

/// Any solver for pose graphs, made to solve windows: they are copied there and back.
std::unique_ptr<WindowSolver> make_window_solver(std::unique_ptr<GraphSolver> solver);

/// The conjugate gradients for pose graphs whose poses are a chain that ends at the one fixed vertex, with
/// observations of landmarks whose information has no position-heading part: windows as g2o files. All others
/// are left to the direct solver (SolveFallback::not_a_window).
std::unique_ptr<GraphSolver> make_lane_graph_solver();

}  // namespace lanefuse
