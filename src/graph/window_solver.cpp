// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_solver.hpp"

#include <algorithm>
#include <cmath>

#include "graph/window_algebra.hpp"
#include "graph/window_conversion.hpp"

namespace lanefuse {

namespace {

/// Two costs as near as this to each other are the same but for rounding.
constexpr double kRounding = 1e-13;

/// A step that is this small a share of the farthest coordinate is down in the coordinates' rounding.
constexpr double kStepRounding = 1e-12;

constexpr int kMaxHalvings = 12;

void set_zero(Quads& v, std::size_t size) { v.assign(size, Quad{}); }

double dot(std::span<const Quad> a, std::span<const Quad> b) {
  Quad total{};
  for (std::size_t i = 0; i < a.size(); ++i) total += a[i] * b[i];
  return sum(total);
}

void add_scaled(std::span<Quad> sum, double scale, std::span<const Quad> term) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += scale * term[i];
}

}  // namespace

ConjugateGradientSolver::ConjugateGradientSolver()
    : kernels_(window_kernels()), direct_(make_schur_solver()) {}

SolveResult ConjugateGradientSolver::solve(WindowGraph& graph, const SolverConfig& config) {
  SolveResult result;
  if (!prepare(graph)) {
    result.status = SolveStatus::no_fixed_vertex;
    return result;
  }
  result.initial_chi2 = result.final_chi2 = linearize(graph, config.switch_form);
  if (!std::isfinite(result.final_chi2)) {
    result.status = SolveStatus::not_finite;
    return result;
  }
  result.status = SolveStatus::iterations_exhausted;
  while (result.iterations < config.max_iterations) {
    ++result.iterations;
    const Step step = find_step(graph, config, result);
    if (step == Step::singular) {
      result.status = SolveStatus::singular;
      result.final_chi2 = result.initial_chi2;
      return result;
    }
    if (step == Step::struggled) return fall_back(graph, config, result, SolveFallback::cg_struggled);
    if (step == Step::negative_curvature)
      return fall_back(graph, config, result, SolveFallback::negative_curvature);
    const bool last = result.iterations == config.max_iterations;
    if (!descend(graph, config, last, result)) {
      result.status = SolveStatus::converged;
      break;
    }
  }
  write_back(graph);
  return result;
}

/// Goes the found step, or as much of it as leads down; false if nothing worth going is left. The full step
/// is right where the window starts from the last cycle's solution; from further away its end may lie higher.
bool ConjugateGradientSolver::descend(const WindowGraph& graph, const SolverConfig& config, bool last,
                                      SolveResult& result) {
  best_places_ = system_.places;
  best_landmarks_ = system_.landmarks;
  const double enough = std::max(config.relative_tolerance, kRounding) * result.final_chi2;
  double share = 1;
  for (int halvings = 0; halvings < kMaxHalvings; ++halvings, share /= 2) {
    take_step(graph, share);
    const double here = last ? cost(graph, config.switch_form) : linearize(graph, config.switch_form);
    if (here <= result.final_chi2) {
      const bool goes_on = result.final_chi2 - here > enough;
      result.final_chi2 = here;
      return goes_on;
    }
    if (here - result.final_chi2 <= enough || step_is_negligible()) break;
    ++result.halvings;
  }
  system_.places = best_places_;
  system_.landmarks = best_landmarks_;
  place_turns(graph);
  cost(graph, config.switch_form);  // the switches belong to these places
  return false;
}

