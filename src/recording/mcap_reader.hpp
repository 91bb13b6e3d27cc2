// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "recording/mcap_damage.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// The messages of a file in order of log time (equal times: in file order), through the index when there is
/// one, by scanning when there is none. Overlapping chunks are merged; memory is bounded by a few chunks,
/// whatever the file.
///
/// A damaged file gives all that checks out: a chunk with a wrong CRC is skipped and counted, a missing or
/// altered summary is replaced by scanning, a broken record by searching for the next sound chunk. damage()
/// says so, and the caller decides what that means.
class Reader {
 public:
  /// Throws Error (input), naming file and byte, where nothing can be read: no MCAP, another major version,
  /// no sound header and no sound chunk.
  explicit Reader(const std::filesystem::path& path);
  ~Reader();
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;

  [[nodiscard]] const Header& header() const;
  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const;
  [[nodiscard]] const std::map<std::uint16_t, Channel>& channels() const;
  [[nodiscard]] const std::vector<Metadata>& metadata() const;

  /// Without their contents: name, type, times. read_attachment() fetches `data`, checked against its CRC.
  [[nodiscard]] const std::vector<AttachmentIndex>& attachments() const;
  [[nodiscard]] Attachment read_attachment(const AttachmentIndex& entry) const;

  /// From here on give only messages of channels that `wanted` accepts; chunks without them are never opened.
  /// Rewinds to the first message.
  void select(const std::function<bool(const Channel&)>& wanted);

  /// The next message into `message`, whose memory is reused; false at the end.
  bool next(Message& message);
  std::optional<Message> next();

  /// What was lost so far: complete once next() has come to the end.
  [[nodiscard]] const Damage& damage() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse::mcap
