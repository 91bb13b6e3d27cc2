// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "recording/mcap_input_file.hpp"
#include "recording/mcap_parse.hpp"

namespace lanefuse::mcap {

/// Every record of a sound file in the order of the file, up to the footer: for conversion, inspection and
/// tests of conformance. It forgives nothing: damage is an Error that names the byte. (Reader salvages.)
class RecordReader {
 public:
  enum class Chunks {
    whole,     ///< a chunk is a record as any other
    unpacked,  ///< the records in it are given in its place
  };

  explicit RecordReader(const std::filesystem::path& path, Chunks chunks = Chunks::unpacked);

  /// The next record, whose content is valid until the next call; nothing after the footer.
  std::optional<RawRecord> next();

 private:
  RecordHead next_head();
  std::optional<RawRecord> next_in_chunk();
  [[noreturn]] void fail(std::uint64_t byte, const std::string& problem) const;

  InputFile file_;
  Chunks chunks_;
  std::uint64_t offset_ = kMagic.size();
  Bytes content_;
  Bytes chunk_;
  std::uint64_t offset_in_chunk_ = 0;
  std::uint64_t chunk_offset_ = 0;
  bool at_end_ = false;
};

}  // namespace lanefuse::mcap
