// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Lesson 2: a feature source of one's own. Where there is a lane, there is often another one beside it: this
// source says so with little confidence, and the fusion weighs its word against everything else that it
// hears.
#include <cstdio>
#include <lanefuse/core/error.hpp>
#include <lanefuse/pipeline/perception.hpp>
#include <lanefuse/recording/drive_reader.hpp>
#include <lanefuse/sources/feature_source.hpp>
#include <memory>
#include <vector>

namespace {

constexpr double kLaneWidth = 3.5;  // [m]

class NeighbourLanes final : public lanefuse::FeatureSource {
 public:
  lanefuse::InputAccounting add(const lanefuse::Measurement& measurement,
                                const lanefuse::SourceContext&) override {
    if (const auto* lane = std::get_if<lanefuse::SerialLane>(&measurement)) {
      lanefuse::FeatureSet set;
      set.source = lanefuse::Source::user;
      set.measured_at = lane->stamp.measured_at;
      if (lane->left) set.clothoids.push_back(beside(*lane->left, kLaneWidth));
      if (lane->right) set.clothoids.push_back(beside(*lane->right, -kLaneWidth));
      pending_.push_back(set);
    }
    return {};  // the serial camera's own source counts its lanes
  }

  void collect(lanefuse::Time, const lanefuse::SourceContext&,
               std::vector<lanefuse::FeatureSet>& sets) override {
    sets.insert(sets.end(), pending_.begin(), pending_.end());
    pending_.clear();
  }

  void reset() override { pending_.clear(); }

 private:
  static lanefuse::ClothoidMeasurement beside(lanefuse::ClothoidMeasurement marking, double distance) {
    marking.clothoid.lateral_offset += distance;
    marking.covariance(0, 0) += 0.25 * 0.25;  // lanes are not all equally wide
    marking.confidence *= 0.5;
    marking.side = lanefuse::Side::none;
    marking.marking = {};
    return marking;
  }

  std::vector<lanefuse::FeatureSet> pending_;
};

/// How many lanes a cycle sees, on average.
double lanes_seen(const char* path, std::unique_ptr<lanefuse::FeatureSource> source) {
  lanefuse::DriveReader drive(path);
  lanefuse::MultiLanePerception perception(lanefuse::default_config(drive.info().witness), drive.rig());
  if (source) perception.add_source(std::move(source));
  std::size_t lanes = 0;
  std::size_t cycles = 0;
  for (lanefuse::Measurement measurement; drive.next(measurement); perception.add(measurement)) {
    while (const lanefuse::LaneEstimate* cycle = perception.advance(stamp_of(measurement).received_at)) {
      lanes += cycle->lanes.size();
      ++cycles;
    }
  }
  return cycles == 0 ? 0 : static_cast<double>(lanes) / static_cast<double>(cycles);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return std::puts("usage: own_source DRIVE.mcap"), 2;
  std::printf("without it %.2f lanes a cycle, with it %.2f\n", lanes_seen(argv[1], nullptr),
              lanes_seen(argv[1], std::make_unique<NeighbourLanes>()));
} catch (const lanefuse::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
