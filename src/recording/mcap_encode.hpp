// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// Appends the record, opcode and length included, to `out`: the mirror of parse().
void append(Bytes& out, const Header& header);
void append(Bytes& out, const Footer& footer);
void append(Bytes& out, const Schema& schema);
void append(Bytes& out, const Channel& channel);
void append(Bytes& out, const Message& message);
void append(Bytes& out, const Chunk& chunk);
void append(Bytes& out, const MessageIndex& index);
void append(Bytes& out, const ChunkIndex& index);
void append(Bytes& out, const Attachment& attachment);
void append(Bytes& out, const AttachmentIndex& index);
void append(Bytes& out, const Metadata& metadata);
void append(Bytes& out, const MetadataIndex& index);
void append(Bytes& out, const Statistics& statistics);
void append(Bytes& out, const SummaryOffset& offset);
void append(Bytes& out, const DataEnd& data_end);

/// A message whose data lie elsewhere: `head.data` is not looked at.
void append(Bytes& out, const Message& head, std::span<const std::byte> data);

}  // namespace lanefuse::mcap
