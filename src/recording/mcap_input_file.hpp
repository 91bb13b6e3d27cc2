// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "recording/mcap_format.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// Where a record of a file is: all of it lies inside the file.
struct RecordHead {
  Opcode opcode{};
  std::uint64_t offset = 0;  ///< of the opcode
  std::uint64_t size = 0;    ///< of the content

  [[nodiscard]] std::uint64_t content() const { return offset + kRecordHeadSize; }
  [[nodiscard]] std::uint64_t end() const { return content() + size; }
};

/// A file read piece by piece, never mapped: one that shrinks meanwhile gives missing bytes, and no signal.
/// Throws Error (input) where the operating system cannot open or read it.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The bytes from `offset` on, `length` of them or as many as there are.
  [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t length) const;

  /// The record at `offset`, if its opcode is one and its end inside the file.
  [[nodiscard]] std::optional<RecordHead> record_head(std::uint64_t offset) const;

  /// The record's content, or the first `limit` bytes of it.
  [[nodiscard]] Bytes content(const RecordHead& head, std::uint64_t limit = kMaxRecord) const;

  [[nodiscard]] std::uint32_t crc(std::uint64_t begin, std::uint64_t end) const;

  /// Throws Error unless the file begins as an MCAP file of a version that is known.
  void check_magic() const;

 private:
  [[nodiscard]] std::size_t read_into(std::uint64_t offset, std::span<std::byte> bytes) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace lanefuse::mcap
