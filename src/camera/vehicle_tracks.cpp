// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_tracks.hpp"

#include <algorithm>

namespace lanefuse {
namespace {

constexpr double kLeastOverlap = 0.3;  ///< of a track and its box
constexpr double kGain = 0.35;         ///< of places
constexpr double kSpeedGain = 0.06;    ///< of their changes
constexpr double kNewScore = 0.58;     ///< what founds a track; less goes on with one

void move(PixelBox& box, const PixelBox& by, double times) {
  box.left += times * by.left;
  box.top += times * by.top;
  box.right += times * by.right;
  box.bottom += times * by.bottom;
}

PixelBox difference(const PixelBox& a, const PixelBox& b) {
  return {a.left - b.left, a.top - b.top, a.right - b.right, a.bottom - b.bottom};
}

void blend(double& value, double measured) { value += kGain * (measured - value); }

void take(VehicleTracks::Track& track, const FoundVehicle& found, double seconds) {
  const PixelBox surprise = difference(found.shape.box, track.shape.box);
  move(track.shape.box, surprise, kGain);
  if (seconds > 0) move(track.velocity, surprise, kSpeedGain / seconds);
  blend(track.shape.distance, found.shape.distance);
  blend(track.shape.lateral, found.shape.lateral);
  blend(track.shape.width, found.shape.width);
  blend(track.score, found.score);
  ++track.hits;
  track.unseen = 0;
}

}  // namespace

void VehicleTracks::predict(double seconds) {
  for (Track& track : tracks_) {
    move(track.shape.box, track.velocity, seconds);
    track.unseen += seconds;
  }
}

void VehicleTracks::update(const std::vector<FoundVehicle>& found, double seconds) {
  predict(seconds);
  std::vector<bool> taken(found.size(), false);
  std::stable_sort(tracks_.begin(), tracks_.end(),
                   [](const Track& a, const Track& b) { return a.hits > b.hits; });
  for (Track& track : tracks_) {
    std::size_t best = found.size();
    double best_overlap = kLeastOverlap;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double share = overlap(track.shape.box, found[i].shape.box);
      if (taken[i] || share < best_overlap) continue;
      best = i;
      best_overlap = share;
    }
    if (best == found.size()) continue;
    taken[best] = true;
    take(track, found[best], seconds);
  }
  const auto lost = [this](const Track& track) {
    return confirmed(track) ? track.unseen > config_.coast : track.unseen > 0;
  };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), lost), tracks_.end());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!taken[i] && found[i].score >= kNewScore)
      tracks_.push_back({found[i].shape, {}, found[i].score, 1, 0});
  }
}

}  // namespace lanefuse
