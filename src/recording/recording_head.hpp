// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recording/mcap_records.hpp"
#include "recording/run_info.hpp"
#include "sensors/drive.hpp"

namespace lanefuse {

/// What a recording says of itself, in its metadata record "lanefuse".
struct RecordingHead {
  enum class Kind { drive, lanes };
  Kind kind = Kind::drive;
  DriveInfo drive;
  RunInfo run;  ///< of lanes only
  friend bool operator==(const RecordingHead&, const RecordingHead&) = default;
};

/// Readers refuse another major version; a higher minor version has only added things, which they pass over.
inline constexpr int kFormatMajor = 1;
inline constexpr int kFormatMinor = 3;

/// The frame and the line of a marking that every number of a recording refers to; readers refuse any other.
inline constexpr char kDeclaredFrame[] = "ISO 8855, origin at road height under the middle of the front axle";
inline constexpr char kMarkingReference[] = "centre line";

mcap::Metadata to_metadata(const RecordingHead& head);

/// The record that marks a file with OSI messages.
mcap::Metadata osi_trace_metadata();

/// Throws Error (input) naming `file` where the record is missing, of an unknown version, of another frame or
/// not `kind`.
RecordingHead read_head(const std::vector<mcap::Metadata>& records, RecordingHead::Kind kind,
                        const std::string& file);

}  // namespace lanefuse
