// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "evaluation/tracking_figures.hpp"

namespace lanefuse {

struct NamedTracking {
  std::string name;
  TrackingFigures figures;
};

/// Figures for a terminal, a line each, those of several trackers side by side. Not empty.
std::string to_text(const std::vector<NamedTracking>& trackers);

}  // namespace lanefuse
