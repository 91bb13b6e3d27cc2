// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_survey.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "recording/mcap_chunk_search.hpp"
#include "recording/mcap_descriptions.hpp"
#include "recording/mcap_summary.hpp"

namespace lanefuse::mcap {
namespace {

constexpr std::uint64_t kRunSize = std::uint64_t{1} << 20;
constexpr std::uint64_t kAttachmentHead = std::uint64_t{1} << 16;

class Surveyor {
 public:
  explicit Surveyor(const InputFile& file) : file_(file), descriptions_(survey_) {}

  Survey run() {
    summary_ = read_summary(file_, survey_.damage);
    const std::uint64_t end = summary_ ? summary_->footer_offset : file_.size();
    if (summary_) {
      survey_.schemas = summary_->schemas;
      survey_.channels = summary_->channels;
    }
    std::uint64_t offset = kMagic.size();
    while (offset < end) {
      offset = std::min(step(offset), end);
    }
    if (!survey_.data_end) {
      survey_.damage.note(file_.size(), "the data section has no end: the file is cut short or altered");
    }
    drop_unproven_runs();
    descriptions_.check_schemas();
    return std::move(survey_);
  }

 private:
  // Takes up what is at `offset` and says where to go on.
  std::uint64_t step(std::uint64_t offset) {
    if (const Block* block = described(offset)) {
      return pass_by(*block);
    }
    const auto head = file_.record_head(offset);
    if (!head) {
      return search(offset, "no record that ends inside the file");
    }
    switch (head->opcode) {
      case Opcode::chunk:
        return scan_chunk(*head);
      case Opcode::footer:
        return search(offset, "a footer before the end of the file");
      case Opcode::message:
        // After the data section there are none: it is some altered record of the summary.
        if (!survey_.data_end) {
          take_message(*head);
        }
        break;
      case Opcode::attachment:
        take_attachment(*head);
        break;
      case Opcode::data_end:
        take_data_end(*head);
        break;
      default:
        take_description(*head);
        break;
    }
    return head->end();
  }

  [[nodiscard]] const Block* described(std::uint64_t offset) const {
    if (!summary_) {
      return nullptr;
    }
    const auto found = summary_->chunks.find(offset);
    return found == summary_->chunks.end() ? nullptr : &found->second;
  }

  std::uint64_t pass_by(const Block& block) {
    const auto head = file_.record_head(block.offset);
    const std::uint64_t end = block.offset + block.length;
    if (!head || head->opcode != Opcode::chunk || head->end() != end) {
      survey_.damage.note(block.offset, "there is no chunk of the size that the index says");
    }
    add(block);
    has_chunks_ = true;
    return end;
  }

  std::uint64_t scan_chunk(const RecordHead& head) {
    has_chunks_ = true;
    const LoadedBlock loaded = load_chunk(file_, head);
    if (loaded.problem.empty()) {
      take_records(loaded.records, head);
      return head.end();
    }
    ++survey_.damage.chunks_lost;
    // Is it the length that is wrong? Then what follows is no record.
    const auto next = file_.record_head(head.end());
    if (next && next->opcode <= Opcode::data_end) {
      survey_.damage.note(head.offset, loaded.problem);
      return head.end();
    }
    return search(head.offset, loaded.problem);
  }

  void take_records(const Bytes& records, const RecordHead& head) {
    Block block{head.offset, head.end() - head.offset, 0, records.size(), true, {}};
    std::set<std::uint16_t> channels;
    std::uint64_t offset = 0;
    while (auto record = record_at(records, offset)) {
      offset += kRecordHeadSize + record->content.size();
      descriptions_.take(*record, head.offset);
      const auto message =
          record->opcode == Opcode::message ? parse_message_head(record->content) : std::nullopt;
      if (message) {
        block.start_time =
            channels.empty() ? message->log_time : std::min(block.start_time, message->log_time);
        channels.insert(message->channel_id);
      }
    }
    if (!channels.empty()) {
      block.channels.assign(channels.begin(), channels.end());
      add(std::move(block));
    }
  }

