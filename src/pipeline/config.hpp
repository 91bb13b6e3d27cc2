// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

#include "fusion/fusion_config.hpp"
#include "lanes/lane_model_config.hpp"
#include "road/road_config.hpp"
#include "sources/camera_images.hpp"
#include "sources/dead_reckoning.hpp"
#include "sources/ego_path_source.hpp"
#include "sources/high_resolution_camera_source.hpp"
#include "sources/lane_segmentation_source.hpp"
#include "sources/object_source.hpp"
#include "sources/serial_camera_source.hpp"

namespace lanefuse {

struct SourcesConfig {
  DeadReckoningConfig odometry;
  CameraImagesConfig images;
  SerialCameraConfig serial_camera;
  HighResolutionCameraConfig high_resolution_camera;
  ObjectSourceConfig objects;
  EgoPathConfig ego_path;
  LaneSegmentationSourceConfig lane_segmentation;
};

/// What fuses: the paper's graph and lane model, or the road-level estimator.
enum class EstimatorKind : std::uint8_t { graph = 0, road = 1 };
const char* to_string(EstimatorKind kind);

/// Everything that can be set. Each module owns its struct; here they meet.
struct PerceptionConfig {
  EstimatorKind estimator = EstimatorKind::graph;
  double cycle_hz = 12.5;           ///< [Hz] cycles a second of recorded time
  double reorder_window_s = 0.2;    ///< [s] measurements older than this at their cycle are dropped
  double silence_s = 0.5;           ///< [s] after which a source that has spoken counts as unavailable
  std::uint32_t max_objects = 256;  ///< objects or detections in one message; more are dropped
  SourcesConfig sources;
  FusionConfig fusion;
  LaneModelConfig lanes;
  RoadConfig road;
};

/// The defaults for a drive by the witness rule that it was recorded with.
///
/// `radar_and_camera` is the paper. `radar_only` is for drives without a camera, and goes beyond the paper
/// where nothing but vehicles tells of the lanes: the car itself is a witness of its own, and the road's
/// course is fitted to positions and headings together, since a vehicle's place is better known than its
/// heading. Measured in docs/comma2k19.md.
PerceptionConfig default_config(WitnessRule rule);

/// Reads a YAML file over `defaults`. Every key is optional; a key that does not exist, a value of the wrong
/// kind or out of range is refused with a configuration Error that names file, line and key.
PerceptionConfig load_config(const std::filesystem::path& file, const PerceptionConfig& defaults = {});

/// The same from text; `name` stands for the file in errors.
PerceptionConfig parse_config(const std::string& yaml, const std::string& name,
                              const PerceptionConfig& defaults = {});

/// Sets one key, as "fusion.width_edges=false" from a command line would. Throws a configuration Error as
/// load_config().
void set_key(PerceptionConfig& config, const std::string& assignment);

/// Names a configuration: equal fingerprints, equal settings.
std::string fingerprint(const PerceptionConfig& config);

/// The configuration as YAML that load_config() reads back, each key with effect, unit and range as its
/// comment.
std::string to_yaml(const PerceptionConfig& config);

}  // namespace lanefuse
