// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <complex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roadmap/geo_frame.hpp"
#include "roadmap/lane_strips.hpp"
#include "roadmap/opendrive.hpp"
#include "support/map_files.hpp"
#include "support/opendrive_text.hpp"

namespace lanefuse {
namespace {

using namespace testing;  // the words of OpenDRIVE

RoadMap read(const std::string& text) {
  const ScratchMap file("map.xodr", text);
  return read_opendrive(file.path());
}

/// The reference line of one geometry: the left boundary of lane -1.
std::vector<Eigen::Vector3d> reference_line(const std::string& shape, double length) {
  const RoadMap map =
      read(opendrive(road(1, length, geometry(shape, length), section(0, lane(-1, width(3.5))))));
  return map.boundaries.at(0).points;
}

/// exp(i heading(s)) integrated by Simpson's rule.
std::complex<double> simpson(double length, double curvature, double rate) {
  std::complex<double> sum = 0;
  constexpr int kSteps = 20'000;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = length * i / kSteps;
    const double weight = i == 0 || i == kSteps ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * std::polar(1.0, s * (curvature + s * rate / 2));
  }
  return sum * (length / kSteps / 3);
}

TEST(OpenDriveGeometry, ArcIsACircle) {
  for (const Eigen::Vector3d& point : reference_line("<arc curvature=\"-0.05\"/>", 60)) {
    EXPECT_NEAR((point.head<2>() - Eigen::Vector2d(0, -20)).norm(), 20, 1e-9);
  }
}

TEST(OpenDriveGeometry, SpiralIsAnExactClothoid) {
  const auto points = reference_line("<spiral curvStart=\"0.001\" curvEnd=\"0.02\"/>", 200);
  const std::complex<double> end = simpson(200, 0.001, 0.019 / 200);
  EXPECT_NEAR(points.back().x(), end.real(), 1e-9);
  EXPECT_NEAR(points.back().y(), end.imag(), 1e-9);
}

TEST(OpenDriveGeometry, Poly3IsAGraphOfThatLength) {
  const auto points = reference_line("<poly3 a=\"0\" b=\"0\" c=\"0.005\" d=\"0.00001\"/>", 80);
  for (const Eigen::Vector3d& point : points) {
    EXPECT_NEAR(point.y(), 0.005 * std::pow(point.x(), 2) + 0.00001 * std::pow(point.x(), 3), 1e-9);
  }
  EXPECT_NEAR(arc_length(points), 80, 0.02);
}

TEST(OpenDriveGeometry, ParamPoly3InBothRanges) {
  const std::string by_length =
      "<paramPoly3 pRange=\"arcLength\" aU=\"0\" bU=\"1\" cU=\"0\" dU=\"-1e-6\" "
      "aV=\"0\" bV=\"0\" cV=\"0.001\" dV=\"0\"/>";
  EXPECT_NEAR(reference_line(by_length, 100).back().x(), 99, 1e-9);
  EXPECT_NEAR(reference_line(by_length, 100).back().y(), 10, 1e-9);
  const std::string normalized =
      "<paramPoly3 aU=\"0\" bU=\"100\" cU=\"0\" dU=\"-1\" "
      "aV=\"0\" bV=\"0\" cV=\"10\" dV=\"0\"/>";  // normalized is what holds unsaid
  EXPECT_NEAR(reference_line(normalized, 100).back().x(), 99, 1e-9);
  EXPECT_NEAR(reference_line(normalized, 100).back().y(), 10, 1e-9);
}

TEST(OpenDriveGeometry, ChordsAreFineEnough) {
  const auto points = reference_line("<arc curvature=\"0.05\"/>", 60);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector3d middle = (points[i] + points[i - 1]) / 2;
    EXPECT_LT(std::abs((middle.head<2>() - Eigen::Vector2d(0, 20)).norm() - 20), 0.005);
    EXPECT_LE((points[i] - points[i - 1]).norm(), 2.001);
  }
}

TEST(OpenDriveGeometry, HeightFollowsTheElevation) {
  const std::string profile =
      "<elevationProfile><elevation s=\"0\" a=\"5\" b=\"0.1\" c=\"0\" d=\"0\"/>"
      "<elevation s=\"50\" a=\"10\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile>\n<lanes>";
  const std::string text = opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3.5)))));
  const auto points = read(replaced(text, "<lanes>", profile)).boundaries.at(1).points;
  EXPECT_NEAR(points.front().z(), 5, 1e-9);
  EXPECT_NEAR(points[10].z(), 5 + 0.1 * points[10].x(), 1e-9);
  EXPECT_NEAR(points.back().z(), 10, 1e-9);
}

