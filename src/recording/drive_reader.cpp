// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/drive_reader.hpp"

#include <charconv>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/measurement_codec.hpp"
#include "recording/rig_codec.hpp"
#include "recording/topic_reader.hpp"
#include "recording/topics.hpp"

namespace lanefuse {

class DriveReader::Session {
 public:
  explicit Session(const std::filesystem::path& path) : topics_(path, RecordingHead::Kind::drive) {
    read_rig();
    if (!topics_.has(topic::kVehicleMotion)) refuse_without(topic::kVehicleMotion);
    for (const auto& [id, channel] : topics_.channels()) {
      if (decoder_of(channel.topic)) sensors_[id] = sensor_of(channel);
    }
    topics_.select([](std::string_view topic) { return decoder_of(topic) != nullptr; });
  }

  [[nodiscard]] const DriveInfo& info() const { return topics_.head().drive; }
  [[nodiscard]] const Rig& rig() const { return rig_; }
  [[nodiscard]] ReadReport report() const { return topics_.report(); }

  bool next(Measurement& measurement) {
    while (topics_.next()) {
      try {
        measurement = decoder_of(topics_.channel().topic)(topics_.message().data, stamp());
        return true;
      } catch (const Error& error) {
        topics_.refuse(error.what());
      }
    }
    return false;
  }

 private:
  void read_rig() {
    topics_.select([](std::string_view topic) { return topic == topic::kCalibration; });
    if (!topics_.next()) refuse_without(topic::kCalibration);
    rig_ = decode_rig(topics_.message().data);
  }

  [[noreturn]] void refuse_without(const char* topic) const {
    throw input_error(topics_.file(), fmt::format("it has no channel {}", topic), "a drive needs it");
  }

  [[nodiscard]] std::uint32_t sensor_of(const mcap::Channel& channel) const {
    const auto entry = channel.metadata.find("sensor_id");
    const std::string text = entry == channel.metadata.end() ? "" : entry->second;
    std::uint32_t id = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), id);
    const bool is_number = problem == std::errc{} && end == text.data() + text.size();
    if (!is_number || !rig_.find(id)) {
      throw input_error(topics_.file(), fmt::format("channel {} names sensor \"{}\", which is not in the rig",
                                                    channel.topic, text));
    }
    return id;
  }

  [[nodiscard]] Stamp stamp() const {
    const mcap::Message& message = topics_.message();
    return {from_nanoseconds(static_cast<std::int64_t>(message.publish_time)), topics_.log_time(),
            sensors_.at(message.channel_id)};
  }

  TopicReader topics_;
  Rig rig_;
  std::map<std::uint16_t, std::uint32_t> sensors_;
};

DriveReader::DriveReader(const std::filesystem::path& path) : session_(std::make_unique<Session>(path)) {}
DriveReader::~DriveReader() = default;
DriveReader::DriveReader(DriveReader&&) noexcept = default;
DriveReader& DriveReader::operator=(DriveReader&&) noexcept = default;

const DriveInfo& DriveReader::info() const { return session_->info(); }
const Rig& DriveReader::rig() const { return session_->rig(); }
bool DriveReader::next(Measurement& measurement) { return session_->next(measurement); }
ReadReport DriveReader::report() const { return session_->report(); }

}  // namespace lanefuse
