// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// The standard planar graphs and the sliding windows of lane features reach their published optima.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "graph/g2o.hpp"
#include "graph/solver.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

struct KnownOptimum {
  const char* file;
  double chi2;
};

void PrintTo(const KnownOptimum& known, std::ostream* out) { *out << known.file; }

class StandardGraph : public ::testing::TestWithParam<KnownOptimum> {};

TEST_P(StandardGraph, ReachesItsOptimum) {
  const auto file = testing::real_data(GetParam().file);
  LANEFUSE_NEEDS_DATA(file);
  PoseGraph graph = read_g2o(file).graph;
  SolverConfig config;
  config.max_iterations = 100;
  config.switch_form = SwitchForm::squared;
  const SolveResult result = make_schur_solver()->solve(graph, config);
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_NEAR(result.final_chi2, GetParam().chi2, 1e-6 * GetParam().chi2);
  EXPECT_NEAR(chi_squared(graph, config.switch_form), result.final_chi2, 1e-9 * result.final_chi2);
}

INSTANTIATE_TEST_SUITE_P(Standard, StandardGraph,
                         ::testing::Values(KnownOptimum{"pose_graphs/M3500.g2o", 146.076745},
                                           KnownOptimum{"pose_graphs/intel.g2o", 546.461112},
                                           KnownOptimum{"pose_graphs/MIT.g2o", 770.663502},
                                           KnownOptimum{"pose_graphs/CSAIL.g2o", 40.555129},
                                           KnownOptimum{"pose_graphs/city10000.g2o", 511.985164},
                                           KnownOptimum{"pose_graphs/ring.g2o", 11.163101},
                                           KnownOptimum{"lane_graphs/typical_switch.g2o", 20973.5655}),
                         [](const auto& known) {
                           const std::filesystem::path file(known.param.file);
                           return file.stem().string();
                         });

TEST(LaneGraphs, LandmarksAreToldFromPoses) {
  const std::pair<const char*, std::ptrdiff_t> known[] = {{"light", 464}, {"typical", 906}, {"heavy", 1725}};
  for (const auto& [name, landmarks] : known) {
    const auto file = testing::real_data(std::string("lane_graphs/") + name + ".g2o");
    LANEFUSE_NEEDS_DATA(file);
    const PoseGraph graph = read_g2o(file).graph;
    EXPECT_EQ(std::count_if(graph.vertices.begin(), graph.vertices.end(),
                            [](const Vertex& v) { return v.role == VertexRole::landmark; }),
              landmarks);
  }
}

TEST(LaneGraphs, TwoIterationsComeWithinAThousandthOfTheOptimum) {
  for (const char* name : {"light", "typical", "heavy"}) {
    const auto file = testing::real_data(std::string("lane_graphs/") + name + ".g2o");
    LANEFUSE_NEEDS_DATA(file);
    PoseGraph twice = read_g2o(file).graph;
    PoseGraph to_the_end = twice;
    SolverConfig config;
    make_schur_solver()->solve(twice, config);
    config.max_iterations = 50;
    make_schur_solver()->solve(to_the_end, config);
    EXPECT_LT(chi_squared(twice), 1.001 * chi_squared(to_the_end)) << name;
  }
}

}  // namespace
}  // namespace lanefuse