TEST(OpenDriveGeometry, WidthsAndOffsetArePolynomials) {
  const std::string widening = lane(-1,
                                    "<width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/>\n"
                                    "<width sOffset=\"40\" a=\"3\" b=\"0\" c=\"0.001\" d=\"-1e-5\"/>\n");
  const std::string offset = "<laneOffset s=\"0\" a=\"1\" b=\"0.01\" c=\"0\" d=\"0\"/>\n";
  const RoadMap map = read(opendrive(road(1, 90, straight(90), offset + section(0, widening))));
  for (const Eigen::Vector3d& point : map.boundaries.at(0).points)
    EXPECT_NEAR(point.y(), 1 + 0.01 * point.x(), 1e-9);
  for (const Eigen::Vector3d& point : map.boundaries.at(1).points) {
    const double s = std::max(0.0, point.x() - 40);
    EXPECT_NEAR(point.y(), 1 + 0.01 * point.x() - 3 - 0.001 * s * s + 1e-5 * s * s * s, 1e-9);
  }
}

TEST(OpenDriveGeometry, BordersAreOffsetsOfTheirOwn) {
  const auto border = [](double at) {
    return fmt::format("<border sOffset=\"0\" a=\"{}\" b=\"0\" c=\"0\" d=\"0\"/>\n", at);
  };
  const RoadMap map =
      read(opendrive(road(1, 50, straight(50), section(0, lane(-1, border(-3)) + lane(-2, border(-7))))));
  EXPECT_NEAR(map.boundaries.at(1).points[0].y(), -3, 1e-9);
  EXPECT_NEAR(map.boundaries.at(2).points[0].y(), -7, 1e-9);
}

constexpr const char* kMunich = "x=\"691606.9\" y=\"5334764.0\" hdg=\"0\"";

/// GeographicLib's own UTM says where the road's beginning is.
TEST(OpenDriveGeometry, UtmCoordinatesFindTheirPlace) {
  const std::string reference = "<geoReference><![CDATA[+proj=utm +zone=32 +ellps=WGS84]]></geoReference>";
  const RoadMap map =
      read(opendrive(road(1, 1000, straight(1000, kMunich), section(0, lane(-1, width(3.5)))), reference));
  double latitude = 0;
  double longitude = 0;
  GeographicLib::UTMUPS::Reverse(32, true, 691606.9, 5334764.0, latitude, longitude);
  ASSERT_TRUE(map.origin.has_value());
  EXPECT_NEAR(map.origin->latitude_deg, latitude, 1e-9);
  EXPECT_NEAR(map.origin->longitude_deg, longitude, 1e-9);
  EXPECT_NEAR(map.boundaries[0].points.front().norm(), 0, 1e-6);
  GeographicLib::UTMUPS::Reverse(32, true, 692606.9, 5334764.0, latitude, longitude);
  const GeoOrigin end = GeoFrame(*map.origin).place(map.boundaries[0].points.back());
  EXPECT_NEAR(end.latitude_deg, latitude, 1e-9);
  EXPECT_NEAR(end.longitude_deg, longitude, 1e-9);
}

TEST(OpenDriveGeometry, FalseEastingAndOffsetAreTakenOff) {
  const std::string header =
      "<geoReference>+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=1000 +y_0=0</geoReference>"
      "<offset x=\"1000\" y=\"50\" z=\"500\" hdg=\"1.5707963267948966\"/>";
  const RoadMap map = read(opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3.5)))), header));
  EXPECT_EQ(map.origin, (GeoOrigin{48, 11, 500}));
  EXPECT_NEAR((map.boundaries[0].points.front() - Eigen::Vector3d(0, 50, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((map.boundaries[0].points.back() - Eigen::Vector3d(0, 150, 0)).norm(), 0, 1e-6);
}

TEST(OpenDriveGeometry, WithoutAPlaceThereIsNoOrigin) {
  const std::string text = opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3.5)))));
  EXPECT_EQ(read(text).origin, std::nullopt);
}

}  // namespace
}  // namespace lanefuse
