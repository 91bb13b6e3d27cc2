// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Lesson 1: fuse a recorded drive, and print the ego lane's width and curvature once a second.
#include <cstdio>
#include <lanefuse/core/error.hpp>
#include <lanefuse/pipeline/perception.hpp>
#include <lanefuse/recording/drive_reader.hpp>
#include <optional>

namespace {

void print(const lanefuse::LaneEstimate& lanes, double seconds) {
  std::printf("%5.1f s  ", seconds);
  const lanefuse::Lane* ego = lanefuse::ego_lane(lanes);
  if (!ego) {
    std::printf("no ego lane: %s\n", to_string(lanes.reason));
    return;
  }
  const lanefuse::Clothoid& left = find_boundary(lanes, ego->left_boundary)->clothoid;
  const lanefuse::Clothoid& right = find_boundary(lanes, ego->right_boundary)->clothoid;
  std::printf("ego lane %.2f m wide, curvature %+.5f 1/m\n", left.lateral_offset - right.lateral_offset,
              (left.curvature + right.curvature) / 2);
}

void fuse(const char* path) {
  lanefuse::DriveReader drive(path);
  lanefuse::MultiLanePerception perception(lanefuse::default_config(drive.info().witness), drive.rig());
  std::optional<lanefuse::Time> first;
  for (lanefuse::Measurement measurement; drive.next(measurement); perception.add(measurement)) {
    while (const lanefuse::LaneEstimate* lanes = perception.advance(stamp_of(measurement).received_at)) {
      if (!first) first = lanes->time;
      const lanefuse::Duration since = lanes->time - *first;
      if (since % std::chrono::seconds(1) < std::chrono::milliseconds(80))
        print(*lanes, lanefuse::to_seconds(since));
    }
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return std::puts("usage: fuse_a_drive DRIVE.mcap"), 2;
  fuse(argv[1]);
} catch (const lanefuse::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
