// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Switch variables without vertices of their own.
///
/// A switch s enters the cost through its own edge only, as f(s) J + W (1-s)^2 with f(s) = s (linear form) or
/// s^2 (squared form). For given vertices the best s is therefore known in closed form, and putting it in
/// leaves a robust cost rho(J) of the vertices alone:
///
///     linear   s = clip(1 - J/2W, 0, 1)   rho = J - J^2/4W below J = 2W, else W
///     squared  s = W / (W + J)            rho = W J / (W + J)
///
/// As s is a minimum, d rho/ds = 0 and by the chain rule d rho/dx = f(s) dJ/dx: the gradient of the
/// eliminated cost is that of the edge, weighted with f(s). Gauss-Newton takes the same weight for the
/// Hessian, f(s) * 2 A' Omega A: what it leaves out is rho''(J) dJ dJ', which is negative semi-definite
/// because rho is concave. The weighted quadratic thus lies above rho and touches it at the present point, so
/// that every step of it lowers rho as far as the edge is linear.

/// f(s): what an edge's cost is multiplied with when its switch stands at `value`.
inline double switch_factor(SwitchForm form, double value) {
  return form == SwitchForm::linear ? value : value * value;
}

/// The best s in [0, 1] for an edge (or several that share it) of cost J >= 0 and prior W > 0.
double best_switch(SwitchForm form, double cost, double prior);

/// rho(J): the edge's cost and the prior together, at the best s.
double switched_cost(SwitchForm form, double cost, double prior);

}  // namespace lanefuse
