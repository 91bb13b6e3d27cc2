// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "pipeline/broken_detections.hpp"
#include "pipeline/damaged_stream.hpp"

/// Radars and a camera that boxes vehicles, sound and broken, from measurements to lanes and tracks.
namespace lanefuse {
namespace {

using testing::broken_camera;
using testing::broken_radar;
using testing::CycleResult;
using testing::detected_drive;
using testing::expect_blamed;
using testing::flagged_after;
using testing::image_width;
using testing::kBegin;
using testing::mirror;
using testing::objects_of;
using testing::run;
using testing::seconds_of;
using testing::SimulatedDrive;

std::size_t witnesses(const CycleResult& cycle) {
  return static_cast<std::size_t>(std::ranges::count_if(cycle.objects, &TrackedObject::witness));
}

bool same_objects(const std::vector<TrackedObject>& a, const std::vector<TrackedObject>& b) {
  return std::ranges::equal(a, b, [](const TrackedObject& p, const TrackedObject& q) {
    return p.id == q.id && p.x == q.x && p.y == q.y && p.covariance == q.covariance && p.witness == q.witness;
  });
}

void expect_same(const std::vector<CycleResult>& a, const std::vector<CycleResult>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(testing::same_road(a[i].lanes, b[i].lanes)) << "cycle " << i;
    ASSERT_TRUE(same_objects(a[i].objects, b[i].objects)) << "cycle " << i;
  }
}

/// That whoever bears witness, from a second on, is there.
void expect_real_witnesses(const std::vector<CycleResult>& cycles, const SimulatedDrive& drive, double from) {
  for (const CycleResult& cycle : cycles) {
    const auto frame = frame_at(drive.truth, cycle.lanes.time);
    if (!frame || seconds_of(cycle.lanes.time) < from) continue;
    for (const TrackedObject& object : cycle.objects) {
      const Eigen::Vector2d said(object.x, object.y);
      const bool real = std::ranges::any_of(frame->objects, [&](const TrueObject& vehicle) {
        return (frame->world_from_vehicle.inverse() * vehicle.world_from_object.position() - said).norm() < 4;
      });
      EXPECT_TRUE(real || !object.witness) << seconds_of(cycle.lanes.time) << " s at " << said.transpose();
    }
  }
}

class ObjectSensors : public ::testing::Test {
 protected:
  const SimulatedDrive drive_ = detected_drive();
  const std::vector<CycleResult> sound_ = run(drive_.rig, drive_.measurements);
};

class SoundObjectSensors : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(SoundObjectSensors, AreNeverDistrusted) {
  const SimulatedDrive drive = detected_drive(GetParam());
  std::size_t most = 0;
  for (const CycleResult& cycle : run(drive.rig, drive.measurements)) {
    EXPECT_NE(objects_of(cycle), SourceStatus::degraded) << seconds_of(cycle.lanes.time);
    most = std::max(most, cycle.objects.size());
  }
  EXPECT_GT(most, 0U) << "vehicles are seen at all";
}

INSTANTIATE_TEST_SUITE_P(Seeds, SoundObjectSensors, ::testing::Range<std::uint64_t>(1, 9));

TEST_F(ObjectSensors, LoseNothingToDamagedNeighbours) {
  std::vector<Measurement> stream = drive_.measurements;
  std::uint64_t damaged = 0;
  for (Measurement& measurement : stream) {
    if (auto* scan = std::get_if<RadarScan>(&measurement)) {
      for (const RadarDetection& bad : {RadarDetection{testing::kNotANumber, 0, 0}, RadarDetection{-20, 0, 0},
                                        RadarDetection{20, 1e308, 0}, RadarDetection{20, 0, -1e308}}) {
        testing::AddDamagedItem::insert(scan->detections, bad);
        ++damaged;
      }
    }
    if (auto* boxes = std::get_if<CameraBoxes>(&measurement)) {
      testing::AddDamagedItem::insert(boxes->boxes, BoxDetection{testing::kNotANumber, 0, 1, 1});
      ++damaged;
    }
  }
  const auto cycles = run(drive_.rig, stream);
  expect_same(cycles, sound_);
  InputAccounting with;
  InputAccounting without;
  for (const CycleResult& cycle : cycles) with += cycle.lanes.inputs;
  for (const CycleResult& cycle : sound_) without += cycle.lanes.inputs;
  EXPECT_EQ(with.used, without.used);
  EXPECT_NEAR(static_cast<double>(with.rejected), static_cast<double>(damaged), 20) << "but the last cycle's";
}

TEST_F(ObjectSensors, LoseNothingToUnknownOnes) {
  std::vector<Measurement> stream;
  for (const Measurement& measurement : drive_.measurements) {
    stream.push_back(measurement);
    if (!std::holds_alternative<RadarScan>(measurement)) continue;
    stream.push_back(measurement);
    testing::stamp_in(stream.back()).sensor_id += 1000;
  }
  expect_same(run(drive_.rig, stream), sound_);
}

TEST_F(ObjectSensors, MaySpeakTwice) {
  std::vector<Measurement> twice;
  for (const Measurement& measurement : drive_.measurements) twice.insert(twice.end(), 2, measurement);
  expect_same(run(drive_.rig, twice), sound_);
}

TEST_F(ObjectSensors, RecoverFromStampsThatJump) {
  for (const double jump : {-86400.0, -0.5, 0.5, 86400.0}) {
    std::vector<Measurement> stream = drive_.measurements;
    for (Measurement& measurement : stream) {
      const bool detects = measurement.index() == 3 || measurement.index() == 7;
      const double seconds = seconds_of(stamp_of(measurement).measured_at);
      if (detects && seconds > 4 && seconds < 6)
        testing::stamp_in(measurement).measured_at += from_seconds(jump);
    }
    const auto cycles = run(drive_.rig, stream);
    ASSERT_EQ(cycles.size(), sound_.size());
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      if (seconds_of(cycles[i].lanes.time) < 6 + 0.8) continue;
      // Not all verified tracks: what has come behind the car meanwhile, no camera sees again.
      EXPECT_GT(witnesses(sound_[i]), 0U);
      EXPECT_EQ(witnesses(cycles[i]), witnesses(sound_[i])) << jump << " s, cycle " << i;
      break;
    }
  }
}

