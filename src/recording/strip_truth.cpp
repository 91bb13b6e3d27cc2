// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "core/error.hpp"
#include "recording/drive_truth.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/topics.hpp"

namespace lanefuse {
namespace {

mcap::WriterConfig config_like(const mcap::Header& header) {
  mcap::WriterConfig config;
  config.profile = header.profile;
  config.library = header.library;
  return config;
}

/// Gives the channels of one file their places in another.
class ChannelCopier {
 public:
  ChannelCopier(const mcap::Reader& from, mcap::Writer& to) : from_(from), to_(to) {}

  std::uint16_t channel(std::uint16_t id) {
    const auto found = channels_.find(id);
    if (found != channels_.end()) return found->second;
    const mcap::Channel& channel = from_.channels().at(id);
    return channels_[id] = to_.add_channel(channel.topic, channel.message_encoding, schema(channel.schema_id),
                                           channel.metadata);
  }

 private:
  std::uint16_t schema(std::uint16_t id) {
    if (id == 0) return 0;
    const auto found = schemas_.find(id);
    if (found != schemas_.end()) return found->second;
    const mcap::Schema& schema = from_.schemas().at(id);
    return schemas_[id] = to_.add_schema(schema.name, schema.encoding, schema.data);
  }

  const mcap::Reader& from_;
  mcap::Writer& to_;
  std::map<std::uint16_t, std::uint16_t> channels_;
  std::map<std::uint16_t, std::uint16_t> schemas_;
};

}  // namespace

void strip_truth(const std::filesystem::path& in, const std::filesystem::path& out) {
  mcap::Reader reader(in);
  mcap::Writer writer(out, config_like(reader.header()));
  for (const mcap::Metadata& record : reader.metadata()) writer.write(record);
  for (const mcap::AttachmentIndex& entry : reader.attachments()) writer.write(reader.read_attachment(entry));
  ChannelCopier copier(reader, writer);
  reader.select([](const mcap::Channel& channel) { return !topic::is_truth(channel.topic); });
  for (mcap::Message message; reader.next(message);) {
    message.channel_id = copier.channel(message.channel_id);
    writer.write(message);
  }
  if (reader.damage().any) throw input_error(in.string(), reader.damage().first_place);
  writer.close();
}

}  // namespace lanefuse
