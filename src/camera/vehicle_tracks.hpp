// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/vehicle_shapes.hpp"

namespace lanefuse {

/// A box that was found in one image, and how sure that is.
struct FoundVehicle {
  VehicleShape shape;
  double score = 0;
};

/// Boxes followed over images: confirmed by several images, kept for a while when they are not found.
class VehicleTracks {
 public:
  explicit VehicleTracks(const VehicleDetectorConfig& config) : config_(config) {}

  struct Track {
    VehicleShape shape;  ///< filtered
    PixelBox velocity;   ///< [px/s] of the box's edges
    double score = 0;    ///< filtered
    int hits = 0;
    double unseen = 0;  ///< [s]
  };

  /// One image's boxes, the best first; `seconds` since the image before.
  void update(const std::vector<FoundVehicle>& found, double seconds);
  void clear() { tracks_.clear(); }

  [[nodiscard]] const std::vector<Track>& all() const { return tracks_; }
  [[nodiscard]] bool confirmed(const Track& track) const {
    return track.hits >= config_.frames_to_confirm && track.score > kBelieved;
  }

 private:
  static constexpr double kBelieved = 0.5;  ///< score, on average
  VehicleDetectorConfig config_;
  std::vector<Track> tracks_;

  void predict(double seconds);
};

}  // namespace lanefuse
