// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/time.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/read_report.hpp"
#include "recording/recording_head.hpp"

namespace lanefuse {

/// Private to this folder: a recording that is being read, topic by topic, with account of what was lost.
class TopicReader {
 public:
  /// Throws Error (input) where the file is no recording of this kind and version.
  TopicReader(const std::filesystem::path& path, RecordingHead::Kind kind);

  [[nodiscard]] const RecordingHead& head() const { return head_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::map<std::uint16_t, mcap::Channel>& channels() const { return reader_.channels(); }
  [[nodiscard]] ReadReport report() const;

  /// From here on gives only messages of topics that `wanted` accepts, from the first on; chunks without them
  /// stay closed.
  void select(const std::function<bool(std::string_view topic)>& wanted);

  /// The next message, valid until the next call, in order of log time. False at the end.
  bool next();
  [[nodiscard]] const mcap::Message& message() const { return message_; }
  [[nodiscard]] const mcap::Channel& channel() const;
  [[nodiscard]] Time log_time() const;

  /// Whether some channel carries `topic`.
  [[nodiscard]] bool has(std::string_view topic) const;

  /// Counts the message just read as no message of its kind.
  void refuse(const std::string& problem);

 private:
  /// Throws Error (input) where a topic that is known carries something else.
  void check(const mcap::Channel& channel) const;

  std::string file_;
  mcap::Reader reader_;
  RecordingHead head_;
  mcap::Message message_;
  std::uint64_t refused_ = 0;
  std::string first_refusal_;
};

}  // namespace lanefuse