/// The own motion of a look that comes late is known better than that of one in time: not the last bit is the
/// same, but every track is, where it was.
bool near_objects(const std::vector<TrackedObject>& a, const std::vector<TrackedObject>& b) {
  return std::ranges::equal(a, b, [](const TrackedObject& p, const TrackedObject& q) {
    return p.id == q.id && std::hypot(p.x - q.x, p.y - q.y) < 0.1 && p.witness == q.witness;
  });
}

/// Detections that overtake each other by up to 200 ms leave the tracks as sorted ones do, once all are
/// there.
TEST_F(ObjectSensors, MayOvertakeEachOther) {
  std::vector<Measurement> stream = drive_.measurements;
  std::uint64_t number = 0;
  for (Measurement& measurement : stream) {
    const bool detects =
        std::holds_alternative<RadarScan>(measurement) || std::holds_alternative<CameraBoxes>(measurement);
    Stamp& stamp = testing::stamp_in(measurement);
    const double seconds = seconds_of(stamp.measured_at);
    if (!detects || seconds < 4 || seconds > 6) continue;
    number = number * 6364136223846793005U + 1442695040888963407U;
    stamp.received_at = stamp.measured_at + std::chrono::milliseconds(40 + (number >> 33) % 160);
  }
  std::ranges::stable_sort(stream, {}, [](const Measurement& m) { return stamp_of(m).received_at; });
  const auto cycles = run(drive_.rig, stream);
  ASSERT_EQ(cycles.size(), sound_.size());
  InputAccounting inputs;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const double seconds = seconds_of(cycles[i].lanes.time);
    EXPECT_TRUE(cycles[i].distrusted.empty()) << seconds;
    inputs += cycles[i].lanes.inputs;
    if (seconds < 4 || seconds > 6.3) {
      EXPECT_TRUE(near_objects(cycles[i].objects, sound_[i].objects)) << seconds;
    }
  }
  InputAccounting sorted;
  for (const CycleResult& cycle : sound_) sorted += cycle.lanes.inputs;
  EXPECT_EQ(inputs, sorted);
}

/// The whole car's clock, the other sensors' too.
TEST_F(ObjectSensors, RecoverWhereTheClockIsSet) {
  for (const double jump : {-86400.0, -5.0, -0.5, 0.5, 5.0, 86400.0}) {
    std::vector<Measurement> stream = drive_.measurements;
    for (Measurement& measurement : stream) {
      Stamp& stamp = testing::stamp_in(measurement);
      if (seconds_of(stamp.received_at) < 5) continue;
      stamp.measured_at += from_seconds(jump);
      stamp.received_at += from_seconds(jump);
    }
    const auto cycles = run(drive_.rig, stream);
    const auto valid = std::ranges::find_if(cycles, [&](const CycleResult& cycle) {
      const double seconds = seconds_of(cycle.lanes.time) - jump;
      return seconds > 5.5 && seconds < 7 && witnesses(cycle) > 0;
    });
    ASSERT_NE(valid, cycles.end()) << jump;
    EXPECT_LT(seconds_of(valid->lanes.time) - jump, 5 + 1.6) << jump;
  }
}

