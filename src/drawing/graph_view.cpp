// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/graph_view.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "drawing/axes.hpp"
#include "drawing/legend.hpp"

namespace lanefuse {
namespace {

constexpr double kWidth = 900;
constexpr double kPlotHeight = 300;
constexpr double kLeft = 46;
constexpr double kTitleLeft = 4;
constexpr double kInner = kWidth - kLeft - 18;
constexpr double kHeadingTick = 15;  // [px]

constexpr std::array kNodeColours{"vehicle", "boundary", "series-0", "series-1", "series-3", "series-2"};
constexpr std::array kNodeMarkers{Marker::square,  Marker::circle, Marker::triangle,
                                  Marker::diamond, Marker::circle, Marker::cross};
constexpr std::array kEdgeColours{"series-3", "series-0", "series-5", "series-2", "boundary", "series-1"};

/// The distinct kinds in the order in which they first appear.
template <typename Things>
std::vector<std::string> kinds_of(const Things& things) {
  std::vector<std::string> kinds;
  for (const auto& thing : things) {
    if (std::find(kinds.begin(), kinds.end(), thing.kind) == kinds.end()) kinds.push_back(thing.kind);
  }
  return kinds;
}

std::size_t index_of(const std::vector<std::string>& kinds, const std::string& kind) {
  return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

std::string edge_css(std::size_t kind) {
  return fmt::format("pen-{} medium", kEdgeColours[kind % kEdgeColours.size()]);
}
constexpr const char* kOffCss = "pen-truth thick dashed";

const char* node_colour(std::size_t kind) { return kNodeColours[kind % kNodeColours.size()]; }
Marker node_marker(std::size_t kind) { return kNodeMarkers[kind % kNodeMarkers.size()]; }

/// An axis that holds all values with some air around them.
Axis axis_around(std::string label, const std::vector<double>& values, int most_ticks) {
  double from = 0, to = 1;
  if (!values.empty()) {
    from = *std::min_element(values.begin(), values.end());
    to = *std::max_element(values.begin(), values.end());
  }
  const double air = std::max(0.5, 0.08 * (to - from));
  return {std::move(label), from - air, to + air, nice_step(to - from + 2 * air, most_ticks)};
}

Axes axes_around(const std::vector<GraphNode>& nodes, double top) {
  std::vector<double> xs, ys;
  for (const GraphNode& node : nodes) {
    if (!std::isfinite(node.x) || !std::isfinite(node.y)) continue;
    xs.push_back(node.x);
    ys.push_back(node.y);
  }
  return {{kLeft, top, kInner, kPlotHeight}, axis_around("x [m]", xs, 14), axis_around("y [m]", ys, 8)};
}

std::vector<LegendEntry> legend_of(const GraphView& view) {
  std::vector<LegendEntry> entries;
  const auto node_kinds = kinds_of(view.nodes);
  for (std::size_t i = 0; i < node_kinds.size(); ++i)
    entries.push_back({node_kinds[i], "", node_marker(i), node_colour(i)});
  const auto edge_kinds = kinds_of(view.edges);
  for (std::size_t i = 0; i < edge_kinds.size(); ++i)
    entries.push_back({edge_kinds[i], edge_css(i), std::nullopt, ""});
  const bool any_off =
      std::any_of(view.edges.begin(), view.edges.end(), [](const GraphEdge& edge) { return edge.off; });
  if (any_off) entries.push_back({"switched off", kOffCss, std::nullopt, ""});
  return entries;
}

void draw_edges(SvgWriter& svg, const Axes& axes, const GraphView& view) {
  const auto kinds = kinds_of(view.edges);
  for (const GraphEdge& edge : view.edges) {
    assert(edge.from < view.nodes.size() && edge.to < view.nodes.size());
    const GraphNode& from = view.nodes[edge.from];
    const GraphNode& to = view.nodes[edge.to];
    svg.line(axes.at(from.x, from.y), axes.at(to.x, to.y),
             edge.off ? kOffCss : edge_css(index_of(kinds, edge.kind)));
  }
}

void draw_nodes(SvgWriter& svg, const Axes& axes, const std::vector<GraphNode>& nodes) {
  const auto kinds = kinds_of(nodes);
  for (const GraphNode& node : nodes) {
    const std::size_t kind = index_of(kinds, node.kind);
    const Pixel at = axes.at(node.x, node.y);
    if (node.heading) {
      // Turned as the stretched axes turn it, so that it runs along a line that has this heading.
      const Pixel along = axes.at(node.x + std::cos(*node.heading), node.y + std::sin(*node.heading)) - at;
      svg.line(at, at + kHeadingTick * along.normalized(), fmt::format("pen-{} medium", node_colour(kind)));
    }
    draw_marker(svg, node_marker(kind), at, 4.5, node_colour(kind));
    const Pixel label_at = at + Pixel(0, node.label_above ? -10 : 18);
    if (!node.label.empty()) svg.text(label_at, node.label, "tick ink-text", Anchor::middle);
  }
}

}  // namespace

Figure draw_graph(const GraphView& view) {
  const std::vector<LegendEntry> legend = legend_of(view);
  const double top = 34 + legend_height(kInner, legend) + 22;
  const Axes axes = axes_around(view.nodes, top);
  SvgWriter svg;
  svg.text({kTitleLeft, 20}, view.title, "heading ink-text");
  draw_legend(svg, {kTitleLeft, 42}, kInner, legend);
  axes.draw(svg);
  if (view.nodes.empty()) {
    svg.text({kLeft + kInner / 2, top + kPlotHeight / 2}, "no data", "heading ink-muted", Anchor::middle);
  }
  draw_edges(svg, axes, view);
  draw_nodes(svg, axes, view.nodes);
  return {kWidth, top + kPlotHeight + 44, "graph: " + view.title, svg.elements()};
}

}  // namespace lanefuse
