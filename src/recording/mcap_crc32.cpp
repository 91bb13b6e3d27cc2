// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_crc32.hpp"

#include <array>

namespace lanefuse::mcap {
namespace {

// Eight tables: the k-th advances a byte through k further zero bytes, so that eight bytes go in one step. A
// recording is hundreds of megabytes, and one byte at a time would take longer than reading it.
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t value = 0; value < 256; ++value) {
    std::uint32_t crc = value;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    tables[0][value] = crc;
  }
  for (std::size_t table = 1; table < tables.size(); ++table) {
    for (std::size_t value = 0; value < 256; ++value) {
      const std::uint32_t shorter = tables[table - 1][value];
      tables[table][value] = (shorter >> 8) ^ tables[0][shorter & 0xFFU];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

constexpr std::size_t kStep = kTables.size();

std::uint32_t eight_bytes(std::span<const std::byte, kStep> bytes, std::uint32_t crc) {
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < kStep; ++i) {
    const std::uint32_t mixed_in = i < 4 ? (crc >> (8 * i)) & 0xFFU : 0U;
    result ^= kTables[kStep - 1 - i][std::to_integer<std::uint32_t>(bytes[i]) ^ mixed_in];
  }
  return result;
}

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) {
  std::uint32_t crc = ~before;
  while (bytes.size() >= kStep) {
    crc = eight_bytes(bytes.first<kStep>(), crc);
    bytes = bytes.subspan(kStep);
  }
  for (const std::byte byte : bytes) {
    crc = (crc >> 8) ^ kTables[0][(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xFFU];
  }
  return ~crc;
}

}  // namespace lanefuse::mcap
