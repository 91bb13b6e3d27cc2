// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// What a writer has written so far, for the end of the file.
struct WrittenSummary {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  Statistics statistics;
  std::vector<ChunkIndex> chunks;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;

  void count(const Message& head);
};

/// The summary section, summary offsets, footer and closing magic of a file whose data section ends at
/// `offset`.
Bytes encode_summary(const WrittenSummary& summary, std::uint64_t offset);

}  // namespace lanefuse::mcap
