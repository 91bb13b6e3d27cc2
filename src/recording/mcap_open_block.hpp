// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// Channels by id: which are defined, which are asked for.
struct ChannelFilter {
  std::vector<bool> known = std::vector<bool>(65536);
  std::vector<bool> wanted = std::vector<bool>(65536);
};

/// A block's records in memory, with the wanted messages among them in order of log time (ties: as stored).
class OpenBlock {
 public:
  OpenBlock(Bytes records, const ChannelFilter& filter);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(offsets_.size()); }
  [[nodiscard]] std::uint64_t time(std::uint32_t rank) const { return head(offsets_[rank]).log_time; }
  void read(std::uint32_t rank, Message& message) const;

  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// Messages of channels that nobody defined, and records that could not be understood.
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }

 private:
  [[nodiscard]] Message head(std::uint32_t offset) const;

  Bytes records_;
  // Four bytes a message: a chunk of the largest size can hold eight million.
  std::vector<std::uint32_t> offsets_;
  std::uint64_t unreadable_ = 0;
};

}  // namespace lanefuse::mcap
