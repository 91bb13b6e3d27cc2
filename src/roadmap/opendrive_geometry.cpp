// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "roadmap/opendrive_road.hpp"

namespace lanefuse {
namespace {

constexpr double kLongestRoad = 1e6;      // [m]
constexpr double kMostCurvature = 100;    // [1/m]
constexpr double kLengthTolerance = 1.0;  // [m] between a road's length and its plan view's

Cubic cubic(const XmlElement& element, const char* letters) {
  const auto value = [&](char power) {
    const std::string name = letters[0] == '\0' ? std::string(1, power) : std::string{power, letters[0]};
    return element.number(name.c_str());
  };
  return {value('a'), value('b'), value('c'), value('d')};
}

double curvature(const XmlElement& element, const char* attribute) {
  const double value = element.number(attribute);
  if (std::abs(value) > kMostCurvature)
    throw element.error(fmt::format("attribute '{}' is {}", attribute, value));
  return value;
}

CubicPiece read_cubic_piece(const XmlElement& element, double length) {
  const std::string range = element.find_text("pRange").value_or("normalized");
  if (range != "arcLength" && range != "normalized") {
    throw element.error("attribute 'pRange' is neither 'arcLength' nor 'normalized'");
  }
  return {cubic(element, "U"), cubic(element, "V"), range == "arcLength" ? 1 : 1 / length};
}

constexpr double kSlack = 1e-3;  ///< [m] that rounding may leave

PlanElement read_plan_element(const XmlElement& geometry) {
  PlanElement element;
  element.station = geometry.number("s");
  element.begin = {geometry.number("x"), geometry.number("y"), geometry.number("hdg")};
  element.length = geometry.number("length");
  if (element.length < 0 || element.length > kLongestRoad) {
    throw geometry.error(fmt::format("attribute 'length' is {}", element.length));
  }
  if (element.station < -kSlack) throw geometry.error(fmt::format("attribute 's' is {}", element.station));
  if (geometry.find("line")) {
    element.shape = ClothoidPiece{};
  } else if (const auto arc = geometry.find("arc")) {
    element.shape = ClothoidPiece{curvature(*arc, "curvature"), 0};
  } else if (const auto spiral = geometry.find("spiral")) {
    const double from = curvature(*spiral, "curvStart");
    const double to = curvature(*spiral, "curvEnd");
    element.shape = ClothoidPiece{from, element.length > 0 ? (to - from) / element.length : 0};
  } else if (const auto poly = geometry.find("poly3")) {
    element.shape = GraphPiece{cubic(*poly, "")};
  } else if (const auto parametric = geometry.find("paramPoly3")) {
    element.shape = read_cubic_piece(*parametric, std::max(element.length, 1e-9));
  } else {
    throw geometry.error("is none of line, arc, spiral, poly3 and paramPoly3");
  }
  return element;
}

}  // namespace

double CubicTable::at(double station) const {
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), station,
                                      [](double at, const Piece& piece) { return at < piece.from; });
  if (after == pieces.begin()) return 0;
  return (after - 1)->cubic.at(station - (after - 1)->from);
}

CubicTable read_cubics(const XmlElement& parent, const char* name, const char* offset) {
  CubicTable table;
  for (const XmlElement& element : parent.children(name)) {
    table.pieces.push_back({element.number(offset), cubic(element, "")});
    const std::size_t count = table.pieces.size();
    if (count > 1 && table.pieces[count - 1].from < table.pieces[count - 2].from) {
      throw element.error(fmt::format("attribute '{}' is before that of the one above", offset));
    }
  }
  return table;
}

PlanView read_plan_view(const XmlElement& element, double length) {
  std::vector<PlanElement> elements;
  for (const XmlElement& geometry : element.children("geometry")) {
    const PlanElement piece = read_plan_element(geometry);
    if (!elements.empty() && piece.station < elements.back().station) {
      throw geometry.error("begins before the one above");
    }
    if (piece.length > 0) elements.push_back(piece);
  }
  if (elements.empty()) throw element.error("has no <geometry> with a length");
  const double end = elements.back().station + elements.back().length;
  if (end < length - kLengthTolerance) {
    throw element.error(fmt::format("ends at s = {} m, the road at {} m", end, length),
                        "give the road the length of its geometries");
  }
  return PlanView(std::move(elements));
}

}  // namespace lanefuse
