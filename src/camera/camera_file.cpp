// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_file.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "camera/image_codec.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::uintmax_t kLargestFile = 1 << 16;  ///< [bytes]: a camera's description has less than one in 60
constexpr std::size_t kLongestName = 64;
constexpr std::array kKinds{SensorKind::serial_camera, SensorKind::high_resolution_camera,
                            SensorKind::camera};

std::string place_of(const std::string& name, const YAML::Mark& mark) {
  return mark.is_null() ? name : fmt::format("{}:{}", name, mark.line + 1);
}

struct Range {
  double low;
  double high;
};

/// One map of the file, read strictly.
class Keys {
 public:
  Keys(const YAML::Node& node, std::string file, std::string path,
       std::initializer_list<std::string_view> known)
      : node_(node), file_(std::move(file)), path_(std::move(path)) {
    if (!node_.IsMap()) {
      throw configuration_error(place_of(file_, node_.Mark()),
                                path_.empty() ? "holds no camera: it is not a map of keys"
                                              : fmt::format("'{}' is not a map of keys", path_));
    }
    for (auto entry = node_.begin(); entry != node_.end(); ++entry) refuse_strange(entry, known);
  }

  [[nodiscard]] YAML::Node node(const std::string& key) const {
    YAML::Node child = node_[key];
    if (!child.IsDefined()) {
      throw configuration_error(place_of(file_, node_.Mark()), fmt::format("'{}' is missing", full(key)));
    }
    return child;
  }

  [[nodiscard]] double number(const std::string& key, Range range) const {
    return number(node(key), full(key), range);
  }

  [[nodiscard]] double number(const YAML::Node& value, const std::string& key, Range range) const {
    double number = 0;
    if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) || !(number >= range.low) ||
        !(number <= range.high)) {
      throw refusal(value, key, fmt::format("allowed: {} .. {}", range.low, range.high));
    }
    return number;
  }

  [[nodiscard]] int whole(const std::string& key, int highest) const {
    const YAML::Node value = node(key);
    int number = 0;
    if (!value.IsScalar() || !YAML::convert<int>::decode(value, number) || number < 1 || number > highest) {
      throw refusal(value, full(key), fmt::format("allowed: whole numbers in 1 .. {}", highest));
    }
    return number;
  }

  [[nodiscard]] Error refusal(const YAML::Node& value, const std::string& key,
                              const std::string& allowed) const {
    const std::string given = value.IsScalar() ? value.Scalar() : "a structure";
    return configuration_error(place_of(file_, value.Mark()), fmt::format("'{}' cannot be {}", key, given),
                               allowed);
  }

  [[nodiscard]] std::string full(const std::string& key) const {
    return path_.empty() ? key : fmt::format("{}.{}", path_, key);
  }

 private:
  const YAML::Node node_;  ///< const: otherwise asking for a key makes it
  std::string file_;
  std::string path_;

  void refuse_strange(const YAML::const_iterator& entry,
                      std::initializer_list<std::string_view> known) const {
    const std::string place = place_of(file_, entry->first.Mark());
    const std::string key = entry->first.IsScalar() ? entry->first.Scalar() : "(not a name)";
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw configuration_error(place, fmt::format("unknown key '{}'", full(key)),
                                fmt::format("known: {}", fmt::join(known, ", ")));
    }
    for (auto earlier = node_.begin(); earlier != entry; ++earlier) {
      if (earlier->first.Scalar() == key)
        throw configuration_error(place, fmt::format("'{}' is there twice", full(key)));
    }
  }
};

SensorKind kind_of(const Keys& keys) {
  const YAML::Node value = keys.node("kind");
  for (const SensorKind kind : kKinds) {
    if (value.IsScalar() && value.Scalar() == to_string(kind)) return kind;
  }
  throw keys.refusal(value, "kind", "allowed: serial_camera, high_resolution_camera, camera");
}

std::string name_of(const Keys& keys) {
  const YAML::Node value = keys.node("name");
  if (!value.IsScalar() || value.Scalar().empty() || value.Scalar().size() > kLongestName) {
    throw keys.refusal(value, "name", fmt::format("allowed: 1 to {} letters", kLongestName));
  }
  return value.Scalar();
}

std::array<double, 5> distortion_of(const Keys& lens) {
  const YAML::Node values = lens.node("distortion");
  std::array<double, 5> distortion{};
  if (!values.IsSequence() || values.size() != distortion.size()) {
    throw lens.refusal(values, "lens.distortion", "write five numbers: [k1, k2, p1, p2, k3]");
  }
  for (std::size_t i = 0; i < distortion.size(); ++i) {
    distortion[i] = lens.number(values[i], "lens.distortion", {-100, 100});
  }
  return distortion;
}

