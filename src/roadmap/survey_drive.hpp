// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/clothoid.hpp"
#include "roadmap/geo_frame.hpp"
#include "roadmap/survey_config.hpp"
#include "roadmap/survey_track.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// One marking of the car's own lane, as the serial camera saw it at one moment.
struct SeenMarking {
  Time time{};
  Side side = Side::none;
  Clothoid
      line;  ///< vehicle frame: the paint's inner edge, or its middle where the camera measured its width
  double variance = 0;     ///< [m^2] of the line's offset, as the camera believes
  double paint_width = 0;  ///< [m]; 0: not measured
  MarkingEvidence marking;
};

/// The markings of a message that can be believed.
std::vector<SeenMarking> markings_of(const SerialLane& lane);

/// A drive, reduced to what a survey needs: some 100 kB a kilometre.
struct SurveyedDrive {
  std::string name;
  std::vector<TrackNode> track;
  std::vector<SeenMarking> markings;  ///< in order of measuring
};

/// Takes a drive's measurements one by one, in the order of receiving; whatever is no fix, motion or serial
/// camera's lane, and what is implausible, is passed over.
class SurveyRecorder {
 public:
  /// `name` is the drive's, for errors.
  SurveyRecorder(std::string name, const GeoFrame& frame, Rig rig, const SurveyConfig& config = {});

  void add(const Measurement& measurement);

  /// Once, at the end. Throws Error (input) where the drive holds no two fixes, or no marking between them.
  SurveyedDrive finish();

 private:
  GeoFrame frame_;
  Rig rig_;
  SurveyConfig config_;
  TrackSmoother smoother_;
  Time next_fix_{};
  SurveyedDrive drive_;

  void add_fix(const GnssInsFix& fix);
};

/// A fix as the pose of the vehicle frame: the sensor's mounting taken off.
TrackSmoother::Fix vehicle_fix(const GnssInsFix& fix, const GeoFrame& frame, const Rig& rig);

}  // namespace lanefuse
