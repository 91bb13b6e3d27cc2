// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_record_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/mcap_block.hpp"

namespace lanefuse::mcap {

RecordReader::RecordReader(const std::filesystem::path& path, Chunks chunks) : file_(path), chunks_(chunks) {
  file_.check_magic();
}

std::optional<RawRecord> RecordReader::next() {
  while (true) {
    if (auto record = next_in_chunk()) {
      return record;
    }
    if (at_end_) {
      return std::nullopt;
    }
    const RecordHead head = next_head();
    if (head.opcode == Opcode::chunk && chunks_ == Chunks::unpacked) {
      LoadedBlock loaded = load_chunk(file_, head);
      if (!loaded.problem.empty()) {
        fail(head.offset, loaded.problem);
      }
      chunk_ = std::move(loaded.records);
      chunk_offset_ = head.offset;
      offset_in_chunk_ = 0;
      continue;
    }
    content_ = file_.content(head);
    return RawRecord{head.opcode, head.offset, content_};
  }
}

RecordHead RecordReader::next_head() {
  const auto head = file_.record_head(offset_);
  if (!head || head->size > kMaxRecord) {
    fail(offset_, "no record that ends inside the file and is within the limit of size");
  }
  offset_ = head->end();
  if (head->opcode == Opcode::footer) {
    const Bytes magic = file_.read(offset_, kMagic.size());
    if (!std::equal(magic.begin(), magic.end(), kMagic.begin(), kMagic.end())) {
      fail(offset_, "the closing magic is missing");
    }
    at_end_ = true;
  }
  return *head;
}

std::optional<RawRecord> RecordReader::next_in_chunk() {
  if (offset_in_chunk_ == chunk_.size()) {
    return std::nullopt;
  }
  const auto record = record_at(chunk_, offset_in_chunk_);
  if (!record) {
    fail(chunk_offset_, fmt::format("no whole record at byte {} of the chunk's records", offset_in_chunk_));
  }
  offset_in_chunk_ += kRecordHeadSize + record->content.size();
  return record;
}

void RecordReader::fail(std::uint64_t byte, const std::string& problem) const {
  throw input_error(fmt::format("{}, byte {}", file_.path().string(), byte), problem);
}

}  // namespace lanefuse::mcap
