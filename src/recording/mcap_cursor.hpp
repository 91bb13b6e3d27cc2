// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// Takes little-endian values off the front of some bytes, never beyond their end: once something did not
/// fit, ok() stays false and everything taken is empty or zero. So a parser asks once, at its end.
class Cursor {
 public:
  explicit Cursor(std::span<const std::byte> bytes) : rest_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  std::span<const std::byte> take(std::uint64_t count) {
    if (count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const auto front = rest_.first(count);
    rest_ = rest_.subspan(count);
    return front;
  }

  template <std::unsigned_integral T>
  T integer() {
    std::uint64_t value = 0;
    int shift = 0;
    for (const std::byte byte : take(sizeof(T))) {
      value |= std::to_integer<std::uint64_t>(byte) << shift;
      shift += 8;
    }
    return static_cast<T>(value);
  }

  std::string text();
  StringMap text_map();

  /// The pairs of a map in bytes (prefixed by its size): `take_pair` is called until they are used up.
  template <typename TakePair>
  void pairs(TakePair take_pair) {
    Cursor inside(take(integer<std::uint32_t>()));
    while (inside.ok_ && inside.left() > 0) {
      take_pair(inside);
    }
    ok_ = ok_ && inside.ok_;
  }

  /// Says that what was taken makes no sense.
  void fail() { ok_ = false; }

 private:
  std::span<const std::byte> rest_;
  bool ok_ = true;
};

inline Bytes to_bytes(std::span<const std::byte> view) { return {view.begin(), view.end()}; }

}  // namespace lanefuse::mcap
