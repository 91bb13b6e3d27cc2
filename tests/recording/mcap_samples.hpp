// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "recording/mcap_reader.hpp"
#include "recording/mcap_writer.hpp"

namespace lanefuse::mcap {

inline Bytes bytes_of(const std::string& text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

/// A file with `count` messages on two channels, in several chunks, with metadata and an attachment.
/// Message i is at i milliseconds, and its data are "message i".
inline void write_sample(const std::filesystem::path& path, int count, const WriterConfig& config) {
  Writer writer(path, config);
  const auto schema = writer.add_schema("test.Text", "text", bytes_of("any text"));
  const auto even = writer.add_channel("/even", "text", schema, {{"unit", "m"}});
  const auto odd = writer.add_channel("/odd", "text", 0);
  writer.write(Metadata{"about", {{"seed", "1"}, {"title", "a sample"}}});
  for (int i = 0; i < count; ++i) {
    const auto time = static_cast<std::uint64_t>(i) * 1'000'000;
    writer.write(i % 2 == 0 ? even : odd, time, time + 5, bytes_of("message " + std::to_string(i)));
  }
  writer.write(Attachment{7, 8, "note.txt", "text/plain", bytes_of("attached")});
  writer.close();
}

inline std::vector<Message> read_all(Reader& reader) {
  std::vector<Message> messages;
  while (auto message = reader.next()) {
    messages.push_back(std::move(*message));
  }
  return messages;
}

inline std::vector<Message> read_all(const std::filesystem::path& path) {
  Reader reader(path);
  return read_all(reader);
}

}  // namespace lanefuse::mcap
