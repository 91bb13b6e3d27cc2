// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_chain.hpp"

#include <Eigen/LU>

#include "graph/determinacy.hpp"
#include "graph/window_algebra.hpp"

namespace lanefuse {

double PoseChain::linearize(const WindowGraph& graph, WindowSystem& system) {
  const auto chain = graph.chain();
  diagonal_.assign(chain.size(), Eigen::Matrix3d::Zero());
  next_.resize(chain.size());
  double cost = 0;
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const WindowGraph::Step& step = graph.steps()[k];
    const PlanarTerm term =
        planar_term(step.measurement, step.information, system.places[chain[k - 1]], system.places[chain[k]]);
    const PlanarBlocks blocks = planar_blocks(term);
    diagonal_[k - 1] += blocks.from_from;
    diagonal_[k] += term.information;
    next_[k - 1] = blocks.from_to;
    add(system.pose_rhs[chain[k - 1]], blocks.from_rhs);
    add(system.pose_rhs[chain[k]], -term.force);
    cost += term.cost;
  }
  return cost;
}

double PoseChain::cost(const WindowGraph& graph, const WindowSystem& system) const {
  const auto chain = graph.chain();
  double cost = 0;
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const WindowGraph::Step& step = graph.steps()[k];
    cost +=
        planar_term(step.measurement, step.information, system.places[chain[k - 1]], system.places[chain[k]])
            .cost;
  }
  return cost;
}

bool PoseChain::factorise(const WindowGraph& graph, const WindowSystem& system) {
  const auto chain = graph.chain();
  const std::size_t free = chain.size() - 1;
  inverse_.resize(free);
  gain_.resize(free);
  for (std::size_t k = 0; k < free; ++k) {
    const Quad& a = system.reduced_first[chain[k]];
    const Quad& b = system.reduced_rest[chain[k]];
    Eigen::Matrix3d block;
    block << a[0], a[1], a[3], a[1], a[2], b[0], a[3], b[0], b[1];
    block += diagonal_[k];
    const Eigen::Vector3d scale = block.diagonal();
    if (k > 0) block -= next_[k - 1].transpose() * gain_[k - 1];
    if (!is_determined(block, scale)) return false;
    inverse_[k] = block.inverse();
    gain_[k] = inverse_[k] * next_[k];
  }
  return true;
}

void PoseChain::add_product(const WindowGraph& graph, std::span<const Quad> p,
                            std::span<Quad> product) const {
  const auto chain = graph.chain();
  for (std::size_t k = 0; k < chain.size(); ++k) {
    Eigen::Vector3d q = diagonal_[k] * vector(p[chain[k]]);
    if (k > 0) q += next_[k - 1].transpose() * vector(p[chain[k - 1]]);
    if (k + 1 < chain.size()) q += next_[k] * vector(p[chain[k + 1]]);
    add(product[chain[k]], q);
  }
}

void PoseChain::precondition(const WindowGraph& graph, std::span<const Quad> r, std::span<Quad> z) const {
  const auto chain = graph.chain();
  const std::size_t free = chain.size() - 1;
  Eigen::Vector3d carried = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < free; ++k) {
    const Eigen::Vector3d v = vector(r[chain[k]]) - carried;
    z[chain[k]] = Quad{v[0], v[1], v[2], 0};
    carried = gain_[k].transpose() * v;
  }
  Eigen::Vector3d after = Eigen::Vector3d::Zero();
  z[chain[free]] = Quad{};
  for (std::size_t k = free; k-- > 0;) {
    Eigen::Vector3d y = inverse_[k] * vector(z[chain[k]]);
    if (k + 1 < free) y -= gain_[k] * after;
    z[chain[k]] = Quad{y[0], y[1], y[2], 0};
    after = y;
  }
}

}  // namespace lanefuse
