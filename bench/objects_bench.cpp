// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What a cycle of the object tracker costs on the fullest road: 64 radar detections and 32 camera boxes
// against 50 tracks. And whether it allocates once it has seen it all: every operator new is counted.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

#include <benchmark/benchmark.h>

#include "objects/object_tracker.hpp"
#include "objects/radar_alignment.hpp"
#include "objects/sensor_trust.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t bytes) {
  ++allocations;
  void* memory = std::malloc(bytes);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace lanefuse {
namespace {

constexpr int kTracks = 50;
constexpr int kDetections = 64;
constexpr int kBoxes = 32;
constexpr Duration kCycle = std::chrono::milliseconds(80);

/// Fifty vehicles around us that keep their places, three abreast.
Eigen::Vector2d place_of(int vehicle) {
  const int row = vehicle / 3;
  return {15.0 + 10.0 * row, 3.5 * (vehicle % 3) - 3.5};
}

/// The look's number `sighting` of `count`: the last ones are second reflections of the first vehicles.
Sighting sighting_of(int sighting, bool radar, int look) {
  const Eigen::Vector2d place = place_of(sighting % kTracks) + Eigen::Vector2d(sighting / kTracks, 0);
  Sighting seen;
  // A little wander, so that nothing is ever the same twice.
  seen.range = place.norm() + 0.1 * std::sin(look + sighting);
  seen.bearing = std::atan2(place.y(), place.x());
  seen.range_sigma = radar ? 0.25 : 0.05 * seen.range;
  seen.bearing_sigma = 0.003;
  if (radar) seen.range_rate = 0.05 * std::cos(look + sighting);
  return seen;
}

SightingSet look_of(bool radar, int number) {
  SightingSet look;
  look.measured_at = Time{kCycle * number + (radar ? Duration(0) : kCycle / 2)};
  look.sensor_id = radar ? 1 : 2;
  look.kind = radar ? SightingKind::radar : SightingKind::camera;
  look.odometry_from_vehicle = {30 * to_seconds(look.measured_at - Time{}), 0, 0};
  look.odometry_from_sensor = look.odometry_from_vehicle;
  look.velocity = {30, 0};
  for (int i = 0; i < (radar ? kDetections : kBoxes); ++i) {
    look.sightings.push_back(sighting_of(i, radar, number));
  }
  return look;
}

void track_the_fullest_road(benchmark::State& state) {
  constexpr int kWarmUp = 200;
  constexpr int kLooks = 1000;
  std::vector<SightingSet> looks;
  for (int i = 0; i < kWarmUp + kLooks; ++i) {
    looks.push_back(look_of(true, i));
    looks.push_back(look_of(false, i));
  }
  ObjectTracker tracker{{}};
  SensorTrust trust{{}};
  RadarAlignment alignment{{}};
  std::vector<TrackedObject> objects;
  std::size_t next = 0;
  const auto cycle = [&] {
    for (int i = 0; i < 2; ++i) {
      SightingSet& look = looks[next++];
      if (!trust.believe(look, 0)) continue;
      alignment.look(look);
      alignment.correct(look);
      tracker.add(look);
    }
    tracker.write(looks[next - 1].measured_at, looks[next - 1].odometry_from_vehicle, objects);
  };
  for (int i = 0; i < kWarmUp; ++i) cycle();
  std::size_t during = 0;  // the library that measures allocates, too
  for (auto _ : state) {
    const std::size_t before = allocations;
    cycle();
    during += allocations - before;
  }
  state.counters["tracks"] = static_cast<double>(objects.size());
  state.counters["distrusted"] = static_cast<double>(trust.distrusted().size());
  state.counters["allocations_a_cycle"] =
      static_cast<double>(during) / static_cast<double>(state.iterations());
}

BENCHMARK(track_the_fullest_road)->Iterations(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lanefuse
