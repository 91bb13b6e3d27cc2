// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "recording/mcap_parse.hpp"
#include "recording/mcap_survey.hpp"

namespace lanefuse::mcap {

/// Gathers what a file says about its messages -- header, schemas, channels, metadata -- into a survey, up to
/// a limit of memory. A schema or channel that is defined again must be the same; the first one counts.
class Descriptions {
 public:
  explicit Descriptions(Survey& survey) : survey_(survey) {}

  /// Takes up a record if it describes something; `place` is its byte in the file, for notes of damage.
  void take(const RawRecord& record, std::uint64_t place);

  /// Whether `bytes` more may be kept in memory; notes damage at `place` if not.
  bool has_room(std::uint64_t bytes, std::uint64_t place);

  /// Channels whose schema is nowhere are noted as damage.
  void check_schemas();

 private:
  template <typename Record>
  void define(std::map<std::uint16_t, Record>& known, const RawRecord& record, std::uint64_t place);
  void lose(std::uint64_t place, const char* what);

  Survey& survey_;
  std::uint64_t kept_ = 0;
};

}  // namespace lanefuse::mcap
