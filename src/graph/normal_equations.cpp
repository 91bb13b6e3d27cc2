// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/normal_equations.hpp"

#include <algorithm>

namespace lanefuse {

namespace {

void add_block(double* values, std::size_t stride, const Eigen::Matrix3d& block) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) values[c * stride + r] += block(r, c);
  }
}

}  // namespace

void NormalEquations::prepare(const EdgeTerms& terms, const EliminationOrder& order,
                              const BlockStructure& structure, const WeakTerms& weak) {
  structure_ = &structure;
  targets_.clear();
  targets_.reserve(terms.terms().size());
  for (const EdgeTerms::Term& term : terms.terms()) {
    Target target;
    target.from_block = order.block(term.from);
    target.to_block = order.block(term.to);
    if (target.from_block != kHeld) {
      target.from = structure.column(target.from_block).values;
      target.from_stride = structure.column(target.from_block).stride;
    }
    if (target.to_block != kHeld) {
      target.to = structure.column(target.to_block).values;
      target.to_stride = structure.column(target.to_block).stride;
    }
    const auto [first, second] = std::minmax(target.from_block, target.to_block);
    const bool is_left_out = second == kHeld || weak.joins_nothing(targets_.size());
    target.cross = is_left_out ? kNowhere : structure.locate(first, second);
    targets_.push_back(target);
  }
  values.resize(structure.value_count());
  rhs.resize(3 * structure.blocks());
  diagonal.resize(3 * structure.blocks());
}

void NormalEquations::assemble(const EdgeTerms& terms, const std::vector<Placed>& places, double damping) {
  std::fill(values.begin(), values.end(), 0.0);
  rhs.setZero();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const EdgeTerms::Term& term = terms.terms()[i];
    const double weight = terms.weight(term);
    if (weight == 0) continue;
    const Placed& from = places[term.from];
    const Placed& to = places[term.to];
    const Eigen::Vector3d pull = weight * (term.information * terms.error(i));
    const Eigen::Vector3d turned_pull(from.cosine * pull[0] - from.sine * pull[1],
                                      from.sine * pull[0] + from.cosine * pull[1], pull[2]);
    add(targets_[i], weight * turned(term.information, from.cosine, from.sine), turned_pull,
        {from.y - to.y, to.x - from.x});
  }
  damp(damping);
}

void NormalEquations::add(const Target& target, const Symmetric3& information, const Eigen::Vector3d& pull,
                          const Eigen::Vector2d& lever) {
  // With error and information turned into the graph's frame, the error's Jacobian by `to` is the identity,
  // and by `from` it is -B, where B is the identity but for the lever (-dy, dx) above its last 1.
  const Symmetric3& m = information;
  Eigen::Matrix3d to_to;
  to_to << m.xx, m.xy, m.xh, m.xy, m.yy, m.yh, m.xh, m.yh, m.hh;
  Eigen::Matrix3d to_from = to_to;  // M B
  to_from.col(2) += to_to.leftCols<2>() * lever;
  if (target.to_block != kHeld) {
    add_block(&values[target.to], target.to_stride, to_to);
    rhs.segment<3>(3 * target.to_block) -= pull;
  }
  if (target.from_block == kHeld) return;
  Eigen::Matrix3d from_from = to_from;  // B' M B
  from_from.row(2) += lever.transpose() * to_from.topRows<2>();
  add_block(&values[target.from], target.from_stride, from_from);
  rhs.segment<3>(3 * target.from_block) +=
      Eigen::Vector3d(pull[0], pull[1], pull[2] + lever.dot(pull.head<2>()));
  if (target.cross == kNowhere) return;
  if (target.from_block < target.to_block) {
    add_block(&values[target.cross], target.from_stride, -to_from);
  } else {
    add_block(&values[target.cross], target.to_stride, -to_from.transpose());
  }
}

void NormalEquations::damp(double damping) {
  for (std::uint32_t block = 0; block < structure_->blocks(); ++block) {
    const BlockStructure::Column& column = structure_->column(block);
    for (std::size_t k = 0; k < 3; ++k) {
      double& entry = values[column.values + k * (column.stride + 1)];
      entry += damping * entry;
      diagonal[static_cast<Eigen::Index>(3 * block + k)] = entry;
    }
  }
}

}  // namespace lanefuse
