// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "recording/mcap_compression.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// Gathers the records of one chunk and where its messages are.
class ChunkBuilder {
 public:
  void add(const Schema& schema);
  void add(const Channel& channel);
  void add(const Message& head, std::span<const std::byte> data);

  [[nodiscard]] bool empty() const { return records_.empty(); }
  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// Log time from the earliest to the latest message if one at `log_time` came in [ns].
  [[nodiscard]] std::uint64_t span_with(std::uint64_t log_time) const;

  /// Appends chunk and message indexes, which will lie at `offset` of the file, to `out`; the builder is
  /// empty after.
  ChunkIndex finish(Compression compression, std::uint64_t offset, Bytes& out);

 private:
  ChunkIndex append_message_indexes(ChunkIndex entry, std::uint64_t offset, Bytes& out) const;

  Bytes records_;
  std::map<std::uint16_t, MessageIndex> indexes_;
  std::uint64_t start_time_ = 0;
  std::uint64_t end_time_ = 0;
};

}  // namespace lanefuse::mcap
