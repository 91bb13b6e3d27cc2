// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/time.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/recording_head.hpp"

namespace lanefuse {

/// Private to this folder: a recording that is being written, topic by topic. Schemas and channels come with
/// a topic's first message; every sensor has a channel of its own on its topic. What lies below /truth/ goes
/// into chunks of its own, so that reading the rest never opens it.
class TopicWriter {
 public:
  TopicWriter(const std::filesystem::path& path, const RecordingHead& head);

  struct Place {
    const char* topic;
    std::optional<std::uint32_t> sensor_id = {};
  };

  /// Throws Error (input) for times before the epoch, and where the disk fails.
  void write(const Place& place, Time measured_at, Time received_at, std::span<const std::byte> message);

  void write(const Place& place, Time time, std::span<const std::byte> message) {
    write(place, time, time, message);
  }

  void close() { writer_.close(); }

 private:
  std::uint16_t channel_of(const Place& place);
  std::uint16_t add_channel(const Place& place);
  std::uint64_t nanoseconds(Time time, const char* topic) const;

  std::string file_;
  mcap::Writer writer_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::pair<std::string, std::optional<std::uint32_t>>, std::uint16_t> channels_;
};

}  // namespace lanefuse
