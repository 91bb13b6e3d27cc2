// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {

/// A boundary as seen from a reference line: by station, how far to the left it is and how high.
class BoundaryOffsets {
 public:
  struct Row {
    double station = 0;     ///< [m] along the reference line
    double offset = 0;      ///< [m] to its left
    double height = 0;      ///< [m]
    double arc_length = 0;  ///< [m] along the boundary
  };

  /// Throws, naming `place`, where the boundary turns back or leaves the line.
  BoundaryOffsets(const MapBoundary& boundary, const PlanView& plan, const std::string& place);

  [[nodiscard]] double begin() const { return rows_.front().station; }
  [[nodiscard]] double end() const { return rows_.back().station; }
  /// Before the beginning and after the end, as at these.
  [[nodiscard]] double offset(double station) const;
  [[nodiscard]] double height(double station) const;
  [[nodiscard]] double station_of(double arc_length) const;
  /// The few stations between which the offset runs straight within 2 mm.
  [[nodiscard]] const std::vector<double>& bends() const { return bends_; }
  [[nodiscard]] std::vector<double> height_bends() const;

 private:
  void project(const MapBoundary& boundary, const PlanView& plan, const std::string& place);
  [[nodiscard]] double value(double at, double Row::*by, double Row::*what) const;
  [[nodiscard]] std::vector<double> bends_of(double Row::*what, double tolerance) const;

  std::vector<Row> rows_;
  std::vector<double> bends_;
};

}  // namespace lanefuse
