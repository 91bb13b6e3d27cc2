// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <fmt/format.h>

namespace lanefuse::testing {

/// An OpenDRIVE file of these roads and junctions.
inline std::string opendrive(const std::string& content, const std::string& header = "") {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<OpenDRIVE>\n<header revMajor=\"1\" "
      "revMinor=\"6\">{}</header>\n{}</OpenDRIVE>\n",
      header, content);
}

inline std::string geometry(const std::string& shape, double length,
                            const std::string& pose = "x=\"0\" y=\"0\" hdg=\"0\"") {
  return fmt::format("<geometry s=\"0\" {} length=\"{}\">\n{}\n</geometry>\n", pose, length, shape);
}

inline std::string lane(int id, const std::string& content, const std::string& type = "driving") {
  return fmt::format("<lane id=\"{}\" type=\"{}\">\n{}</lane>\n", id, type, content);
}

inline std::string width(double metres) {
  return fmt::format("<width sOffset=\"0\" a=\"{}\" b=\"0\" c=\"0\" d=\"0\"/>\n", metres);
}

/// A lane of 3.5 m that is linked to these lanes.
inline std::string linked_lane(int id, const std::string& links) {
  return lane(id, fmt::format("<link>{}</link>\n", links) + width(3.5));
}

inline std::string section(double from, const std::string& right, const std::string& left = "",
                           const std::string& centre = "") {
  std::string text = fmt::format("<laneSection s=\"{}\">\n", from);
  if (!left.empty()) text += "<left>\n" + left + "</left>\n";
  text += "<center>\n" + lane(0, centre, "none") + "</center>\n";
  if (!right.empty()) text += "<right>\n" + right + "</right>\n";
  return text + "</laneSection>\n";
}

/// A road of one geometry.
inline std::string road(int id, double length, const std::string& geometry_text, const std::string& lanes,
                        const std::string& link = "", const std::string& attributes = "") {
  return fmt::format(
      "<road id=\"{}\" length=\"{}\" junction=\"-1\" {}>\n<link>{}</link>\n<planView>\n{}</planView>\n"
      "<lanes>\n{}</lanes>\n</road>\n",
      id, length, attributes, link, geometry_text, lanes);
}

inline std::string straight(double length, const std::string& pose = "x=\"0\" y=\"0\" hdg=\"0\"") {
  return geometry("<line/>", length, pose);
}

}  // namespace lanefuse::testing
