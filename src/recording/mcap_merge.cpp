// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_merge.hpp"

#include <algorithm>
#include <utility>

namespace lanefuse::mcap {
namespace {

// Unpacked blocks in memory at once: room for the largest that is allowed.
constexpr std::uint64_t kMaxResident = kMaxChunk;

}  // namespace

Merge::Merge(const InputFile& file, Survey& survey)
    : file_(file), survey_(survey), known_(survey.blocks.size(), Known::nothing) {}

void Merge::rewind(ChannelFilter filter) {
  filter_ = std::move(filter);
  residents_.clear();
  resident_size_ = 0;
  last_time_ = 0;
  heads_ = {};
  for (std::uint32_t i = 0; i < survey_.blocks.size(); ++i) {
    const auto& channels = survey_.blocks[i].channels;
    const auto wanted = [this](std::uint16_t id) { return filter_.wanted[id] || !filter_.known[id]; };
    if (std::any_of(channels.begin(), channels.end(), wanted)) {
      heads_.push({survey_.blocks[i].start_time, i, 0});
    }
  }
}

bool Merge::next(Message& message) {
  while (!heads_.empty()) {
    Head head = heads_.top();
    heads_.pop();
    const OpenBlock* block = open(head.block);
    if (block == nullptr) {
      continue;
    }
    if (head.rank == block->count()) {
      close(residents_.find(head.block));
      continue;
    }
    // A block not opened before was in the heap with its earliest message, wanted or not.
    head.time = block->time(head.rank);
    if (!heads_.empty() && head > heads_.top()) {
      heads_.push(head);
      continue;
    }
    give(head, *block, message);
    return true;
  }
  return false;
}

void Merge::give(const Head& head, const OpenBlock& block, Message& message) {
  block.read(head.rank, message);
  if (message.log_time < last_time_) {
    survey_.damage.note(survey_.blocks[head.block].offset,
                        "the chunk has earlier messages than its index says");
  }
  last_time_ = std::max(last_time_, message.log_time);
  if (head.rank + 1 < block.count()) {
    heads_.push({block.time(head.rank + 1), head.block, head.rank + 1});
  } else {
    close(residents_.find(head.block));
  }
}

OpenBlock* Merge::open(std::uint32_t block) {
  const auto resident = residents_.find(block);
  if (resident == residents_.end()) {
    return load(block);
  }
  resident->second.last_use = ++uses_;
  return &resident->second.block;
}

OpenBlock* Merge::load(std::uint32_t block) {
  if (known_[block] == Known::lost) {
    return nullptr;
  }
  make_room(survey_.blocks[block].size);
  LoadedBlock loaded = load_block(file_, survey_.blocks[block]);
  if (!loaded.problem.empty()) {
    survey_.damage.note(survey_.blocks[block].offset, loaded.problem);
    ++survey_.damage.chunks_lost;
    known_[block] = Known::lost;
    return nullptr;
  }
  resident_size_ += loaded.records.size();
  Resident resident{OpenBlock(std::move(loaded.records), filter_), ++uses_};
  OpenBlock& opened = residents_.emplace(block, std::move(resident)).first->second.block;
  note_first_look(block, opened);
  return &opened;
}

void Merge::note_first_look(std::uint32_t block, const OpenBlock& opened) {
  if (known_[block] == Known::nothing && opened.unreadable() > 0) {
    survey_.damage.note(survey_.blocks[block].offset,
                        "a record in it is broken or of a channel that is nowhere");
    survey_.damage.records_lost += opened.unreadable();
  }
  known_[block] = Known::sound;
}

void Merge::make_room(std::uint64_t size) {
  while (!residents_.empty() && resident_size_ + std::min(size, kMaxResident) > kMaxResident) {
    close(std::min_element(residents_.begin(), residents_.end(), [](const auto& a, const auto& b) {
      return a.second.last_use < b.second.last_use;
    }));
  }
}

void Merge::close(std::map<std::uint32_t, Resident>::iterator resident) {
  resident_size_ -= resident->second.block.size();
  residents_.erase(resident);
}

}  // namespace lanefuse::mcap
