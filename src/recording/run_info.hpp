// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sensors/drive.hpp"

namespace lanefuse {

/// How lanes were estimated, in the metadata of their recording: what a result must be read with.
struct RunInfo {
  WitnessRule witness = WitnessRule::radar_and_camera;  ///< the rule that the run used
  std::string estimator;                                ///< "graph" or "road"
  std::string configuration_hash;                       ///< of the configuration that the run used
  friend bool operator==(const RunInfo&, const RunInfo&) = default;
};

}  // namespace lanefuse
