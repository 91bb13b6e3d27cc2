// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_open_block.hpp"

#include <algorithm>
#include <utility>

#include "recording/mcap_parse.hpp"

namespace lanefuse::mcap {

OpenBlock::OpenBlock(Bytes records, const ChannelFilter& filter) : records_(std::move(records)) {
  std::uint64_t offset = 0;
  while (auto record = record_at(records_, offset)) {
    offset += kRecordHeadSize + record->content.size();
    if (record->opcode != Opcode::message) {
      continue;
    }
    const auto message = parse_message_head(record->content);
    if (!message || !filter.known[message->channel_id]) {
      ++unreadable_;
    } else if (filter.wanted[message->channel_id]) {
      offsets_.push_back(static_cast<std::uint32_t>(record->offset));
    }
  }
  unreadable_ += offset < records_.size() ? 1 : 0;
  const auto earlier = [this](std::uint32_t a, std::uint32_t b) {
    return std::pair(head(a).log_time, a) < std::pair(head(b).log_time, b);
  };
  if (!std::is_sorted(offsets_.begin(), offsets_.end(), earlier)) {
    std::sort(offsets_.begin(), offsets_.end(), earlier);
  }
}

Message OpenBlock::head(std::uint32_t offset) const {
  return *parse_message_head(record_at(records_, offset)->content);
}

void OpenBlock::read(std::uint32_t rank, Message& message) const {
  const auto record = record_at(records_, offsets_[rank]);
  Message fields = *parse_message_head(record->content);
  const auto data = record->content.subspan(kMessageHeadSize);
  fields.data = std::move(message.data);
  fields.data.assign(data.begin(), data.end());
  message = std::move(fields);
}

}  // namespace lanefuse::mcap
