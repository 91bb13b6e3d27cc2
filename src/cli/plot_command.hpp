// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace lanefuse {

/// `lanefuse plot LANES --at SECONDS -o FRAME.svg`: draws one moment from above; with `--tracks` instead, the
/// tracked vehicles of the whole drive over time.
struct PlotOptions {
  std::filesystem::path lanes;
  double at = 0;                               ///< [s] since the first cycle
  std::optional<std::filesystem::path> drive;  ///< with the truth; else the one that the run names
  bool tracks = false;                         ///< all tracks over time instead of one moment
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int plot(const PlotOptions& options);

}  // namespace lanefuse