bool ConjugateGradientSolver::prepare(const WindowGraph& graph) {
  if (graph.chain().empty()) return false;
  WindowSystem& s = system_;
  s.runs.clear();
  for (WindowGraph::Id id = 0; id < graph.landmark_slots(); ++id) {
    if (graph.is_alive(id) && graph.first_tie(id) == WindowGraph::kNone) s.runs.push_back({id, 0, 0});
  }
  tied_.prepare(graph, s);
  std::uint32_t blocks = 0;
  std::uint32_t most = 0;
  for (LandmarkRun& run : s.runs) {
    run.begin = blocks;
    const std::uint32_t own = (graph.observation_count(run.landmark) + 3) / 4;
    blocks += own;
    run.end = blocks;
    most = std::max(most, own);
  }
  s.linear.resize(blocks);
  s.scratch.resize(3 * most);
  const std::size_t poses = graph.pose_slots();
  const std::size_t landmarks = s.runs.size();
  set_zero(s.places, poses);
  set_zero(s.turns, poses);
  for (const WindowGraph::Id id : graph.chain()) {
    const Pose2 pose = graph.pose(id);
    s.places[id] = Quad{pose.x, pose.y, pose.heading, 0};
  }
  s.landmarks.resize(landmarks);
  for (std::size_t r = 0; r < landmarks; ++r) {
    const Pose2 pose = graph.landmark(s.runs[r].landmark);
    s.landmarks[r] = Quad{pose.x, pose.y, pose.heading, 0};
  }
  for (auto* by_landmark : {&s.information, &s.landmark_rhs, &s.inverses, &landmark_step_, &eliminated_})
    set_zero(*by_landmark, landmarks);
  for (auto* by_pose :
       {&s.reduced_first, &s.reduced_rest, &step_, &residual_, &direction_, &preconditioned_, &product_})
    set_zero(*by_pose, poses);
  place_turns(graph);
  return true;
}

void ConjugateGradientSolver::place_turns(const WindowGraph& graph) {
  for (const WindowGraph::Id id : graph.chain()) {
    const double c = std::cos(system_.places[id][2]);
    const double s = std::sin(system_.places[id][2]);
    system_.turns[id] = Quad{c, s, c * c - s * s, 2 * c * s};
  }
}

double ConjugateGradientSolver::linearize(const WindowGraph& graph, SwitchForm form) {
  set_zero(system_.pose_rhs, graph.pose_slots());
  const double observed = kernels_.linearize(graph, system_);
  return observed + tied_.linearize(graph, form, system_) + chain_.linearize(graph, system_);
}

double ConjugateGradientSolver::cost(const WindowGraph& graph, SwitchForm form) {
  return kernels_.cost(graph, system_) + tied_.cost(graph, form, system_) + chain_.cost(graph, system_);
}

bool ConjugateGradientSolver::invert_landmarks() {
  for (std::size_t r = 0; r < system_.untied; ++r) {
    if (!invert_block(system_.information[r], system_.inverses[r])) return false;
  }
  // For the preconditioner alone: the ties' part without what couples position and heading, so that it still
  // is at least each observation's own.
  for (std::size_t k = 0; k < tied_.size(); ++k) {
    const Eigen::Matrix3d& d = tied_.diagonal(k);
    const Quad apart{d(0, 0), d(0, 1), d(1, 1), d(2, 2)};
    if (!invert_block(apart, system_.inverses[system_.untied + k])) return false;
  }
  return tied_.factorise();
}

bool ConjugateGradientSolver::make_preconditioner(const WindowGraph& graph) {
  set_zero(system_.reduced_first, graph.pose_slots());
  set_zero(system_.reduced_rest, graph.pose_slots());
  kernels_.reduce_diagonal(system_);
  return chain_.factorise(graph, system_);
}

ConjugateGradientSolver::Step ConjugateGradientSolver::find_step(const WindowGraph& graph,
                                                                 const SolverConfig& config,
                                                                 SolveResult& result) {
  if (!invert_landmarks() || !make_preconditioner(graph)) return Step::singular;
  const WindowGraph::Id held = graph.chain().back();
  reduce(residual_);
  residual_[held] = Quad{};
  residual_[WindowGraph::kNowhere] = Quad{};
  set_zero(step_, step_.size());
  chain_.precondition(graph, residual_, preconditioned_);
  direction_ = preconditioned_;
  double rho = dot(residual_, preconditioned_);
  const double enough = config.cg_tolerance * config.cg_tolerance * rho;
  for (int i = 0; rho > enough; ++i) {
    if (i == config.max_cg_iterations) return Step::struggled;
    ++result.cg_iterations;
    multiply(graph, direction_, product_);
    product_[held] = Quad{};
    product_[WindowGraph::kNowhere] = Quad{};
    const double curvature = dot(direction_, product_);
    if (!(curvature > 0)) return Step::negative_curvature;
    const double length = rho / curvature;
    add_scaled(step_, length, direction_);
    add_scaled(landmark_step_, length, eliminated_);
    add_scaled(residual_, -length, product_);
    chain_.precondition(graph, residual_, preconditioned_);
    const double next = dot(residual_, preconditioned_);
    const double share = next / rho;
    for (std::size_t k = 0; k < direction_.size(); ++k)
      direction_[k] = preconditioned_[k] + share * direction_[k];
    rho = next;
  }
  return std::isfinite(rho) ? Step::found : Step::struggled;
}

