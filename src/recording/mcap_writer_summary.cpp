// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_writer_summary.hpp"

#include <algorithm>

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_encode.hpp"
#include "recording/mcap_format.hpp"

namespace lanefuse::mcap {
namespace {

// Appends records of one kind and says where they are.
template <typename Records>
void append_group(Bytes& out, Opcode opcode, std::uint64_t offset, const Records& records,
                  std::vector<SummaryOffset>& groups) {
  const std::size_t begin = out.size();
  for (const auto& record : records) {
    append(out, record);
  }
  if (out.size() > begin) {
    groups.push_back({static_cast<std::uint8_t>(opcode), offset + begin, out.size() - begin});
  }
}

}  // namespace

void WrittenSummary::count(const Message& head) {
  const bool first = statistics.message_count == 0;
  statistics.message_start_time =
      first ? head.log_time : std::min(statistics.message_start_time, head.log_time);
  statistics.message_end_time = first ? head.log_time : std::max(statistics.message_end_time, head.log_time);
  ++statistics.message_count;
  ++statistics.channel_message_counts[head.channel_id];
}

Bytes encode_summary(const WrittenSummary& summary, std::uint64_t offset) {
  Bytes out;
  std::vector<SummaryOffset> groups;
  append_group(out, Opcode::schema, offset, summary.schemas, groups);
  append_group(out, Opcode::channel, offset, summary.channels, groups);
  append_group(out, Opcode::statistics, offset, std::vector{summary.statistics}, groups);
  append_group(out, Opcode::chunk_index, offset, summary.chunks, groups);
  append_group(out, Opcode::attachment_index, offset, summary.attachments, groups);
  append_group(out, Opcode::metadata_index, offset, summary.metadata, groups);

  Footer footer{offset, offset + out.size(), 0};
  for (const SummaryOffset& group : groups) {
    append(out, group);
  }
  append(out, footer);
  // The CRC, last in the footer, covers all of the summary and the footer up to itself.
  footer.summary_crc = crc32(std::span(out).first(out.size() - sizeof(footer.summary_crc)));
  out.resize(out.size() - kFooterSize);
  append(out, footer);
  out.insert(out.end(), kMagic.begin(), kMagic.end());
  return out;
}

}  // namespace lanefuse::mcap
