// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/recording_head.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/message_schema.hpp"
#include "recording/osi_version.hpp"

namespace lanefuse {
namespace {

constexpr char kRecordName[] = "lanefuse";

/// The record of one file, and the errors that name both.
class HeadRecord {
 public:
  HeadRecord(const std::vector<mcap::Metadata>& records, std::string file) : place_(std::move(file)) {
    const auto found = std::find_if(records.begin(), records.end(),
                                    [](const mcap::Metadata& record) { return record.name == kRecordName; });
    if (found == records.end())
      refuse("it has no metadata record \"lanefuse\"", "is it a recording of Lanefuse?");
    fields_ = &found->metadata;
  }

  [[nodiscard]] const std::string& at(const std::string& key) const {
    const auto found = fields_->find(key);
    if (found == fields_->end()) refuse(fmt::format("its metadata record \"lanefuse\" has no {}", key));
    return found->second;
  }

  [[nodiscard]] const std::string* find(const std::string& key) const {
    const auto found = fields_->find(key);
    return found == fields_->end() ? nullptr : &found->second;
  }

  void expect(const std::string& key, const std::string& value) const {
    if (at(key) != value)
      refuse(fmt::format("its {} is \"{}\"", key, at(key)), fmt::format("it must be \"{}\"", value));
  }

  [[noreturn]] void refuse(const std::string& problem, const std::string& mend = {}) const {
    throw input_error(place_, problem, mend);
  }

 private:
  std::string place_;
  const mcap::StringMap* fields_ = nullptr;
};

const char* to_string(RecordingHead::Kind kind) {
  return kind == RecordingHead::Kind::drive ? "drive" : "lanes";
}

void check_version(const HeadRecord& record) {
  const std::string& version = record.at("schema_version");
  int major = 0;
  const char* end = version.data() + version.size();
  const auto [rest, problem] = std::from_chars(version.data(), end, major);
  if (problem != std::errc{} || rest == end || *rest != '.') {
    record.refuse(fmt::format("its schema_version \"{}\" is no version", version));
  }
  if (major != kFormatMajor) {
    record.refuse(
        fmt::format("it follows version {} of the recording format, which is not known here", version),
        fmt::format("this program reads versions {}.x", kFormatMajor));
  }
}

WitnessRule take_witness(const HeadRecord& record, const std::string& key) {
  for (const WitnessRule rule : {WitnessRule::radar_and_camera, WitnessRule::radar_only}) {
    if (record.at(key) == lanefuse::to_string(rule)) return rule;
  }
  record.refuse(fmt::format("its {} \"{}\" is unknown", key, record.at(key)));
}

/// Latitude and longitude [deg] and height [m].
std::string to_text(const GeoOrigin& origin) {
  return fmt::format("{} {} {}", origin.latitude_deg, origin.longitude_deg, origin.height);
}

std::optional<GeoOrigin> take_origin(const HeadRecord& record) {
  const std::string* text = record.find("origin");
  if (!text) return std::nullopt;
  std::array<double, 3> numbers{};
  const char* next = text->data();
  const char* end = next + text->size();
  for (double& number : numbers) {
    while (next != end && *next == ' ') ++next;
    const auto [rest, problem] = std::from_chars(next, end, number);
    if (problem != std::errc{}) record.refuse(fmt::format("its origin \"{}\" is not three numbers", *text));
    next = rest;
  }
  const auto [latitude, longitude, height] = numbers;
  // Also false for what is not a number.
  const bool on_earth = std::abs(latitude) <= 90 && std::abs(longitude) <= 180 && std::abs(height) < 1e5;
  if (next != end || !on_earth) record.refuse(fmt::format("its origin \"{}\" is no place on Earth", *text));
  return GeoOrigin{latitude, longitude, height};
}

}  // namespace

mcap::Metadata to_metadata(const RecordingHead& head) {
  // The lowest version that has all that the file holds, so that what is not new is written as ever.
  const bool has_origin = head.kind == RecordingHead::Kind::drive && head.drive.origin;
  const bool is_lanes = head.kind == RecordingHead::Kind::lanes;
  const int minor = is_lanes ? kFormatMinor : head.drive.images ? 2 : has_origin ? 1 : 0;
  mcap::Metadata record{kRecordName, {}};
  record.metadata = {{"schema_version", fmt::format("{}.{}", kFormatMajor, minor)},
                     {"kind", to_string(head.kind)},
                     {"frame", kDeclaredFrame},
                     {"marking_reference", kMarkingReference},
                     {"drive", head.drive.name},
                     {"preset_hash", head.drive.preset_hash},
                     {"witness", lanefuse::to_string(head.drive.witness)}};
  if (head.drive.images) record.metadata["images"] = "yes";
  if (has_origin) record.metadata["origin"] = to_text(*head.drive.origin);
  if (is_lanes) {
    record.metadata["run_witness"] = lanefuse::to_string(head.run.witness);
    record.metadata["estimator"] = head.run.estimator;
    record.metadata["configuration_hash"] = head.run.configuration_hash;
  }
  return record;
}

mcap::Metadata osi_trace_metadata() {
  return {"net.asam.osi.trace",
          {{"version", kOsiVersion},
           {"min_osi_version", kOsiVersion},
           {"max_osi_version", kOsiVersion},
           {"min_protobuf_version", protobuf_version()},
           {"max_protobuf_version", protobuf_version()}}};
}

RecordingHead read_head(const std::vector<mcap::Metadata>& records, RecordingHead::Kind kind,
                        const std::string& file) {
  const HeadRecord record(records, file);
  check_version(record);
  record.expect("kind", to_string(kind));
  record.expect("frame", kDeclaredFrame);
  record.expect("marking_reference", kMarkingReference);
  RecordingHead head;
  head.kind = kind;
  head.drive = {record.at("drive"), record.at("preset_hash"), take_witness(record, "witness"),
                take_origin(record), record.find("images") != nullptr};
  if (kind == RecordingHead::Kind::lanes) {
    head.run = {take_witness(record, "run_witness"), record.at("estimator"), record.at("configuration_hash")};
  }
  return head;
}

}  // namespace lanefuse
