// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_chunk_builder.hpp"

#include <algorithm>
#include <cassert>

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_encode.hpp"
#include "recording/mcap_format.hpp"

namespace lanefuse::mcap {

void ChunkBuilder::add(const Schema& schema) { append(records_, schema); }

void ChunkBuilder::add(const Channel& channel) { append(records_, channel); }

void ChunkBuilder::add(const Message& head, std::span<const std::byte> data) {
  start_time_ = indexes_.empty() ? head.log_time : std::min(start_time_, head.log_time);
  end_time_ = indexes_.empty() ? head.log_time : std::max(end_time_, head.log_time);
  MessageIndex& index = indexes_[head.channel_id];
  index.channel_id = head.channel_id;
  index.records.push_back({head.log_time, records_.size()});
  append(records_, head, data);
}

std::uint64_t ChunkBuilder::span_with(std::uint64_t log_time) const {
  return indexes_.empty() ? 0 : std::max(end_time_, log_time) - std::min(start_time_, log_time);
}

ChunkIndex ChunkBuilder::finish(Compression compression, std::uint64_t offset, Bytes& out) {
  assert(!empty());
  Bytes packed = compress(compression, records_);
  if (records_.size() / kMaxCompressionRatio > packed.size()) {
    // A reader would take it for an attack on its memory.
    compression = Compression::none;
    packed = records_;
  }
  const std::size_t begin = out.size();
  append(out,
         Chunk{start_time_, end_time_, records_.size(), crc32(records_), to_string(compression), packed});

  ChunkIndex entry;
  entry.message_start_time = start_time_;
  entry.message_end_time = end_time_;
  entry.chunk_start_offset = offset;
  entry.chunk_length = out.size() - begin;
  entry.compression = to_string(compression);
  entry.compressed_size = packed.size();
  entry.uncompressed_size = records_.size();
  const std::uint64_t indexes_at = offset + entry.chunk_length;
  entry = append_message_indexes(std::move(entry), indexes_at, out);
  *this = {};
  return entry;
}

ChunkIndex ChunkBuilder::append_message_indexes(ChunkIndex entry, std::uint64_t offset, Bytes& out) const {
  const std::size_t begin = out.size();
  for (const auto& [channel, index] : indexes_) {
    entry.message_index_offsets[channel] = offset + (out.size() - begin);
    append(out, index);
  }
  entry.message_index_length = out.size() - begin;
  return entry;
}

}  // namespace lanefuse::mcap