CameraIntrinsics intrinsics_of(const Keys& camera, const std::string& file) {
  const Keys image(camera.node("image"), file, "image", {"width_px", "height_px"});
  const Keys lens(camera.node("lens"), file, "lens", {"fx_px", "fy_px", "cx_px", "cy_px", "distortion"});
  CameraIntrinsics c;
  c.width = image.whole("width_px", 65535);
  c.height = image.whole("height_px", 65535);
  if (static_cast<std::int64_t>(c.width) * c.height > kMaxPixels) {
    throw configuration_error(file, fmt::format("an image of {} x {} px is too large", c.width, c.height),
                              fmt::format("at most {} pixels", kMaxPixels));
  }
  // The principal point of an image that was cut out of a larger one may lie outside.
  const double across = c.width;
  const double down = c.height;
  c.fx = lens.number("fx_px", {1, 1e6});
  c.fy = lens.number("fy_px", {1, 1e6});
  c.cx = lens.number("cx_px", {-across, 2 * across});
  c.cy = lens.number("cy_px", {-down, 2 * down});
  c.distortion = distortion_of(lens);
  return c;
}

Mounting mounting_of(const Keys& camera, const std::string& file) {
  const Keys keys(camera.node("mounting"), file, "mounting",
                  {"x_m", "y_m", "height_m", "roll_deg", "pitch_deg", "yaw_deg"});
  constexpr Range kInCar{-20, 20};
  constexpr Range kTilt{-45, 45};  // a camera that looks along the road
  Mounting mounting;
  mounting.x = keys.number("x_m", kInCar);
  mounting.y = keys.number("y_m", kInCar);
  mounting.z = keys.number("height_m", {0.1, 10});
  mounting.roll = keys.number("roll_deg", kTilt) * kDegree;
  mounting.pitch = keys.number("pitch_deg", kTilt) * kDegree;
  mounting.yaw = keys.number("yaw_deg", kTilt) * kDegree;
  return mounting;
}

/// Angles lose their last bits on the way to degrees and back: without this, 1.6 becomes 1.6000000000000003.
double tidy_degrees(double angle) { return std::round(angle / kDegree * 1e9) / 1e9 + 0.0; }

}  // namespace

SensorDescription parse_camera(const std::string& yaml, const std::string& name) {
  try {
    const Keys keys(YAML::Load(yaml), name, "", {"name", "kind", "image", "lens", "mounting"});
    SensorDescription camera;
    camera.kind = kind_of(keys);
    camera.name = name_of(keys);
    camera.camera = intrinsics_of(keys, name);
    camera.mounting = mounting_of(keys, name);
    return camera;
  } catch (const YAML::Exception& e) {
    throw configuration_error(place_of(name, e.mark), fmt::format("not YAML: {}", e.msg));
  }
}

SensorDescription load_camera(const std::filesystem::path& file) {
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) throw configuration_error(file.string(), "cannot be read");
  if (size > kLargestFile) throw configuration_error(file.string(), "is too large for a camera.yaml");
  std::stringstream text;
  text << in.rdbuf();
  return parse_camera(text.str(), file.string());
}

std::string to_yaml(const SensorDescription& camera) {
  assert(camera.camera);
  const CameraIntrinsics& c = *camera.camera;
  const Mounting& m = camera.mounting;
  YAML::Emitter name;  // quotes it where it must be
  name << camera.name;
  std::string yaml = fmt::format("name: {}\nkind: {}\n", name.c_str(), to_string(camera.kind));
  yaml += fmt::format("image:\n  width_px: {}\n  height_px: {}\n", c.width, c.height);
  yaml += fmt::format("lens:\n  fx_px: {}\n  fy_px: {}\n  cx_px: {}\n  cy_px: {}\n", c.fx, c.fy, c.cx, c.cy);
  yaml += fmt::format("  distortion: [{}]  # k1, k2, p1, p2, k3\n", fmt::join(c.distortion, ", "));
  yaml += fmt::format("mounting:\n  x_m: {}\n  y_m: {}\n  height_m: {}\n", m.x, m.y, m.z);
  yaml += fmt::format("  roll_deg: {}\n  pitch_deg: {}\n  yaw_deg: {}\n", tidy_degrees(m.roll),
                      tidy_degrees(m.pitch), tidy_degrees(m.yaw));
  return yaml;
}

}  // namespace lanefuse
