// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/toro.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "graph/graph_file.hpp"
#include "graph/loops.hpp"
#include "graph/random_graph.hpp"

namespace lanefuse {
namespace {

G2oGraph some_graph() {
  G2oGraph g{testing::GraphMaker({.landmarks = 0, .ties = 0, .noise = 0.1}).make(), {}, {}};
  for (Vertex& vertex : g.graph.vertices) vertex.fixed = false;
  g.graph.vertices.front().fixed = true;
  return g;
}

TEST(Toro, ReadsBackToTheLastBit) {
  const G2oGraph written = some_graph();
  std::istringstream text(graph_text(written, GraphFormat::toro));
  const G2oGraph read = read_g2o(text, "x.graph");
  EXPECT_EQ(graph_text(read, GraphFormat::g2o), graph_text(written, GraphFormat::g2o));
}

TEST(Toro, InformationStandsInItsOwnOrder) {
  std::istringstream text("VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\nEDGE2 0 1 1 0 0 11 2 12 13 3 4\n");
  const Eigen::Matrix3d information = read_g2o(text, "x.graph").graph.edges.front().information;
  EXPECT_EQ(information, (Eigen::Matrix3d{{11, 2, 3}, {2, 12, 4}, {3, 4, 13}}));
}

TEST(Toro, WhatIsLostIsSaid) {
  G2oGraph g = some_graph();
  EXPECT_TRUE(lost_in(GraphFormat::toro, g).empty());
  make_loops_switchable(g.graph, 1);
  g.graph.vertices.back().fixed = true;
  EXPECT_EQ(lost_in(GraphFormat::toro, g).size(), 2U);
  EXPECT_TRUE(lost_in(GraphFormat::g2o, g).empty());
}

TEST(GraphFile, TheEndingNamesTheFormat) {
  EXPECT_EQ(graph_format("a.g2o"), GraphFormat::g2o);
  EXPECT_EQ(graph_format("a.graph"), GraphFormat::toro);
  EXPECT_THROW(graph_format("a.txt"), Error);
}

}  // namespace
}  // namespace lanefuse
