// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_summary.hpp"

#include <algorithm>

#include "recording/mcap_parse.hpp"

namespace lanefuse::mcap {
namespace {

constexpr std::uint64_t kEndSize = kFooterSize + kMagic.size();

std::optional<Footer> read_footer(const InputFile& file, Damage& damage) {
  const std::uint64_t offset = file.size() < kEndSize ? 0 : file.size() - kEndSize;
  const auto head = file.record_head(offset);
  const Bytes magic = file.read(offset + kFooterSize, kMagic.size());
  const bool sound = offset >= kMagic.size() && head && head->opcode == Opcode::footer &&
                     head->end() == offset + kFooterSize &&
                     std::equal(magic.begin(), magic.end(), kMagic.begin(), kMagic.end());
  if (!sound) {
    damage.note(file.size(), "the file does not end with a footer: it is cut short or altered");
    return std::nullopt;
  }
  return parse<Footer>(file.content(*head));
}

// A summary too large to keep is no damage, only no help.
bool is_sound(const InputFile& file, const Footer& footer, std::uint64_t begin, std::uint64_t end,
              Damage& damage) {
  if (begin > end || begin < kMagic.size()) {
    damage.note(end, "the footer points outside the file");
    return false;
  }
  if (end - begin > kMaxSummary) {
    return false;
  }
  const std::uint64_t covered_end = end + kFooterSize - sizeof(footer.summary_crc);
  if (footer.summary_crc != 0 && file.crc(begin, covered_end) != footer.summary_crc) {
    damage.note(begin, "the summary's CRC does not match");
    return false;
  }
  return true;
}

bool add(const std::optional<Schema>& schema, Summary& summary) {
  return schema && (summary.schemas.emplace(schema->id, *schema), true);
}

bool add(const std::optional<Channel>& channel, Summary& summary) {
  return channel && (summary.channels.emplace(channel->id, *channel), true);
}

bool add(const std::optional<ChunkIndex>& index, std::uint64_t end, Summary& summary) {
  if (!index || index->chunk_start_offset > end || index->chunk_length > end - index->chunk_start_offset ||
      index->chunk_length < kRecordHeadSize) {
    return false;
  }
  if (summary.chunks.size() >= kMaxBlocks) {
    return false;
  }
  Block block{index->chunk_start_offset,
              index->chunk_length,
              index->message_start_time,
              index->uncompressed_size,
              true,
              {}};
  for (const auto& [channel, offset] : index->message_index_offsets) {
    block.channels.push_back(channel);
  }
  summary.chunks.emplace(block.offset, std::move(block));
  return true;
}

bool add(const RecordHead& head, const InputFile& file, std::uint64_t end, Summary& summary) {
  switch (head.opcode) {
    case Opcode::schema:
      return add(parse<Schema>(file.content(head)), summary);
    case Opcode::channel:
      return add(parse<Channel>(file.content(head)), summary);
    case Opcode::chunk_index:
      return add(parse<ChunkIndex>(file.content(head)), end, summary);
    default:
      return true;
  }
}

bool is_described(const Block& block, const Summary& summary) {
  const auto described = [&summary](std::uint16_t id) {
    const auto channel = summary.channels.find(id);
    return channel != summary.channels.end() &&
           (channel->second.schema_id == 0 || summary.schemas.contains(channel->second.schema_id));
  };
  return !block.channels.empty() && std::all_of(block.channels.begin(), block.channels.end(), described);
}

}  // namespace

std::optional<Summary> read_summary(const InputFile& file, Damage& damage) {
  const auto footer = read_footer(file, damage);
  if (!footer) {
    return std::nullopt;
  }
  Summary summary;
  summary.footer_offset = file.size() - kEndSize;
  std::uint64_t offset = footer->summary_start == 0 ? summary.footer_offset : footer->summary_start;
  if (!is_sound(file, *footer, offset, summary.footer_offset, damage)) {
    return std::nullopt;
  }
  std::uint64_t described = 0;
  while (offset < summary.footer_offset) {
    const auto head = file.record_head(offset);
    described += head && head->opcode <= Opcode::channel ? head->size : 0;
    if (described > kMaxDescriptions) {
      return std::nullopt;
    }
    if (!head || !add(*head, file, summary.footer_offset, summary)) {
      damage.note(offset, "the summary cannot be understood");
      return std::nullopt;
    }
    offset = head->end();
  }
  std::erase_if(summary.chunks,
                [&summary](const auto& entry) { return !is_described(entry.second, summary); });
  return summary;
}

}  // namespace lanefuse::mcap
