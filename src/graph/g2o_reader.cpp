// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <unordered_map>
#include <utility>

#include <Eigen/Eigenvalues>

#include "graph/g2o.hpp"
#include "graph/g2o_line.hpp"
#include "graph/landmark_roles.hpp"
#include "graph/placing.hpp"

namespace lanefuse {

namespace {

/// The information is written with a handful of digits: that much below zero an eigenvalue may come out.
constexpr double kEigenvalueSlack = 1e-6;

bool is_positive_semidefinite(const Eigen::Matrix3d& m) {
  const Eigen::Vector3d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
  return eigenvalues[0] >= -kEigenvalueSlack * eigenvalues[2];
}

/// Where an id was first spoken of, to be named if nothing ever stands behind it.
struct Mention {
  std::uint32_t index = 0;
  std::size_t line = 0;
  bool given = false;  ///< whether its own line has come
};

/// The order in which an edge's line gives its information.
using InformationOrder = std::array<std::pair<int, int>, 6>;
constexpr InformationOrder kByRows{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
constexpr InformationOrder kAsInToro{{{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}};

struct EdgeWords {
  bool switched;
  const InformationOrder& information;
};

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}
  void read_line(const std::string& text);
  G2oGraph finish();

 private:
  using Mentions = std::unordered_map<std::int64_t, Mention>;

  void read_vertex(G2oLine& line);
  void read_edge(G2oLine& line, const EdgeWords& words);
  void read_fix(G2oLine& line);
  void read_switch(G2oLine& line);
  void read_prior(G2oLine& line);
  Mention& vertex(std::int64_t id);
  Mention& switch_variable(std::int64_t id);
  void check_mentions() const;
  void hold_gauge();

  const std::string& file_;
  std::size_t line_number_ = 0;
  G2oGraph result_;
  Mentions vertices_;
  Mentions switches_;
  std::vector<bool> used_by_edge_;  ///< of vertices: FIX alone makes no vertex
  std::vector<bool> has_prior_;     ///< of switches
};

void Reader::read_line(const std::string& text) {
  ++line_number_;
  G2oLine line(text, file_, line_number_);
  const std::string_view tag = line.word();
  if (tag.empty()) return;
  if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
    read_vertex(line);
  } else if (tag == "EDGE_SE2") {
    read_edge(line, {false, kByRows});
  } else if (tag == "EDGE2") {
    read_edge(line, {false, kAsInToro});
  } else if (tag == "FIX") {
    read_fix(line);
  } else if (tag == "VERTEX_SWITCH") {
    read_switch(line);
  } else if (tag == "EDGE_SE2_SWITCHABLE") {
    read_edge(line, {true, kByRows});
  } else if (tag == "EDGE_SWITCH_PRIOR") {
    read_prior(line);
  } else {
    throw line.error(
        "unknown tag " + shown(tag),
        "only planar pose graphs (VERTEX_SE2, EDGE_SE2, FIX, switches; VERTEX2, EDGE2) are read");
  }
  line.finish();
}

Mention& Reader::vertex(std::int64_t id) {
  const auto [entry, is_new] = vertices_.try_emplace(id);
  if (is_new) {
    entry->second = {static_cast<std::uint32_t>(result_.graph.vertices.size()), line_number_, false};
    result_.graph.vertices.emplace_back();
    result_.vertex_ids.push_back(id);
    used_by_edge_.push_back(false);
  }
  return entry->second;
}

Mention& Reader::switch_variable(std::int64_t id) {
  const auto [entry, is_new] = switches_.try_emplace(id);
  if (is_new) {
    entry->second = {static_cast<std::uint32_t>(result_.graph.switches.size()), line_number_, false};
    result_.graph.switches.emplace_back();
    result_.switch_ids.push_back(id);
    has_prior_.push_back(false);
  }
  return entry->second;
}

void Reader::read_vertex(G2oLine& line) {
  const std::int64_t id = line.id();
  Mention& mention = vertex(id);
  if (mention.given) throw line.error("vertex " + std::to_string(id) + " is given twice");
  mention.given = true;
  Pose2& pose = result_.graph.vertices[mention.index].pose;
  pose.x = line.number();
  pose.y = line.number();
  pose.heading = wrap_angle(line.number());
}

void Reader::read_edge(G2oLine& line, const EdgeWords& words) {
  Edge edge;
  const std::int64_t from = line.id();
  const std::int64_t to = line.id();
  if (from == to) throw line.error("the edge leads from vertex " + std::to_string(from) + " to itself");
  edge.from = vertex(from).index;
  edge.to = vertex(to).index;
  used_by_edge_[edge.from] = used_by_edge_[edge.to] = true;
  if (words.switched) edge.switch_index = switch_variable(line.id()).index;
  edge.measurement.x = line.number();
  edge.measurement.y = line.number();
  edge.measurement.heading = wrap_angle(line.number());
  for (const auto& [r, c] : words.information)
    edge.information(r, c) = edge.information(c, r) = line.number();
  if (!is_positive_semidefinite(edge.information)) {
    throw line.error("the information matrix is not positive semi-definite");
  }
  result_.graph.edges.push_back(edge);
}

void Reader::read_fix(G2oLine& line) {
  do {
    result_.graph.vertices[vertex(line.id()).index].fixed = true;
  } while (!line.at_end());
}

void Reader::read_switch(G2oLine& line) {
  const std::int64_t id = line.id();
  Mention& mention = switch_variable(id);
  if (mention.given) throw line.error("switch " + std::to_string(id) + " is given twice");
  mention.given = true;
  double& value = result_.graph.switches[mention.index].value;
  value = line.number();
  if (value < 0 || value > 1) throw line.error("a switch stands between 0 and 1");
}

void Reader::read_prior(G2oLine& line) {
  const std::int64_t id = line.id();
  const std::uint32_t index = switch_variable(id).index;
  if (has_prior_[index]) throw line.error("the prior of switch " + std::to_string(id) + " is given twice");
  has_prior_[index] = true;
  if (line.number() != 1) throw line.error("the prior of a switch is 1: on");
  result_.graph.switches[index].prior = line.number();
  if (result_.graph.switches[index].prior <= 0)
    throw line.error("the information of a switch's prior must be positive");
}

void Reader::check_mentions() const {
  const auto refuse = [&](const Mention& mention, const std::string& problem) {
    throw input_error(file_ + ":" + std::to_string(mention.line), problem);
  };
  for (std::size_t v = 0; v < result_.vertex_ids.size(); ++v) {
    const Mention& mention = vertices_.at(result_.vertex_ids[v]);
    if (!mention.given && !used_by_edge_[v]) {
      refuse(mention, "there is no vertex " + std::to_string(result_.vertex_ids[v]));
    }
  }
  for (std::size_t k = 0; k < result_.switch_ids.size(); ++k) {
    const std::int64_t id = result_.switch_ids[k];
    const Mention& mention = switches_.at(id);
    if (!mention.given) refuse(mention, "there is no VERTEX_SWITCH " + std::to_string(id));
    if (!has_prior_[k]) refuse(mention, "switch " + std::to_string(id) + " has no EDGE_SWITCH_PRIOR");
    if (vertices_.contains(id)) refuse(mention, "id " + std::to_string(id) + " names a vertex and a switch");
  }
}

void Reader::hold_gauge() {
  auto& vertices = result_.graph.vertices;
  for (const Vertex& v : vertices) {
    if (v.fixed) return;
  }
  const auto lowest = std::min_element(result_.vertex_ids.begin(), result_.vertex_ids.end());
  vertices[static_cast<std::size_t>(lowest - result_.vertex_ids.begin())].fixed = true;
}

G2oGraph Reader::finish() {
  if (result_.graph.vertices.empty()) throw input_error(file_, "there is no graph in it");
  check_mentions();
  hold_gauge();
  std::vector<bool> placed;
  for (const std::int64_t id : result_.vertex_ids) placed.push_back(vertices_.at(id).given);
  if (const auto lost = place_along_edges(result_.graph, result_.vertex_ids, placed)) {
    const std::int64_t id = result_.vertex_ids[*lost];
    throw input_error(file_ + ":" + std::to_string(vertices_.at(id).line),
                      "vertex " + std::to_string(id) + " has no place",
                      "give it a VERTEX_SE2 line, or edges that lead to it");
  }
  tell_landmarks(result_.graph);
  return std::move(result_);
}

}  // namespace

G2oGraph read_g2o(std::istream& text, const std::string& name) {
  Reader reader(name);
  for (std::string line; std::getline(text, line);) reader.read_line(line);
  if (text.bad()) throw input_error(name, "cannot be read to its end");
  return reader.finish();
}

G2oGraph read_g2o(const std::filesystem::path& file) {
  std::ifstream text(file, std::ios::binary);
  if (!text || std::filesystem::is_directory(file)) throw input_error(file.string(), "cannot be opened");
  return read_g2o(text, file.string());
}

}  // namespace lanefuse
