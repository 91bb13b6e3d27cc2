// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_reader.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/mcap_input_file.hpp"
#include "recording/mcap_merge.hpp"
#include "recording/mcap_parse.hpp"
#include "recording/mcap_survey.hpp"

namespace lanefuse::mcap {

class Reader::Session {
 public:
  explicit Session(const std::filesystem::path& path)
      : file_(path), survey_(surveyed(file_)), merge_(file_, survey_) {
    select([](const Channel&) { return true; });
  }

  [[nodiscard]] const Survey& survey() const { return survey_; }

  void select(const std::function<bool(const Channel&)>& wanted) {
    ChannelFilter filter;
    for (const auto& [id, channel] : survey_.channels) {
      filter.known[id] = true;
      filter.wanted[id] = wanted(channel);
    }
    merge_.rewind(std::move(filter));
  }

  bool next(Message& message) {
    if (merge_.next(message)) {
      return true;
    }
    check_data_section();
    return false;
  }

  [[nodiscard]] Attachment read_attachment(const AttachmentIndex& entry) const {
    const auto head = file_.record_head(entry.offset);
    if (head && head->size <= kMaxRecord) {
      if (auto attachment = parse<Attachment>(file_.content(*head))) {
        return std::move(*attachment);
      }
    }
    throw input_error(
        fmt::format("{}, byte {}", file_.path().string(), entry.offset),
        fmt::format("attachment '{}' is damaged or larger than {} bytes", entry.name, kMaxRecord));
  }

 private:
  static Survey surveyed(const InputFile& file) {
    file.check_magic();
    Survey survey = mcap::survey(file);
    if (survey.damage.any && survey.blocks.empty() && survey.metadata.empty() && survey.attachments.empty()) {
      throw input_error(file.path().string(), "nothing in it can be read; " + survey.damage.first_place);
    }
    return survey;
  }

  // Last, and only where nothing else was wrong: all that it can say is that something is.
  void check_data_section() {
    if (data_section_checked_ || survey_.damage.any || !survey_.data_end || survey_.data_end->crc == 0) {
      return;
    }
    data_section_checked_ = true;
    if (file_.crc(0, survey_.data_end->offset) != survey_.data_end->crc) {
      survey_.damage.note(survey_.data_end->offset, "the data section's CRC does not match");
    }
  }

  InputFile file_;
  Survey survey_;
  Merge merge_;
  bool data_section_checked_ = false;
};

Reader::Reader(const std::filesystem::path& path) : session_(std::make_unique<Session>(path)) {}
Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

const Header& Reader::header() const { return session_->survey().header; }
const std::map<std::uint16_t, Schema>& Reader::schemas() const { return session_->survey().schemas; }
const std::map<std::uint16_t, Channel>& Reader::channels() const { return session_->survey().channels; }
const std::vector<Metadata>& Reader::metadata() const { return session_->survey().metadata; }
const std::vector<AttachmentIndex>& Reader::attachments() const { return session_->survey().attachments; }
const Damage& Reader::damage() const { return session_->survey().damage; }

Attachment Reader::read_attachment(const AttachmentIndex& entry) const {
  return session_->read_attachment(entry);
}

void Reader::select(const std::function<bool(const Channel&)>& wanted) { session_->select(wanted); }

bool Reader::next(Message& message) { return session_->next(message); }

std::optional<Message> Reader::next() {
  Message message;
  return next(message) ? std::optional(std::move(message)) : std::nullopt;
}

}  // namespace lanefuse::mcap
