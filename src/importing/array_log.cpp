// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/array_log.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kLatestStamp = 9e9;      ///< [s] what Duration can hold
constexpr std::size_t kOneBadRowIn = 20;  ///< a log that is worse is not believed at all

struct ValueArray {
  const ArrayLogFiles::Values* description;
  NpyTable table;
};

struct BadRow {
  std::size_t row = 0;
  std::filesystem::path file;
  std::string problem;
};

/// All arrays of a log, row by row.
class LogArrays {
 public:
  explicit LogArrays(const ArrayLogFiles& files) : files_(files), times_(read_npy(files.times)) {
    if (times_.columns() != 1) throw input_error(files.times.string(), "is no list of time stamps");
    for (const ArrayLogFiles::Values& description : files.values) read_values(description);
  }

  [[nodiscard]] std::size_t rows() const { return times_.rows(); }
  [[nodiscard]] double seconds(std::size_t row) const { return times_(row, 0); }

  /// What is wrong with a row if `earliest` is the stamp of the row before.
  [[nodiscard]] std::optional<BadRow> judge(std::size_t row, double earliest) const {
    const double stamp = seconds(row);
    if (!(stamp >= 0 && stamp < kLatestStamp))
      return BadRow{row, files_.times, fmt::format("{} is no stamp", stamp)};
    if (stamp < earliest || overtakes_next(row, earliest)) return BadRow{row, files_.times, "time runs back"};
    for (const ValueArray& array : arrays_) {
      for (const std::size_t column : array.description->kept) {
        const double value = array.table(row, column);
        if (!std::isfinite(value))
          return BadRow{row, array.description->file, fmt::format("{} is no number", value)};
      }
    }
    return std::nullopt;
  }

  void append_row(std::size_t row, std::vector<double>& values) const {
    for (const ValueArray& array : arrays_) {
      for (const std::size_t column : array.description->kept) values.push_back(array.table(row, column));
    }
  }

 private:
  void read_values(const ArrayLogFiles::Values& description) {
    NpyTable table = read_npy(description.file);
    const std::string place = description.file.string();
    if (table.columns() != description.columns) {
      throw input_error(place,
                        fmt::format("has {} columns instead of {}", table.columns(), description.columns));
    }
    if (table.rows() != rows()) {
      throw input_error(place, fmt::format("has {} rows, its stamps in {} have {}", table.rows(),
                                           files_.times.string(), rows()));
    }
    arrays_.push_back({&description, std::move(table)});
  }

  /// A single stamp that is too late must not condemn all the good ones behind it.
  [[nodiscard]] bool overtakes_next(std::size_t row, double earliest) const {
    return row + 1 < rows() && seconds(row) > seconds(row + 1) && seconds(row + 1) >= earliest;
  }

  const ArrayLogFiles& files_;
  NpyTable times_;
  std::vector<ValueArray> arrays_;
};

std::string describe(const BadRow& bad) { return fmt::format("row {}: {}", bad.row, bad.problem); }

}  // namespace

ArrayLog read_array_log(const ArrayLogFiles& files, std::vector<std::string>& notes) {
  const LogArrays arrays(files);
  if (arrays.rows() == 0) throw input_error(files.times.string(), "holds nothing");
  std::vector<Time> times;
  std::vector<double> values;
  std::optional<BadRow> first_bad;
  std::size_t bad_rows = 0;
  double earliest = 0;
  for (std::size_t row = 0; row < arrays.rows(); ++row) {
    if (auto bad = arrays.judge(row, earliest)) {
      if (++bad_rows == 1) first_bad = std::move(bad);
      continue;
    }
    earliest = arrays.seconds(row);
    times.emplace_back(from_seconds(earliest));
    arrays.append_row(row, values);
  }
  if (first_bad) {
    if (bad_rows * kOneBadRowIn > arrays.rows()) {
      throw input_error(first_bad->file.string(), describe(*first_bad),
                        fmt::format("{} of {} rows are like this", bad_rows, arrays.rows()));
    }
    notes.push_back(fmt::format("{}: left out {} of {} rows; the first is {}", first_bad->file.string(),
                                bad_rows, arrays.rows(), describe(*first_bad)));
  }
  const std::size_t rows = times.size();
  const std::size_t columns = values.size() / rows;
  return {std::move(times), NpyTable(rows, columns, std::move(values))};
}

}  // namespace lanefuse
