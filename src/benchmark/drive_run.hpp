// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmark/result_line.hpp"

namespace lanefuse {

/// One drive of a benchmark, and what the pipeline is set to beside its variant.
struct DriveJob {
  DriveKey key;
  std::vector<std::string> assignments;  ///< "key=value"
};

/// A clock [s] that whoever runs a benchmark hands in; empty where no times are wanted.
using WallClock = std::function<double()>;

/// Throws a configuration Error where the job cannot be run.
Provenance provenance_of(const DriveJob& job, const std::string& version);

/// Simulates, fuses and judges the drive, side by side and without files: only the road and 24 bytes a cycle
/// grow with its length. The same job gives the same figures; `progress` hears now and then how far it is, in
/// [0, 1].
///
/// Gives the line's JSON behind its head: what `evaluate --json` says, `inputs`, `graph` of a graph, and with
/// a clock the keys of kTimeKeys.
nlohmann::ordered_json run_drive(const DriveJob& job, const WallClock& clock,
                                 const std::function<void(double)>& progress);

}  // namespace lanefuse
