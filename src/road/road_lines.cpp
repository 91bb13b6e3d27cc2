// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines and vehicles of a road state; how the state moves with the car is in road_state.cpp.
#include <algorithm>
#include <cmath>

#include "road/road_state.hpp"

namespace lanefuse {
namespace {

double square(double x) { return x * x; }

}  // namespace

KnownLine* RoadState::add_line(double offset, double sigma) {
  if (lines_.size() == kMostLines || !numbers_.has_room(kOffsets)) return nullptr;
  // Lines stand before vehicles: those make room.
  while (!vehicles_.empty()) remove_vehicle(vehicles_.size() - 1);
  KnownLine& line = lines_.emplace_back();
  line.id = next_line_++;
  line.first = numbers_.append(offset, square(sigma));
  for (int k = 1; k < kOffsets; ++k) {
    SparseRow before;
    before.add(line.first + k - 1, 1);
    numbers_.append(before, 0, square(config_.course.offset_step));
  }
  line.seen_at = driven_;
  return &line;
}

KnownLine* RoadState::add_line_beside(std::uint64_t known, double distance, double sigma) {
  const KnownLine* beside = find_line(known);
  if (!beside || lines_.size() == kMostLines || !numbers_.has_room(kOffsets)) return nullptr;
  while (!vehicles_.empty()) remove_vehicle(vehicles_.size() - 1);
  const int first = beside->first;
  KnownLine& line = lines_.emplace_back();
  line.id = next_line_++;
  SparseRow same;
  same.add(first, 1);
  line.first = numbers_.append(same, distance, square(sigma));
  for (int k = 1; k < kOffsets; ++k) {
    SparseRow parallel;
    parallel.add(first + k, 1);
    parallel.add(line.first + k - 1, 1);
    parallel.add(first + k - 1, -1);
    numbers_.append(parallel, 0, square(config_.course.offset_step));
  }
  line.seen_at = driven_;
  line.density = 0;
  return &line;
}

void RoadState::remove_line(std::size_t line) {
  numbers_.remove(lines_[line].first, kOffsets);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line));
  for (std::size_t i = line; i < lines_.size(); ++i) lines_[i].first -= kOffsets;
  for (RoadVehicle& vehicle : vehicles_) vehicle.index -= kOffsets;
}

void RoadState::free_line(const KnownLine& line, double station, double sigma) {
  for (int k = 0; k < kOffsets; ++k) {
    if (first_offset_ + k * kOffsetSpacing < station) continue;
    numbers_.add_noise(line.first + k, square(sigma));
  }
}

RoadVehicle* RoadState::add_vehicle(std::int64_t track_id) {
  if (vehicles_.size() == kMostVehicles || !numbers_.has_room(1)) return nullptr;
  RoadVehicle& vehicle = vehicles_.emplace_back();
  vehicle.track_id = track_id;
  vehicle.index = numbers_.append(0, square(config_.vehicles.driver.sigma));
  return &vehicle;
}

RoadVehicle* RoadState::add_stranger(std::int64_t track_id, double aside, double sigma) {
  RoadVehicle* vehicle = add_vehicle(track_id);
  if (!vehicle) return nullptr;
  vehicle->in_lane = false;
  numbers_.set_mean(vehicle->index, aside);
  numbers_.add_noise(vehicle->index, square(sigma));
  return vehicle;
}

void RoadState::remove_vehicle(std::size_t vehicle) {
  numbers_.remove(vehicles_[vehicle].index, 1);
  vehicles_.erase(vehicles_.begin() + static_cast<std::ptrdiff_t>(vehicle));
  for (std::size_t i = vehicle; i < vehicles_.size(); ++i) --vehicles_[i].index;
}

const KnownLine* RoadState::find_line(std::uint64_t id) const {
  const auto found =
      std::find_if(lines_.begin(), lines_.end(), [id](const KnownLine& line) { return line.id == id; });
  return found == lines_.end() ? nullptr : &*found;
}

double RoadState::offset(const KnownLine& line, double station) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  return w.of_first * numbers_.mean(line.first + w.first) +
         w.of_second * numbers_.mean(line.first + w.first + 1);
}

double RoadState::slope(const KnownLine& line, double station) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  return (numbers_.mean(line.first + w.first + 1) - numbers_.mean(line.first + w.first)) / kOffsetSpacing;
}

void RoadState::add_lateral(SparseRow& row, const RoadAxis::Place& at, double factor) const {
  row.add(kHeading, factor * axis_.heading_lever(at));
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    row.add(kCurvatures + k, -factor * axis_.curvature_lever(k, at.station));
  }
}

void RoadState::add_offset(SparseRow& row, const KnownLine& line, double station, double factor) const {
  const KnotWeights w = knot_weights(station, first_offset_, kOffsetSpacing, kOffsets);
  row.add(line.first + w.first, factor * w.of_first);
  row.add(line.first + w.first + 1, factor * w.of_second);
}

double RoadState::relative_height(double station) const {
  double height = 0;
  for (int k = 0; k < kOffsets; ++k) {
    height +=
        numbers_.mean(kCrests + k) * hat_lever(first_offset_ + k * kOffsetSpacing, kOffsetSpacing, station);
  }
  return height;
}

void RoadState::add_relative_height(SparseRow& row, double station, double factor) const {
  for (int k = 0; k < kOffsets; ++k) {
    row.add(kCrests + k, factor * hat_lever(first_offset_ + k * kOffsetSpacing, kOffsetSpacing, station));
  }
}

double RoadState::variance(const KnownLine& line, double station) const {
  SparseRow row;
  add_lateral(row, axis_.at(station), -1);
  add_offset(row, line, station);
  return numbers_.variance(row);
}

}  // namespace lanefuse
