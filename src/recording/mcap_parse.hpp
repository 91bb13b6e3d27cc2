// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "recording/mcap_format.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// A record as it lies in a file or a chunk: `content` is a view.
struct RawRecord {
  Opcode opcode{};
  std::uint64_t offset = 0;  ///< of the opcode, from the start of the file or of the chunk's records
  std::span<const std::byte> content;
};

/// `content` of a record as plain data; nothing where it does not hold what such a record must. Bytes after
/// the last known field are ignored: a later minor version may have put them there. An attachment must match
/// its CRC. There is one for every record of mcap_records.hpp.
template <typename Record>
std::optional<Record> parse(std::span<const std::byte> content);

/// A message's fields without its data, for those who only want to know channel and time.
std::optional<Message> parse_message_head(std::span<const std::byte> content);

/// An attachment's fields without its data (of which only the beginning need be in `content`): `offset`,
/// `length` are left to the caller.
std::optional<AttachmentIndex> parse_attachment_head(std::span<const std::byte> content);

/// The record at `offset` of `records`; nothing at their end or where none fits.
std::optional<RawRecord> record_at(std::span<const std::byte> records, std::uint64_t offset);

}  // namespace lanefuse::mcap
