// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/g2o.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "graph/loops.hpp"
#include "graph/random_graph.hpp"

namespace lanefuse {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

G2oGraph read(const std::string& text) {
  std::istringstream in(text);
  return read_g2o(in, "some.g2o");
}

std::string written(const G2oGraph& graph) {
  std::ostringstream out;
  write_g2o(out, graph);
  return out.str();
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    return error.what();
  }
  return "read without complaint";
}

RC_GTEST_PROP(G2o, WhatIsWrittenIsReadBackToTheLastBit, (unsigned seed)) {
  G2oGraph before;
  before.graph = testing::GraphMaker({.seed = seed, .noise = 0.2}).make();
  make_loops_switchable(before.graph, 3.3);
  const G2oGraph after = read(written(before));
  RC_ASSERT(after.graph.vertices.size() == before.graph.vertices.size());
  RC_ASSERT(after.graph.edges.size() == before.graph.edges.size());
  for (std::size_t v = 0; v < after.graph.vertices.size(); ++v) {
    RC_ASSERT(after.graph.vertices[v].pose == before.graph.vertices[v].pose);
    RC_ASSERT(after.graph.vertices[v].fixed == before.graph.vertices[v].fixed);
  }
  for (std::size_t i = 0; i < after.graph.edges.size(); ++i) {
    const Edge& a = before.graph.edges[i];
    const Edge& b = after.graph.edges[i];
    RC_ASSERT(a.from == b.from && a.to == b.to && a.switch_index == b.switch_index);
    RC_ASSERT(a.measurement == b.measurement);
    RC_ASSERT(Eigen::Matrix3d(a.information.triangularView<Eigen::Upper>()) ==
              Eigen::Matrix3d(b.information.triangularView<Eigen::Upper>()));
  }
  RC_ASSERT(written(after) == written(before));
}

TEST(G2o, LinesComeInAnyOrderWithAnyEndingAndComments) {
  const G2oGraph g = read(
      "# a graph\r\n"
      "EDGE_SE2 7 -3 1 +2 0.5 1 0 0 2 0 3 # seen twice\r\n"
      "\r\n"
      "FIX 900000000000\t\r\n"
      "  VERTEX_SE2 -3 1e0 2 3\r\n"
      "VERTEX_SE2 900000000000 0 0 4\n"
      "EDGE_SE2 -3 900000000000 0 0 0 1 .1 .2 2 .3 3\n"
      "VERTEX_SE2 7 5 6 -0.5");
  EXPECT_THAT(g.vertex_ids, ElementsAre(7, -3, 900000000000));
  EXPECT_EQ(g.graph.vertices[0].pose, (Pose2{5, 6, -0.5}));
  EXPECT_EQ(g.graph.vertices[1].pose, (Pose2{1, 2, 3}));
  EXPECT_EQ(g.graph.vertices[2].pose.heading, wrap_angle(4));
  EXPECT_FALSE(g.graph.vertices[0].fixed || g.graph.vertices[1].fixed);
  EXPECT_TRUE(g.graph.vertices[2].fixed);
  ASSERT_EQ(g.graph.edges.size(), 2u);
  EXPECT_EQ(g.graph.edges[0].measurement, (Pose2{1, 2, 0.5}));
  const Eigen::Matrix3d expected = (Eigen::Matrix3d() << 1, .1, .2, .1, 2, .3, .2, .3, 3).finished();
  EXPECT_EQ(g.graph.edges[1].information, expected);
}

TEST(G2o, SwitchesComeWithTheirEdgesAndPriors) {
  const G2oGraph g = read(
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SWITCH 9 0.5\n"
      "EDGE_SWITCH_PRIOR 9 1 4\nEDGE_SE2_SWITCHABLE 0 1 9 1 0 0 1 0 0 1 0 1\n");
  ASSERT_EQ(g.graph.switches.size(), 1u);
  EXPECT_EQ(g.graph.switches[0].prior, 4);
  EXPECT_EQ(g.graph.switches[0].value, 0.5);
  EXPECT_EQ(g.graph.edges[0].switch_index, 0u);
  EXPECT_THAT(g.switch_ids, ElementsAre(9));
}

TEST(G2o, WithoutAFixLineTheLowestIdIsHeld) {
  const G2oGraph g = read("EDGE_SE2 4 2 1 0 0 1 0 0 1 0 1\nEDGE_SE2 2 3 1 0 0 1 0 0 1 0 1\n");
  EXPECT_THAT(g.vertex_ids, ElementsAre(4, 2, 3));
  EXPECT_FALSE(g.graph.vertices[0].fixed);
  EXPECT_TRUE(g.graph.vertices[1].fixed);
}

TEST(G2o, VerticesWithoutLinesArePlacedAlongTheChainBeforeAnyOtherEdge) {
  // The loop closure 0 -> 2 comes first and is wrong; 12 hangs on a loose edge that points towards the chain.
  const G2oGraph g = read(
      "EDGE_SE2 0 2 50 50 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 1 1 0 1.5707963267948966 1 0 0 1 0 1\n"
      "EDGE_SE2 1 2 2 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 12 2 0 3 0 1 0 0 1 0 1\n");
  ASSERT_THAT(g.vertex_ids, ElementsAre(0, 2, 1, 12));
  EXPECT_LT((g.graph.vertices[1].pose.position() - Eigen::Vector2d(1, 2)).norm(), 1e-12);
  EXPECT_LT((g.graph.vertices[3].pose.position() - Eigen::Vector2d(4, 2)).norm(), 1e-12);
}

