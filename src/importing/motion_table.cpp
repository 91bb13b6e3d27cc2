// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/motion_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr const char* kHeader = "time_s,speed_mps";
constexpr const char* kHeaderWithYawRate = "time_s,speed_mps,yaw_rate_radps";

void drop_carriage_return(std::string& line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
}

/// The numbers between commas; nothing where one is none.
std::vector<double> numbers(const std::string& line) {
  std::vector<double> found;
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  while (at < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    found.push_back(value);
    if (next == end) return found;
    if (*next != ',') return {};
    at = next + 1;
  }
  return {};
}

}  // namespace

MotionTable::MotionTable(const std::filesystem::path& file) : file_(file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw input_error(file.string(), "cannot be read");
  drop_carriage_return(line);
  has_yaw_rate_ = line == kHeaderWithYawRate;
  if (!has_yaw_rate_ && line != kHeader) {
    throw input_error(fmt::format("{}, line 1", file.string()), fmt::format("the header is \"{}\"", line),
                      fmt::format("begin with \"{}\" or \"{}\"", kHeader, kHeaderWithYawRate));
  }
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    drop_carriage_return(line);
    if (!line.empty()) rows_.push_back(parsed(line, number));
  }
  if (rows_.empty()) throw input_error(file.string(), "holds no rows");
}

MotionTable::Row MotionTable::parsed(const std::string& line, std::size_t number) const {
  const std::string place = fmt::format("{}, line {}", file_.string(), number);
  const std::vector<double> values = numbers(line);
  const std::size_t wanted = has_yaw_rate_ ? 3 : 2;
  if (values.size() != wanted) {
    throw input_error(place, fmt::format("\"{}\" does not hold {} numbers", line, wanted));
  }
  if (!rows_.empty() && values[0] <= rows_.back().seconds) throw input_error(place, "time does not rise");
  return {values[0], values[1], has_yaw_rate_ ? values[2] : 0};
}

MotionTable::Motion MotionTable::at(double seconds) const {
  const auto after = std::lower_bound(rows_.begin(), rows_.end(), seconds,
                                      [](const Row& row, double time) { return row.seconds < time; });
  constexpr double kReach = 0.1;  // [s] beyond the ends
  if (seconds < rows_.front().seconds - kReach || seconds > rows_.back().seconds + kReach) {
    throw input_error(file_.string(), fmt::format("does not reach the frame at {} s", seconds),
                      "give motion for the whole video");
  }
  const Row& second = after == rows_.end() ? rows_.back() : *after;
  const Row& first = after == rows_.begin() || after == rows_.end() ? second : *(after - 1);
  const double span = second.seconds - first.seconds;
  const double share = span > 0 ? (seconds - first.seconds) / span : 0;
  Motion motion{.speed = first.speed + share * (second.speed - first.speed), .yaw_rate = {}};
  if (has_yaw_rate_) motion.yaw_rate = first.yaw_rate + share * (second.yaw_rate - first.yaw_rate);
  return motion;
}

}  // namespace lanefuse
