// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/error.hpp"
#include "peers/ceres_solver.hpp"

namespace lanefuse {

bool has_ceres() { return false; }

std::vector<std::string> ceres_settings() { return {}; }

std::unique_ptr<GraphSolver> make_ceres_solver(std::string_view /*setting*/) {
  throw configuration_error("solver ceres", "is not part of this program",
                            "install libceres-dev and build Lanefuse anew");
}

}  // namespace lanefuse