/// The right-hand side of the poses' equations, and the landmarks' step for poses that stay.
void ConjugateGradientSolver::reduce(std::span<Quad> rhs) {
  for (std::size_t r = 0; r < system_.untied; ++r)
    multiply_block(system_.inverses[r], system_.landmark_rhs[r], landmark_step_[r]);
  std::copy(system_.landmark_rhs.begin() + static_cast<std::ptrdiff_t>(system_.untied),
            system_.landmark_rhs.end(), landmark_step_.begin() + static_cast<std::ptrdiff_t>(system_.untied));
  tied_.solve(landmark_step_);
  std::copy(system_.pose_rhs.begin(), system_.pose_rhs.end(), rhs.begin());
  kernels_.spread(system_, 0, system_.runs.size(), landmark_step_, rhs);
}

void ConjugateGradientSolver::multiply(const WindowGraph& graph, std::span<const Quad> p,
                                       std::span<Quad> product) {
  std::fill(product.begin(), product.end(), Quad{});
  kernels_.product(system_, p, eliminated_, product);
  kernels_.gather(system_, system_.untied, system_.runs.size(), p, eliminated_);
  tied_.solve(eliminated_);
  kernels_.rest(system_, system_.untied, system_.runs.size(), p, eliminated_, product);
  chain_.add_product(graph, p, product);
}

void ConjugateGradientSolver::take_step(const WindowGraph& graph, double share) {
  for (const WindowGraph::Id id : graph.chain()) {
    system_.places[id] = best_places_[id] + share * step_[id];
    system_.places[id][2] = wrap_angle(system_.places[id][2]);
  }
  for (std::size_t r = 0; r < system_.runs.size(); ++r) {
    system_.landmarks[r] = best_landmarks_[r] + share * landmark_step_[r];
    system_.landmarks[r][2] = wrap_angle(system_.landmarks[r][2]);
  }
  place_turns(graph);
}

/// Whether the cost says nothing about the step: where all fits to the last bit, it is rounding itself.
bool ConjugateGradientSolver::step_is_negligible() const {
  double farthest = 1;
  for (const Quads* places : {&best_places_, &best_landmarks_}) {
    for (const Quad& p : *places) farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1])});
  }
  const double bound = kStepRounding * farthest;
  const auto is_small = [&](const Quad& step) {
    return std::abs(step[0]) <= bound && std::abs(step[1]) <= bound && std::abs(step[2]) <= bound;
  };
  return std::all_of(step_.begin(), step_.end(), is_small) &&
         std::all_of(landmark_step_.begin(), landmark_step_.end(), is_small);
}

void ConjugateGradientSolver::write_back(WindowGraph& graph) const {
  const auto chain = graph.chain();
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const Quad& p = system_.places[chain[k]];
    graph.place_pose(chain[k], {p[0], p[1], p[2]});
  }
  for (std::size_t r = 0; r < system_.runs.size(); ++r) {
    const Quad& l = system_.landmarks[r];
    graph.place_landmark(system_.runs[r].landmark, {l[0], l[1], l[2]});
  }
  tied_.write_switches(graph);
}

/// From where the graph stood at first: what was gained before is little beside what the direct solver costs.
SolveResult ConjugateGradientSolver::fall_back(WindowGraph& graph, const SolverConfig& config,
                                               SolveResult result, SolveFallback reason) {
  copy(graph, fallback_graph_);
  SolveResult direct = direct_->solve(fallback_graph_, config);
  direct.cg_iterations = result.cg_iterations;
  direct.fallback = reason;
  if (direct.ok()) take_places(fallback_graph_, graph);
  return direct;
}

}  // namespace lanefuse
