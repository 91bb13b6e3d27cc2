// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "drawing/report.hpp"

namespace lanefuse {

/// What a run leaves beside its recording, in NAME.mcap.run.json: everything that the same input does not
/// make the same, wall-clock times above all, and the way back to the drive with its truth.
struct RunSidecar {
  std::filesystem::path drive;
  RunFigures figures;
};

std::filesystem::path sidecar_of(const std::filesystem::path& lanes);
void write_sidecar(const std::filesystem::path& lanes, const RunSidecar& sidecar);

/// Nothing where there is none. Throws Error (input) where there is one that cannot be read.
std::optional<RunSidecar> read_sidecar(const std::filesystem::path& lanes);

}  // namespace lanefuse
