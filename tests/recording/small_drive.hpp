// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "recording/drive_reader.hpp"
#include "recording/drive_writer.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/mcap_writer.hpp"

/// A drive of every kind of measurement, and ways to write, read and change its file.
namespace lanefuse::testing {

inline const DriveInfo kInfo{"a small drive", "0123abcd", WitnessRule::radar_only};

inline Rig small_rig() {
  return {{{1, SensorKind::odometry, "odometry", {}},
           {2, SensorKind::serial_camera, "serial camera", {1.8, 0, 1.25, 0, 0, 0}},
           {3, SensorKind::high_resolution_camera, "camera", {1.8, 0, 1.25, 0, 0.01, 0}},
           {4, SensorKind::short_range_radar, "front left", {0.7, 0.6, 0.5, 0, 0, 0.8}},
           {5, SensorKind::short_range_radar, "front right", {0.7, -0.6, 0.5, 0, 0, -0.8}},
           {6, SensorKind::object_fusion, "objects", {}}}};
}

inline Stamp stamp_at(int milliseconds, std::uint32_t sensor) {
  const Time measured_at = from_nanoseconds(1'600'000'000'000'000'000) + Duration(milliseconds * 1'000'000LL);
  return {measured_at, measured_at + Duration(40'000'000), sensor};
}

/// Everything that was received in one tenth of a second.
inline std::vector<Measurement> tick(int milliseconds) {
  VehicleMotion motion{stamp_at(milliseconds, 1), 20.0 + milliseconds, 0.01, {}};
  VehicleMotion wheels{stamp_at(milliseconds + 10, 1), {}, {}, std::array{1.0, 2.0, 3.0, 4.0}};
  SerialLane lane;
  lane.stamp = stamp_at(milliseconds + 20, 2);
  lane.left = ClothoidMeasurement{.clothoid = {1.7, 0.01, 1e-4, 1e-7}, .range_end = 60, .side = Side::left};
  MarkingFeatures markings{stamp_at(milliseconds + 30, 3), {Feature{.x = 30, .y = -1.7}}, SharedError{}};
  RadarScan left{stamp_at(milliseconds + 40, 4), {RadarDetection{.range = 20, .address = 7}}};
  RadarScan right{stamp_at(milliseconds + 40, 5), {RadarDetection{.range = 30}}};
  ObjectList objects{stamp_at(milliseconds + 50, 6), {TrackedObject{.id = 9, .x = 40, .speed = 21}}};
  return {motion, wheels, lane, markings, left, right, objects};
}

inline TrueFrame true_frame(int milliseconds) {
  return {
      stamp_at(milliseconds, 0).measured_at, {milliseconds * 0.02, 0, 0}, 20, 0, {{.id = 9, .speed = 21}}};
}

inline TrueRoad true_road() {
  return {{{.id = 1, .points = {{0, 1.8}, {500, 1.8}}}, {.id = 2, .points = {{0, -1.8}, {500, -1.8}}}},
          {{.id = 1, .left_boundary = 1, .right_boundary = 2}}};
}

inline void write_drive(const std::filesystem::path& path, int ticks, bool with_truth = true) {
  DriveWriter writer(path, kInfo, small_rig());
  if (with_truth) writer.write(true_road(), stamp_at(0, 0).measured_at);
  for (int i = 0; i < ticks; ++i) {
    if (with_truth) writer.write(true_frame(100 * i));
    for (const Measurement& measurement : tick(100 * i)) writer.write(measurement);
  }
  writer.close();
}

inline std::vector<Measurement> read_drive(const std::filesystem::path& path) {
  DriveReader reader(path);
  std::vector<Measurement> measurements;
  for (Measurement measurement; reader.next(measurement);) measurements.push_back(measurement);
  return measurements;
}

/// What of a file to keep, and as what, when it is written anew.
struct Changes {
  std::function<bool(const mcap::Channel&)> keep = [](const mcap::Channel&) { return true; };
  std::function<void(mcap::Metadata&)> metadata = [](mcap::Metadata&) {};
  std::function<void(mcap::Channel&)> channel = [](mcap::Channel&) {};
  std::function<void(mcap::Message&, const std::string& topic)> message = [](auto&, auto&) {};
};

inline void rewrite(const std::filesystem::path& in, const std::filesystem::path& out,
                    const Changes& changes) {
  mcap::Reader reader(in);
  mcap::Writer writer(out);
  for (mcap::Metadata record : reader.metadata()) {
    changes.metadata(record);
    writer.write(record);
  }
  for (const auto& [id, schema] : reader.schemas())
    writer.add_schema(schema.name, schema.encoding, schema.data);
  std::map<std::uint16_t, std::uint16_t> ids;
  for (auto [id, channel] : reader.channels()) {
    if (!changes.keep(channel)) continue;
    changes.channel(channel);
    ids[id] =
        writer.add_channel(channel.topic, channel.message_encoding, channel.schema_id, channel.metadata);
  }
  reader.select(changes.keep);
  for (mcap::Message message; reader.next(message);) {
    changes.message(message, reader.channels().at(message.channel_id).topic);
    message.channel_id = ids.at(message.channel_id);
    writer.write(message);
  }
  writer.close();
}

}  // namespace lanefuse::testing
