// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

enum class Compression { none, lz4, zstd };

struct WriterConfig {
  Compression compression = Compression::zstd;
  /// A chunk is closed once it holds this many uncompressed bytes ...
  std::size_t chunk_size = std::size_t{1} << 20;
  /// ... or spans this much log time [ns]: what a killed program loses.
  std::uint64_t chunk_duration = 1'000'000'000;
  std::string profile{};
  std::string library = "lanefuse";
};

/// Writes an indexed MCAP file: chunks with CRC, message indexes, chunk, attachment and metadata indexes,
/// statistics, schemas and channels repeated in the summary, summary offsets, and the CRCs of data section
/// and summary.
///
/// It writes to `path` + ".part" and renames at close(): an existing file is never lost to a failed run. A
/// path that is there and no regular file (a device, a pipe) is written in place.
///
/// The same calls give the same bytes. Every operation throws Error (input, naming the file) where the disk
/// is full or fails; the writer is of no use after that.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path, WriterConfig config = {});
  ~Writer();  ///< without close() the .part file is removed
  Writer(Writer&&) noexcept;
  Writer& operator=(Writer&&) noexcept;

  /// The id to give to add_channel. Each call makes a new schema, at most 65535 of them.
  std::uint16_t add_schema(const std::string& name, const std::string& encoding,
                           std::span<const std::byte> data);

  /// The id to give to write(); `schema_id` is 0 for a channel without a schema. At most 65536 channels.
  /// Messages of channels of different groups never share a chunk, so that readers of one group leave the
  /// chunks of the others closed.
  std::uint16_t add_channel(const std::string& topic, const std::string& message_encoding,
                            std::uint16_t schema_id, StringMap metadata = {}, int group = 0);

  /// Times in nanoseconds. The sequence number counts the messages of the channel, from 0.
  void write(std::uint16_t channel_id, std::uint64_t log_time, std::uint64_t publish_time,
             std::span<const std::byte> data);

  /// The same with a sequence number of the caller's: `message.sequence` is written as it is.
  void write(const Message& message);

  void write(const Metadata& metadata);
  void write(const Attachment& attachment);

  /// Writes what is buffered and the summary, and puts the file in its place. Once only.
  void close();

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse::mcap
