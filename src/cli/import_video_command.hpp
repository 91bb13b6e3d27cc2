// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "importing/video.hpp"

namespace lanefuse {

/// `lanefuse import video FILE`: turns a plain video into a recording, with the car's motion from the road.
struct ImportVideoOptions {
  VideoImport import;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int import_video_drive(const ImportVideoOptions& options);

}  // namespace lanefuse
