// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "cli/run_sidecar.hpp"
#include "drawing/top_view.hpp"
#include "recording/drive_truth.hpp"
#include "recording/lanes_reader.hpp"

namespace lanefuse {

/// A recording of lanes together with the truth of the drive that they came from.
struct LanesAndTruth {
  std::optional<RunSidecar> sidecar;
  std::filesystem::path drive;  ///< where the truth was read
  std::optional<DriveTruth> truth;
};

/// Looks for the drive: the one given, else the one that the run's sidecar names. Throws Error
/// (configuration) where a given drive is not the one that the lanes came from; leaves `truth` empty where no
/// drive is found.
LanesAndTruth find_truth(const std::filesystem::path& lanes,
                         const std::optional<std::filesystem::path>& drive);

/// One cycle as a picture, with whatever truth there is.
TopView make_view(const LaneRecord& record, const LanesAndTruth& context);

}  // namespace lanefuse