TEST(G2o, LandmarksAreThoseThatMeasureNobodyWhoLeadsToTheFixedOne) {
  const std::string rest = " 0 0 1 0 0 1 0 1\n";
  const G2oGraph g = read("FIX 2\nEDGE_SE2 0 1 0" + rest + "EDGE_SE2 1 2 0" + rest + "EDGE_SE2 0 10 0" +
                          rest + "EDGE_SE2 2 11 0" + rest + "EDGE_SE2 10 11 0" + rest);
  std::vector<bool> is_landmark;
  for (const Vertex& v : g.graph.vertices) is_landmark.push_back(v.role == VertexRole::landmark);
  EXPECT_THAT(g.vertex_ids, ElementsAre(2, 0, 1, 10, 11));
  EXPECT_THAT(is_landmark, ElementsAre(false, false, false, true, true));
}

TEST(G2o, ATrajectoryHeldAtItsBeginningHasNoLandmarks) {
  const std::string rest = " 0 0 1 0 0 1 0 1\n";
  const G2oGraph g = read("FIX 0\nEDGE_SE2 0 1 0" + rest + "EDGE_SE2 1 2 0" + rest + "EDGE_SE2 2 3 0" + rest);
  for (const Vertex& v : g.graph.vertices) EXPECT_EQ(v.role, VertexRole::pose);
}

struct Refusal {
  const char* name;
  const char* text;
  const char* says;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class G2oRefuses : public ::testing::TestWithParam<Refusal> {};

TEST_P(G2oRefuses, NamingThePlace) { EXPECT_THAT(refusal(GetParam().text), HasSubstr(GetParam().says)); }

constexpr Refusal kRefusals[] = {
    {"Nothing", "# nothing\n", "some.g2o: there is no graph"},
    {"UnknownTag", "VERTEX_SE2 0 0 0 0\nEDGE_SE3 0 1\n", "some.g2o:2: unknown tag 'EDGE_SE3'"},
    {"Binary", "\x01\xff garbage", "some.g2o:1: unknown tag '?"},
    {"NotANumber", "VERTEX_SE2 0 1,5 0 0\n", "some.g2o:1: '1,5' is not a number"},
    {"NaN", "\nVERTEX_SE2 0 0 nan 0\n", "some.g2o:2: 'nan' is not a finite number"},
    {"Infinity", "VERTEX_SE2 0 0 0 -inf\n", "'-inf' is not a finite number"},
    {"TooLarge", "VERTEX_SE2 0 0 0 1e999\n", "'1e999' is not a number"},
    {"NotAnId", "VERTEX_SE2 1.5 0 0 0\n", "'1.5' is not an id"},
    {"HugeId", "VERTEX_SE2 99999999999999999999 0 0 0\n", "'99999999999999999999' is not an id"},
    {"NoId", "FIX\n", "some.g2o:1: the line ends where an id"},
    {"TooFew", "EDGE_SE2 0 1 0 0 0 1 0 0 1 0\n", "some.g2o:1: the line ends where a number"},
    {"TooMany", "VERTEX_SE2 0 0 0 0 7\n", "'7' is one value too many"},
    {"Twice", "VERTEX_SE2 3 0 0 0\nVERTEX_SE2 3 0 0 0\n", "some.g2o:2: vertex 3 is given twice"},
    {"SelfEdge", "EDGE_SE2 5 5 0 0 0 1 0 0 1 0 1\n", "from vertex 5 to itself"},
    {"Indefinite", "EDGE_SE2 0 1 0 0 0 1 2 0 1 0 1\n", "some.g2o:1: the information matrix is not positive"},
    {"Negative", "EDGE_SE2 0 1 0 0 0 1 0 0 1 0 -1\n", "some.g2o:1: the information matrix is not positive"},
    {"FixOfNobody", "VERTEX_SE2 0 0 0 0\nFIX 4\n", "some.g2o:2: there is no vertex 4"},
    {"Lost", "VERTEX_SE2 0 0 0 0\nEDGE_SE2 1 2 0 0 0 1 0 0 1 0 1\n", "some.g2o:2: vertex 1 has no place"},
    {"NoSwitch", "VERTEX_SE2 0 0 0 0\nEDGE_SE2_SWITCHABLE 0 1 8 0 0 0 1 0 0 1 0 1\n",
     "there is no VERTEX_SWITCH 8"},
    {"NoPrior", "VERTEX_SE2 0 0 0 0\nVERTEX_SWITCH 8 1\n", "some.g2o:2: switch 8 has no EDGE_SWITCH_PRIOR"},
    {"PriorTwice", "EDGE_SWITCH_PRIOR 8 1 1\nEDGE_SWITCH_PRIOR 8 1 1\n", "prior of switch 8 is given twice"},
    {"PriorOff", "EDGE_SWITCH_PRIOR 8 0 1\n", "the prior of a switch is 1"},
    {"PriorOfNoWeight", "EDGE_SWITCH_PRIOR 8 1 0\n", "must be positive"},
    {"SwitchTwice", "VERTEX_SWITCH 8 1\nVERTEX_SWITCH 8 1\n", "some.g2o:2: switch 8 is given twice"},
    {"SwitchBeyond", "VERTEX_SWITCH 8 1.5\n", "between 0 and 1"},
    {"OneIdForBoth", "VERTEX_SE2 8 0 0 0\nVERTEX_SWITCH 8 1\nEDGE_SWITCH_PRIOR 8 1 1\n",
     "id 8 names a vertex and a switch"},
};

INSTANTIATE_TEST_SUITE_P(Refusals, G2oRefuses, ::testing::ValuesIn(kRefusals),
                         [](const auto& refusal_case) { return refusal_case.param.name; });

TEST(G2o, AFileThatIsNotThereIsNamed) {
  EXPECT_THAT([] { read_g2o(std::filesystem::path("no/such.g2o")); },
              ::testing::ThrowsMessage<Error>(HasSubstr("no/such.g2o")));
}

}  // namespace
}  // namespace lanefuse