TEST_F(ObjectSensors, AreFlaggedWithinThreeCyclesWhereTheyFreeze) {
  for (const std::uint32_t sensor : {testing::kFrontRadar, testing::kLeftRadar}) {
    std::vector<RadarDetection> kept;
    const auto cycles = run(drive_.rig, broken_radar(drive_, sensor, [&](RadarScan& scan) {
                              if (kept.empty()) kept = scan.detections;
                              scan.detections = kept;
                            }));
    EXPECT_GT(flagged_after(cycles), 0);
    // The first look that repeats comes a period after the one that is repeated, and a latency later.
    EXPECT_LT(flagged_after(cycles), 0.08 + 0.04 + 3 * 0.08 + 0.001) << sensor;
    expect_blamed(cycles, sensor);
    EXPECT_TRUE(std::ranges::any_of(cycles, [](const CycleResult& cycle) {
      return cycle.lanes.status == EstimateStatus::degraded &&
             cycle.lanes.reason == StatusReason::sensor_inconsistent;
    }));
  }
}

TEST_F(ObjectSensors, AreFlaggedWhereTheySpeakOfDegrees) {
  const auto cycles = run(drive_.rig, broken_radar(drive_, testing::kFrontRadar, [](RadarScan& scan) {
                            for (RadarDetection& d : scan.detections) d.bearing *= 180 / 3.14159265358979;
                          }));
  EXPECT_GT(flagged_after(cycles), 0);
  EXPECT_LT(flagged_after(cycles), 2);
}

TEST_F(ObjectSensors, AreFlaggedWhereTheySpeakOfKilometresAnHour) {
  for (const std::uint32_t sensor : {testing::kFrontRadar, testing::kLeftRadar}) {
    const auto cycles = run(drive_.rig, broken_radar(drive_, sensor, [](RadarScan& scan) {
                              for (RadarDetection& d : scan.detections) d.range_rate *= 3.6;
                            }));
    EXPECT_GT(flagged_after(cycles), 0);
    EXPECT_LT(flagged_after(cycles), 2) << sensor;
    expect_blamed(cycles, sensor);
  }
}

TEST_F(ObjectSensors, AreFlaggedWhereLeftIsRight) {
  for (const std::uint32_t sensor : {testing::kFrontRadar, testing::kLeftRadar, testing::kRightRadar}) {
    const auto cycles = run(drive_.rig, broken_radar(drive_, sensor, [](RadarScan& scan) {
                              for (RadarDetection& d : scan.detections) d.bearing = -d.bearing;
                            }));
    EXPECT_GT(flagged_after(cycles), 0);
    EXPECT_LT(flagged_after(cycles), 2) << sensor;
    expect_blamed(cycles, sensor);
  }
}

TEST_F(ObjectSensors, AreFlaggedWhereTheCameraSeesAMirrorImage) {
  const auto stream = broken_camera(drive_, [&](CameraBoxes& boxes) { mirror(boxes, image_width(drive_)); });
  const auto cycles = run(drive_.rig, stream);
  EXPECT_GT(flagged_after(cycles), 0);
  EXPECT_LT(flagged_after(cycles), 2);
  expect_real_witnesses(cycles, drive_, kBegin + 2);
}

TEST_F(ObjectSensors, AreBelievedAgainSomeTimeAfterTheyCameRight) {
  std::vector<Measurement> stream = broken_radar(drive_, testing::kFrontRadar, [](RadarScan& scan) {
    if (seconds_of(scan.stamp.measured_at) > kBegin + 2) return;
    for (RadarDetection& d : scan.detections) d.range_rate *= 3.6;
  });
  const auto cycles = run(drive_.rig, stream);
  EXPECT_LT(flagged_after(cycles), 2);
  EXPECT_EQ(objects_of(cycles.back()), SourceStatus::ok);
}

/// Ghosts on both sides, in the lanes beyond the rails, as fast as the real ones.
TEST_F(ObjectSensors, BearNoWitnessForGhostsBesideGuardRails) {
  for (const int ghosts : {1, 4, 10}) {
    const auto stream = broken_radar(drive_, testing::kFrontRadar, [&](RadarScan& scan) {
      for (int i = 0; i < ghosts; ++i) {
        const double range = 35 + 6.0 * i;
        const double y = (i % 2 == 0 ? 1 : -1) * (4.0 + i % 5);
        scan.detections.push_back({std::hypot(range, y), std::atan2(y, range), 0.1 * i});
      }
    });
    const auto cycles = run(drive_.rig, stream);
    expect_real_witnesses(cycles, drive_, 0);
  }
}

}  // namespace
}  // namespace lanefuse
