// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_frame.hpp"

#include <GeographicLib/Constants.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "roadmap/geo_frame.hpp"

namespace lanefuse {
namespace {

/// A transverse Mercator projection as PROJ describes it.
struct Projection {
  double latitude_deg = 0;
  double longitude_deg = 0;
  double scale = 1;
  double false_easting = 0;   ///< [m]
  double false_northing = 0;  ///< [m]
};

/// "+key=value" pieces.
class ProjText {
 public:
  explicit ProjText(const XmlElement& element) : element_(element) {
    std::istringstream words(element.content());
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (word.front() != '+') continue;
      values_[word.substr(1, equals - 1)] = equals == std::string::npos ? "" : word.substr(equals + 1);
    }
  }

  [[nodiscard]] bool has(const std::string& key) const { return values_.contains(key); }
  [[nodiscard]] std::string text(const std::string& key) const { return has(key) ? values_.at(key) : ""; }
  [[nodiscard]] double number(const std::string& key, double otherwise, double limit) const {
    if (!has(key)) return otherwise;
    const std::optional<double> value = parse_finite(values_.at(key));
    if (!value || std::abs(*value) > limit) {
      throw element_.error(
          fmt::format("+{}={} is no number from {} to {}", key, values_.at(key), -limit, limit));
    }
    return *value;
  }

 private:
  const XmlElement& element_;
  std::map<std::string, std::string> values_;
};

struct GeoReference {
  Projection projection;
  bool origin_is_place = true;  ///< lat_0, lon_0 lie in the map; with a plain utm they do not
};

std::optional<GeoReference> parse_reference(const XmlElement& element) {
  const ProjText text(element);
  const double latitude = text.number("lat_0", 0, 90);
  const double longitude = text.number("lon_0", 0, 180);
  const bool has_origin = text.has("lat_0") && text.has("lon_0");
  if (text.text("proj") == "utm" && !has_origin) {
    const double zone = text.number("zone", 0, 60);
    if (zone < 1 || zone != std::floor(zone)) throw element.error("+proj=utm needs +zone=1 to 60");
    return GeoReference{{0, zone * 6 - 183, 0.9996, 500'000, text.has("south") ? 10'000'000.0 : 0}, false};
  }
  if (!has_origin) return std::nullopt;
  if (text.text("proj") != "tmerc") return GeoReference{{latitude, longitude, 1, 0, 0}, true};
  const double scale = text.number("k_0", text.number("k", 1, 10), 10);
  if (scale <= 0) throw element.error("+k_0 is not above 0");
  return GeoReference{{latitude, longitude, scale, text.number("x_0", 0, 1e9), text.number("y_0", 0, 1e9)},
                      true};
}

/// <offset>: what was taken off the projected coordinates.
struct Offset {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double heading = 0;

  [[nodiscard]] Eigen::Vector3d apply(const Eigen::Vector3d& point) const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return shift + Eigen::Vector3d(c * point.x() - s * point.y(), s * point.x() + c * point.y(), point.z());
  }
};

Offset read_offset(const XmlElement& header) {
  const auto element = header.find("offset");
  if (!element) return {};
  return {{element->number("x", 0), element->number("y", 0), element->number("z", 0)},
          element->number("hdg", 0)};
}

/// From the projected plane to Earth.
class Unprojection {
 public:
  explicit Unprojection(const Projection& projection)
      : from_(projection),
        plane_(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), projection.scale) {
    double easting = 0;
    plane_.Forward(from_.longitude_deg, from_.latitude_deg, from_.longitude_deg, easting, northing_);
  }

  [[nodiscard]] GeoOrigin place(const Eigen::Vector3d& projected) const {
    GeoOrigin place{0, 0, projected.z()};
    plane_.Reverse(from_.longitude_deg, projected.x() - from_.false_easting,
                   projected.y() - from_.false_northing + northing_, place.latitude_deg, place.longitude_deg);
    return place;
  }

 private:
  Projection from_;
  GeographicLib::TransverseMercator plane_;
  double northing_ = 0;
};

bool is_plain(const Projection& projection, const Offset& offset) {
  return projection.scale == 1 && projection.false_easting == 0 && projection.false_northing == 0 &&
         offset.heading == 0 && offset.shift.head<2>().isZero(0);
}

}  // namespace

OpenDriveFrame read_opendrive_frame(const XmlElement& root, const Eigen::Vector2d& first_point) {
  const auto unchanged = [](const Eigen::Vector3d& point) { return point; };
  const auto header = root.find("header");
  const auto element = header ? header->find("geoReference") : std::nullopt;
  const auto reference = element ? parse_reference(*element) : std::nullopt;
  if (!reference) return {std::nullopt, unchanged};
  const Projection& projection = reference->projection;
  const Offset offset = read_offset(*header);
  if (is_plain(projection, offset)) {
    return {GeoOrigin{projection.latitude_deg, projection.longitude_deg, offset.shift.z()}, unchanged};
  }
  const Unprojection earth(projection);
  const Eigen::Vector3d first(first_point.x(), first_point.y(), 0);
  const GeoOrigin origin = reference->origin_is_place ? GeoOrigin{projection.latitude_deg,
                                                                  projection.longitude_deg, offset.shift.z()}
                                                      : earth.place(offset.apply(first));
  return {origin, [offset, earth, frame = GeoFrame(origin)](const Eigen::Vector3d& point) {
            return frame.local(earth.place(offset.apply(point)));
          }};
}

std::string geo_reference_text(const GeoOrigin& origin) {
  return fmt::format("+proj=tmerc +lat_0={} +lon_0={} +k_0=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
                     origin.latitude_deg, origin.longitude_deg);
}

}  // namespace lanefuse
