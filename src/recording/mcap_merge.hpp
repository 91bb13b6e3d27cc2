// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <queue>
#include <vector>

#include "recording/mcap_input_file.hpp"
#include "recording/mcap_open_block.hpp"
#include "recording/mcap_survey.hpp"

namespace lanefuse::mcap {

/// The wanted messages of all blocks in order of log time; equal times in the order of the file.
///
/// A heap holds the next message of every block. A block is opened when its earliest message is due and
/// dropped after its last one. Where more overlap than memory allows, the one used longest ago is dropped and
/// opened again later.
class Merge {
 public:
  /// Both must outlive it; damage that turns up is noted in `survey`.
  Merge(const InputFile& file, Survey& survey);

  void rewind(ChannelFilter filter);
  bool next(Message& message);

 private:
  struct Head {
    std::uint64_t time = 0;
    std::uint32_t block = 0;
    std::uint32_t rank = 0;  ///< of the message in its block

    bool operator>(const Head& other) const {
      return time != other.time ? time > other.time : block > other.block;
    }
  };
  struct Resident {
    OpenBlock block;
    std::uint64_t last_use = 0;
  };
  enum class Known { nothing, sound, lost };

  OpenBlock* open(std::uint32_t block);
  OpenBlock* load(std::uint32_t block);
  void make_room(std::uint64_t size);
  void close(std::map<std::uint32_t, Resident>::iterator resident);
  void give(const Head& head, const OpenBlock& block, Message& message);
  void note_first_look(std::uint32_t block, const OpenBlock& opened);

  const InputFile& file_;
  Survey& survey_;
  ChannelFilter filter_;
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads_;
  std::map<std::uint32_t, Resident> residents_;
  std::vector<Known> known_;
  std::uint64_t resident_size_ = 0;
  std::uint64_t uses_ = 0;
  std::uint64_t last_time_ = 0;
};

}  // namespace lanefuse::mcap
