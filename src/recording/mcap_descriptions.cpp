// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_descriptions.hpp"

#include <utility>

#include <fmt/format.h>

namespace lanefuse::mcap {

void Descriptions::take(const RawRecord& record, std::uint64_t place) {
  switch (record.opcode) {
    case Opcode::header:
      if (auto header = parse<Header>(record.content); header && has_room(record.content.size(), place)) {
        survey_.header = std::move(*header);
      } else {
        lose(place, "the header");
      }
      return;
    case Opcode::schema:
      return define(survey_.schemas, record, place);
    case Opcode::channel:
      return define(survey_.channels, record, place);
    case Opcode::metadata:
      if (auto metadata = parse<Metadata>(record.content); !metadata) {
        lose(place, "a metadata record");
      } else if (has_room(record.content.size(), place)) {
        survey_.metadata.push_back(std::move(*metadata));
      }
      return;
    default:
      return;
  }
}

template <typename Record>
void Descriptions::define(std::map<std::uint16_t, Record>& known, const RawRecord& record,
                          std::uint64_t place) {
  auto parsed = parse<Record>(record.content);
  if (!parsed) {
    return lose(place, "a schema or channel");
  }
  const auto before = known.find(parsed->id);
  if (before == known.end()) {
    if (has_room(record.content.size(), place)) {
      known.emplace(parsed->id, std::move(*parsed));
    }
  } else if (before->second != *parsed) {
    survey_.damage.note(place,
                        fmt::format("schema or channel {} is defined again, and differently", parsed->id));
  }
}

bool Descriptions::has_room(std::uint64_t bytes, std::uint64_t place) {
  if (bytes > kMaxDescriptions - kept_) {
    survey_.damage.note(place,
                        fmt::format("schemas, channels and metadata exceed {} bytes", kMaxDescriptions));
    ++survey_.damage.records_lost;
    return false;
  }
  kept_ += bytes;
  return true;
}

void Descriptions::lose(std::uint64_t place, const char* what) {
  survey_.damage.note(place, fmt::format("{} cannot be understood", what));
  ++survey_.damage.records_lost;
}

void Descriptions::check_schemas() {
  for (const auto& [id, channel] : survey_.channels) {
    if (channel.schema_id != 0 && !survey_.schemas.contains(channel.schema_id)) {
      survey_.damage.note(0, fmt::format("schema {} of channel {} ({}) is not in the file", channel.schema_id,
                                         id, channel.topic));
    }
  }
}

}  // namespace lanefuse::mcap
