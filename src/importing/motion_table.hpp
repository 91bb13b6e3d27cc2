// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace lanefuse {

/// A car's motion over time as a user knows it, from a table of numbers.
class MotionTable {
 public:
  /// Reads a CSV file with the header `time_s,speed_mps` or `time_s,speed_mps,yaw_rate_radps`: seconds since
  /// the video's first frame, rising. Throws an input Error that names file and line.
  explicit MotionTable(const std::filesystem::path& file);

  struct Motion {
    double speed = 0;                ///< [m/s]
    std::optional<double> yaw_rate;  ///< [rad/s]
  };
  /// Between the rows around `seconds`; throws an input Error where the table does not reach there.
  [[nodiscard]] Motion at(double seconds) const;

 private:
  struct Row {
    double seconds = 0;
    double speed = 0;
    double yaw_rate = 0;
  };
  std::filesystem::path file_;
  bool has_yaw_rate_ = false;
  std::vector<Row> rows_;

  [[nodiscard]] Row parsed(const std::string& line, std::size_t number) const;
};

}  // namespace lanefuse
