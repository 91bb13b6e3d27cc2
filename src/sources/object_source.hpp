// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "objects/object_tracker.hpp"
#include "objects/radar_alignment.hpp"
#include "objects/sensor_trust.hpp"
#include "sources/feature_source.hpp"
#include "sources/sighting_maker.hpp"
#include "sources/witness.hpp"

namespace lanefuse {

struct ObjectSourceConfig {
  bool enabled = true;
  WitnessConfig witness;
  ObjectTrackerConfig tracker;
  SightingMakerConfig sensors;
  SensorTrustConfig trust;
  RadarAlignmentConfig alignment;
};

/// Other vehicles as witnesses of their lanes [IROS16, sec. II-E4]: from the object lists of a production
/// fusion, and from radars' reflections and cameras' boxes through a tracker of our own.
class ObjectSource final : public FeatureSource {
 public:
  explicit ObjectSource(const ObjectSourceConfig& config)
      : config_(config),
        maker_(config.sensors),
        tracker_(config.tracker),
        trust_(config.trust),
        alignment_(config.alignment) {}
  InputAccounting add(const Measurement& measurement, const SourceContext& context) override;
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override;

  /// The vehicles known in the last cycle, in the vehicle frame at its time: those of our own tracker, else
  /// those of the last object list.
  [[nodiscard]] std::span<const TrackedObject> objects() const { return objects_; }

  /// The ids of the sensors whose detections are left out, as they contradict themselves or the others.
  [[nodiscard]] std::span<const std::uint32_t> distrusted() const { return trust_.distrusted(); }

  /// By how much radars were found to be turned against what the rig says.
  [[nodiscard]] const RadarAlignment& alignment() const { return alignment_; }

 private:
  ObjectSourceConfig config_;
  SightingMaker maker_;
  ObjectTracker tracker_;
  SensorTrust trust_;
  RadarAlignment alignment_;
  SightingSet look_;
  std::optional<Time> last_look_;
  std::optional<Time> last_witness_;  ///< the look as of which the tracks bore witness last
  std::optional<ObjectList> last_list_;
  std::vector<FeatureSet> pending_;
  std::vector<TrackedObject> objects_;
  std::vector<TrackedObject> then_;  ///< tracks at the time of the last look

  InputAccounting add_list(const ObjectList& list, const SourceContext& context);
  template <typename Detection>
  InputAccounting add_look(bool made, const std::vector<Detection>& detections, const SourceContext& context);
  bool follow(const SourceContext& context);
  void report_tracks(Time now, const SourceContext& context);
  void report_list(Time now, const SourceContext& context);
  void bear_witness(std::span<const TrackedObject> objects, const Stamp& stamp, const SourceContext& context);
};

}  // namespace lanefuse