  // Messages outside chunks are gathered into runs, which are then read as chunks are.
  void take_message(const RecordHead& head) {
    const auto message = parse_message_head(file_.content(head, kMessageHeadSize));
    if (!message || head.size > kMaxRecord) {
      survey_.damage.note(head.offset, "the message is shorter than its fields or larger than the limit");
      ++survey_.damage.records_lost;
      return;
    }
    const std::uint64_t length = head.end() - head.offset;
    if (Block* run = open_run(head.offset)) {
      run->length += length;
      run->size = run->length;
      run->start_time = std::min(run->start_time, message->log_time);
      auto& channels = run->channels;
      const auto place = std::lower_bound(channels.begin(), channels.end(), message->channel_id);
      if (place == channels.end() || *place != message->channel_id) {
        channels.insert(place, message->channel_id);
      }
      return;
    }
    add({head.offset, length, message->log_time, length, false, {message->channel_id}});
  }

  Block* open_run(std::uint64_t offset) {
    if (survey_.blocks.empty()) {
      return nullptr;
    }
    Block& last = survey_.blocks.back();
    const bool open = !last.is_chunk && last.offset + last.length == offset && last.length < kRunSize;
    return open ? &last : nullptr;
  }

  void take_attachment(const RecordHead& head) {
    auto entry = parse_attachment_head(file_.content(head, kAttachmentHead));
    if (!entry || entry->data_size > head.size) {
      survey_.damage.note(head.offset, "the attachment's lengths contradict each other");
      ++survey_.damage.records_lost;
    } else if (descriptions_.has_room(kRecordHeadSize + entry->name.size() + entry->media_type.size(),
                                      head.offset)) {
      entry->offset = head.offset;
      entry->length = head.end() - head.offset;
      survey_.attachments.push_back(std::move(*entry));
    }
  }

  void take_data_end(const RecordHead& head) {
    const auto data_end = parse<DataEnd>(file_.content(head, sizeof(std::uint32_t)));
    survey_.data_end = DataSectionEnd{head.offset, data_end ? data_end->data_section_crc : 0};
  }

  void take_description(const RecordHead& head) {
    const bool describes = head.opcode == Opcode::header || head.opcode == Opcode::schema ||
                           head.opcode == Opcode::channel || head.opcode == Opcode::metadata;
    // What cannot be kept is not read either: has_room() says no to it, and notes so.
    const bool readable =
        head.size <= kMaxDescriptions || !describes || descriptions_.has_room(head.size, head.offset);
    if (describes && readable) {
      descriptions_.take({head.opcode, head.offset, file_.content(head)}, head.offset);
    }
  }

  void add(Block block) {
    if (survey_.blocks.size() < kMaxBlocks) {
      return survey_.blocks.push_back(std::move(block));
    }
    survey_.damage.note(block.offset, "the file has more pieces than the reader keeps account of");
    ++survey_.damage.chunks_lost;
  }

  // Where messages are in chunks, others outside may be some other record whose opcode was altered: they
  // count only if the data section's CRC covers them.
  void drop_unproven_runs() {
    const auto is_run = [](const Block& block) { return !block.is_chunk; };
    const auto run = std::find_if(survey_.blocks.begin(), survey_.blocks.end(), is_run);
    if (!has_chunks_ || run == survey_.blocks.end() || is_data_section_sound()) {
      return;
    }
    survey_.damage.note(run->offset,
                        "messages outside chunks in a file with chunks, and no CRC that covers them");
    survey_.damage.records_lost += std::erase_if(survey_.blocks, is_run);
  }

  [[nodiscard]] bool is_data_section_sound() const {
    const auto& end = survey_.data_end;
    return end && (end->crc == 0 || file_.crc(0, end->offset) == end->crc);
  }

  // The next place to go on after damage at `offset`.
  std::uint64_t search(std::uint64_t offset, const std::string& problem) {
    survey_.damage.note(offset, problem);
    std::uint64_t next = file_.size();
    if (summary_ && summary_->chunks.upper_bound(offset) != summary_->chunks.end()) {
      next = summary_->chunks.upper_bound(offset)->first;
    } else if (const auto chunk = find_chunk(file_, offset + 1)) {
      next = chunk->offset;
    }
    survey_.damage.bytes_skipped += next - offset;
    return next;
  }

  const InputFile& file_;
  Survey survey_;
  Descriptions descriptions_;
  std::optional<Summary> summary_;
  bool has_chunks_ = false;
};

}  // namespace

Survey survey(const InputFile& file) { return Surveyor(file).run(); }

}  // namespace lanefuse::mcap
