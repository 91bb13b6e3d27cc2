// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "objects/radar_tracker.hpp"
#include "sources/feature_source.hpp"
#include "sources/witness.hpp"

namespace lanefuse {

struct ObjectSourceConfig {
  bool enabled = true;
  WitnessConfig witness;
  RadarTrackerConfig radar_tracker;
};

/// Other vehicles as witnesses of their lanes [IROS16, sec. II-E4]: from the object lists of a production
/// fusion, and from raw radar scans through a tracker of our own.
class ObjectSource final : public FeatureSource {
 public:
  explicit ObjectSource(const ObjectSourceConfig& config) : config_(config), tracker_(config.radar_tracker) {}
  InputAccounting add(const Measurement& measurement, const SourceContext& context) override;
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override;

  /// The vehicles of the last list or scan, in the vehicle frame.
  [[nodiscard]] std::span<const TrackedObject> objects() const { return objects_; }

 private:
  InputAccounting add_list(const ObjectList& list, const SourceContext& context);
  InputAccounting add_scan(const RadarScan& scan, const SourceContext& context);
  void bear_witness(const std::vector<TrackedObject>& objects, const Stamp& stamp,
                    const SourceContext& context);

  ObjectSourceConfig config_;
  RadarTracker tracker_;
  std::vector<TrackedObject> objects_;
  std::vector<FeatureSet> pending_;
};

}  // namespace lanefuse
