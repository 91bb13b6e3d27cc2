// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "graph/pose_graph.hpp"
#include "graph/window_graph.hpp"

namespace lanefuse {

/// Numbered .g2o files of a run's windows: 000000.g2o, 000001.g2o, ... g2o's switchable edges have the
/// squared form; a window whose switches have the linear one is written with the same priors.
class WindowDump {
 public:
  /// Makes the folder if it is not there. Throws a configuration Error for one that holds windows already
  /// (unless `force`: they are removed), or that cannot be made.
  WindowDump(std::filesystem::path folder, bool force);

  void write(const WindowGraph& window);

 private:
  std::filesystem::path folder_;
  std::uint64_t next_ = 0;
  PoseGraph graph_;  ///< scratch
};

}  // namespace lanefuse
