// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// A symmetric 3x3 matrix as its six numbers.
struct Symmetric3 {
  double xx = 0, xy = 0, yy = 0, xh = 0, yh = 0, hh = 0;

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {xx * v[0] + xy * v[1] + xh * v[2], xy * v[0] + yy * v[1] + yh * v[2],
            xh * v[0] + yh * v[1] + hh * v[2]};
  }
  friend Symmetric3 operator*(double scale, const Symmetric3& m) {
    return {scale * m.xx, scale * m.xy, scale * m.yy, scale * m.xh, scale * m.yh, scale * m.hh};
  }
};

/// `matrix` with its position axes turned by the angle of this cosine and sine.
Symmetric3 turned(const Symmetric3& matrix, double cosine, double sine);

/// A pose with the cosine and sine of its heading at hand.
struct Placed {
  double x = 0, y = 0, heading = 0, cosine = 1, sine = 0;
};

/// The terms of a graph's cost, made ready for many evaluations.
///
/// Errors are kept in the frame of the `from` vertex, where the measurement's own rotation is paid for once a
/// solve and not once an evaluation: e' Omega e is the same in every frame.
class EdgeTerms {
 public:
  struct Term {
    VertexId from = 0;
    VertexId to = 0;
    std::uint32_t switch_index = kNoSwitch;
    double x = 0, y = 0, heading = 0;  ///< the measurement
    Symmetric3 information;            ///< in the frame of `from`
  };

  void prepare(const PoseGraph& graph, SwitchForm form);

  /// The cost at these places, with every switch at its best; remembers errors and switches for what follows.
  double evaluate(const std::vector<Placed>& places);

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// As of the last evaluation: the error of a term, in the frame of its `from`.
  [[nodiscard]] const Eigen::Vector3d& error(std::size_t term) const { return errors_[term]; }
  /// As of the last evaluation: what a term counts for, 1 unless it is switched.
  [[nodiscard]] double weight(const Term& term) const {
    return term.switch_index == kNoSwitch ? 1 : switch_factors_[term.switch_index];
  }
  /// As of the last evaluation: the best value of a switch.
  [[nodiscard]] double switch_value(std::size_t index) const;

 private:
  SwitchForm form_ = SwitchForm::linear;
  std::vector<Term> terms_;
  std::vector<Eigen::Vector3d> errors_;
  std::vector<double> priors_;
  std::vector<double> switch_costs_;    ///< J summed over the edges of a switch
  std::vector<double> switch_factors_;  ///< f(s)
};

}  // namespace lanefuse
