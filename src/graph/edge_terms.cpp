// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/edge_terms.hpp"

#include <algorithm>
#include <cmath>

#include "graph/switchable.hpp"

namespace lanefuse {

namespace {

Symmetric3 symmetric(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2), m(2, 2)};
}

EdgeTerms::Term make_term(const Edge& edge) {
  const Pose2& z = edge.measurement;
  EdgeTerms::Term term{edge.from, edge.to, edge.switch_index, z.x, z.y, z.heading, {}};
  term.information = turned(symmetric(edge.information), std::cos(z.heading), std::sin(z.heading));
  return term;
}

Eigen::Vector3d term_error(const EdgeTerms::Term& term, const Placed& from, const Placed& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  return {from.cosine * dx + from.sine * dy - term.x, from.cosine * dy - from.sine * dx - term.y,
          wrap_angle(to.heading - from.heading - term.heading)};
}

}  // namespace

Symmetric3 turned(const Symmetric3& m, double c, double s) {
  const double cross = 2 * c * s * m.xy;
  return {c * c * m.xx + s * s * m.yy - cross,
          c * s * (m.xx - m.yy) + (c * c - s * s) * m.xy,
          s * s * m.xx + c * c * m.yy + cross,
          c * m.xh - s * m.yh,
          s * m.xh + c * m.yh,
          m.hh};
}

void EdgeTerms::prepare(const PoseGraph& graph, SwitchForm form) {
  form_ = form;
  terms_.clear();
  terms_.reserve(graph.edges.size());
  for (const Edge& edge : graph.edges) terms_.push_back(make_term(edge));
  errors_.resize(terms_.size());
  priors_.clear();
  for (const Switch& s : graph.switches) priors_.push_back(s.prior);
  switch_costs_.resize(priors_.size());
  switch_factors_.resize(priors_.size());
}

double EdgeTerms::evaluate(const std::vector<Placed>& places) {
  std::fill(switch_costs_.begin(), switch_costs_.end(), 0.0);
  double sum = 0;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    errors_[i] = term_error(term, places[term.from], places[term.to]);
    const double cost = errors_[i].dot(term.information * errors_[i]);
    (term.switch_index == kNoSwitch ? sum : switch_costs_[term.switch_index]) += cost;
  }
  for (std::size_t k = 0; k < priors_.size(); ++k) {
    switch_factors_[k] = switch_factor(form_, switch_value(k));
    sum += switched_cost(form_, switch_costs_[k], priors_[k]);
  }
  return sum;
}

double EdgeTerms::switch_value(std::size_t index) const {
  return best_switch(form_, switch_costs_[index], priors_[index]);
}

}  // namespace lanefuse
