// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/reference_line.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {

ReferenceLine::ReferenceLine(const std::vector<RoadElement>& elements, const Pose2& start) {
  assert(!elements.empty());
  Piece piece{0, start.heading, {}};
  for (const RoadElement& element : elements) {
    assert(element.length > 0 && element.length == std::floor(element.length));
    piece.element = element;
    pieces_.push_back(piece);
    piece.heading += element.length * (element.curvature + element.length * element.curvature_rate / 2);
    piece.begin += element.length;
  }
  positions_.reserve(static_cast<std::size_t>(length()) + 1);
  positions_.push_back(start.position());
  for (double station = 0; station < length(); ++station) {
    positions_.push_back(positions_.back() + displacement(station, station + 1));
  }
}

const ReferenceLine::Piece& ReferenceLine::piece_at(double station) const {
  const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), station,
                                      [](double s, const Piece& piece) { return s < piece.begin; });
  return *(after - 1);
}

double ReferenceLine::curvature(double station) const {
  const Piece& piece = piece_at(station);
  return piece.element.curvature + (station - piece.begin) * piece.element.curvature_rate;
}

double ReferenceLine::heading(double station) const {
  const Piece& piece = piece_at(station);
  const double way = station - piece.begin;
  return piece.heading + way * (piece.element.curvature + way * piece.element.curvature_rate / 2);
}

Pose2 ReferenceLine::pose(double station) const {
  const double last = static_cast<double>(positions_.size() - 1);
  const double metre = std::clamp(std::floor(station), 0.0, last);
  const Eigen::Vector2d position = positions_[static_cast<std::size_t>(metre)] + displacement(metre, station);
  return {position.x(), position.y(), heading(station)};
}

/// Gauss-Legendre with two points: over a metre of at most 1/100 m curvature its error is below 1e-11 m.
Eigen::Vector2d ReferenceLine::displacement(double from, double to) const {
  const double middle = (from + to) / 2;
  const double reach = (to - from) / 2 / std::sqrt(3.0);
  const double early = heading(middle - reach);
  const double late = heading(middle + reach);
  return (to - from) / 2 *
         Eigen::Vector2d(std::cos(early) + std::cos(late), std::sin(early) + std::sin(late));
}

}  // namespace lanefuse
