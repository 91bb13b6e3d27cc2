// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config.hpp"
#include "simulation/drive_simulation.hpp"

namespace lanefuse {

/// The full system with one piece taken away, by name: what an ablation compares.
struct Variant {
  std::string_view name;
  std::string_view effect;
  void (*leave_out)(SimulationConfig&);  ///< takes a sensor from the drive
  std::string_view settings;             ///< "key=value" of the pipeline, parted by spaces; empty for none
  std::optional<EstimatorKind> of;       ///< the estimator whose piece it is, or of any
};

/// The full system on raw detections, from which it makes its tracks itself; it is not among variants().
inline constexpr std::string_view kDetectionsVariant = "detections";

/// Every ablation of any estimator; the first is the full system. A new ablation is a line here.
std::span<const Variant> variants();
std::vector<std::string> variant_names();

/// Throws a configuration Error that lists the names there are.
const Variant& find_variant(std::string_view name);

/// Whether the estimator of that name (see choose_estimator()) has the piece that the variant takes away.
bool has_piece(const Variant& variant, std::string_view estimator);
/// Throws a configuration Error that lists the names there are for the estimator.
void demand_piece(const Variant& variant, std::string_view estimator);

/// The pipeline's defaults with an estimator (see choose_estimator()), then the variant's settings, then
/// `assignments` ("key=value"). Throws a configuration Error where an assignment sets another estimator: the
/// line of results would name the wrong one; and where the estimator has no such piece.
PerceptionConfig configure(const Variant& variant, std::string_view estimator,
                           std::span<const std::string> assignments);

}  // namespace lanefuse
