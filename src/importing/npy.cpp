// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/npy.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "importing/npy_header.hpp"

namespace lanefuse {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are taken from the file as they are");

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::uintmax_t kLargestFile = std::uintmax_t{256}
                                        << 20U;       ///< a minute of a drive has a few megabytes
constexpr double kLargestWhole = 9007199254740992.0;  ///< 2^53: beyond, a double skips numbers

/// How to take one number out of the file's bytes.
struct NumberType {
  std::size_t size = 0;
  double (*read)(const char* bytes) = nullptr;
};

template <typename Number>
double read_number(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

template <typename Number>
NumberType number_type() {
  return {sizeof(Number), &read_number<Number>};
}

std::optional<NumberType> find_number_type(std::string_view type) {
  if (type == "<f8") return number_type<double>();
  if (type == "<f4") return number_type<float>();
  if (type == "<i8") return number_type<std::int64_t>();
  if (type == "<i4") return number_type<std::int32_t>();
  if (type == "<i2") return number_type<std::int16_t>();
  if (type == "|i1") return number_type<std::int8_t>();
  if (type == "<u8") return number_type<std::uint64_t>();
  if (type == "<u4") return number_type<std::uint32_t>();
  if (type == "<u2") return number_type<std::uint16_t>();
  if (type == "|u1" || type == "|b1") return number_type<std::uint8_t>();
  return std::nullopt;
}

NumberType require_number_type(const std::string& type, const std::string& place) {
  if (const auto found = find_number_type(type)) return *found;
  if (type.find('O') != std::string::npos) throw input_error(place, "holds Python objects, not numbers");
  if (type.starts_with('>')) throw input_error(place, fmt::format("type '{}' is big-endian", type));
  throw input_error(place, fmt::format("type '{}' is not read", type), "floats and whole numbers are");
}

/// Where the header's text lies: behind magic, version and its own length (two bytes in version 1, four in
/// 2).
struct HeaderSpan {
  std::size_t begin = 0;
  std::size_t size = 0;
};

HeaderSpan find_header(std::string_view bytes, const std::string& place) {
  if (!bytes.starts_with(kMagic))
    throw input_error(place, "is no NumPy array: it does not begin with \\x93NUMPY");
  if (bytes.size() < kMagic.size() + 2) throw input_error(place, "ends inside its version");
  const int version = static_cast<unsigned char>(bytes[kMagic.size()]);
  if (version != 1 && version != 2)
    throw input_error(place, fmt::format("format version {} is unknown", version));
  const std::size_t length_at = kMagic.size() + 2;
  const std::size_t length_size = version == 1 ? 2 : 4;
  if (bytes.size() < length_at + length_size)
    throw input_error(place, "ends inside the length of its header");
  const char* length = bytes.data() + length_at;
  const auto size = static_cast<std::size_t>(version == 1 ? read_number<std::uint16_t>(length)
                                                          : read_number<std::uint32_t>(length));
  const std::size_t begin = length_at + length_size;
  if (size > bytes.size() - begin) throw input_error(place, "ends inside its header");
  return {begin, size};
}

/// Rows and columns whose numbers fill exactly `available` bytes.
void check_size(const NpyHeader& header, std::size_t number_size, std::size_t available,
                const std::string& place) {
  std::size_t needed = number_size;
  for (const std::size_t length : header.shape) {
    if (length != 0 && needed > available / length) {
      throw input_error(
          place, fmt::format("its shape needs more than the {} bytes that follow the header", available));
    }
    needed *= length;
  }
  if (needed != available) {
    throw input_error(place,
                      fmt::format("its shape needs {} bytes, {} follow the header", needed, available));
  }
}

}  // namespace

NpyTable::NpyTable(std::size_t rows, std::size_t columns, std::vector<double> row_major)
    : rows_(rows), columns_(columns), values_(std::move(row_major)) {
  assert(values_.size() == rows * columns);
}

NpyTable parse_npy(std::string_view bytes, const std::string& place) {
  const HeaderSpan span = find_header(bytes, place);
  const NpyHeader header = parse_npy_header(bytes.substr(span.begin, span.size), place);
  const NumberType type = require_number_type(header.type, place);
  if (header.shape.empty() || header.shape.size() > 2) {
    throw input_error(place, fmt::format("has {} dimensions", header.shape.size()), "one or two are read");
  }
  const std::string_view data = bytes.substr(span.begin + span.size);
  check_size(header, type.size, data.size(), place);
  const std::size_t rows = header.shape[0];
  const std::size_t columns = header.shape.size() == 2 ? header.shape[1] : 1;
  std::vector<double> values(rows * columns);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t stored = header.fortran_order ? i % columns * rows + i / columns : i;
    values[i] = type.read(data.data() + stored * type.size);
    if (header.type[1] != 'f' && std::abs(values[i]) > kLargestWhole) {
      throw input_error(place, fmt::format("row {}: a whole number beyond 2^53", i / columns));
    }
  }
  return {rows, columns, std::move(values)};
}

NpyTable read_npy(const std::filesystem::path& file) {
  const std::string place = file.string();
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (failure) throw input_error(place, "cannot be read: " + failure.message());
  if (size > kLargestFile)
    throw input_error(place, fmt::format("has {} bytes, more than any log's array", size));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw input_error(place, "cannot be read");
  return parse_npy(bytes, place);
}

}  // namespace lanefuse
