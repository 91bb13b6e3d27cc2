// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "camera/image.hpp"
#include "camera/lane_filter.hpp"
#include "camera/paint_bars.hpp"
#include "camera/road_sight.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct EdgeSearchConfig {
  double nearest = 5;               ///< [m]
  double farthest = 95;             ///< [m]
  double spacing = 1.045;           ///< ratio of neighbouring windows' distances
  double gate = 3.2;                ///< [sigma]
  double marking_width_min = 0.08;  ///< [m]
  double marking_width_max = 0.35;  ///< [m]
  double contrast_min = 7;          ///< [grey levels]
};

/// One image to search, and what is known about it.
struct EdgeScene {
  ImageView image;
  const RoadSight* sight = nullptr;
  std::span<const VehicleBox> vehicles;
  /// [m] left, right: shifts far bars' middles to their edge.
  std::array<double, 2> marking_widths = {0.12, 0.12};
  /// Left, right: bars of another colour do not count where there are some of this one.
  std::array<MarkingColour, 2> colours = {MarkingColour::unknown, MarkingColour::unknown};
};

/// A window that was searched, and its bars if any.
struct SearchedWindow {
  Side side = Side::none;
  double distance = 0;  ///< [m]
  double row = 0;       ///< [px]
  double left = 0;      ///< [px]
  double right = 0;     ///< [px]
  double metres_per_pixel = 0;
  bool hidden = false;  ///< by a vehicle
  int first_edge = 0;   ///< its measurements
  int edge_count = 0;
};

/// Whether a vehicle hides this pixel.
bool is_hidden(std::span<const VehicleBox> vehicles, double column, double row);

/// Looks for the inner edges of the ego lane's markings, in windows on image rows that are as wide as the
/// filter's uncertainty.
class EdgeSearch {
 public:
  static constexpr std::size_t kMostWindows = 200;
  static constexpr std::size_t kMostEdges = LaneFilter::kMostEdges;

  explicit EdgeSearch(const EdgeSearchConfig& config) : config_(config) {}

  void search(const EdgeScene& scene, const LaneFilter& filter);

  [[nodiscard]] std::span<const SearchedWindow> windows() const { return {windows_.data(), window_count_}; }
  /// In order of their windows.
  [[nodiscard]] std::span<const EdgeMeasurement> edges() const { return {edges_.data(), edge_count_}; }
  /// The bar of a measurement.
  [[nodiscard]] const PaintBar& bar(std::size_t edge) const { return bars_[edge]; }

 private:
  EdgeSearchConfig config_;
  PaintBarFinder finder_;
  std::array<SearchedWindow, kMostWindows> windows_{};
  std::size_t window_count_ = 0;
  std::array<EdgeMeasurement, kMostEdges> edges_{};
  std::array<PaintBar, kMostEdges> bars_{};
  std::size_t edge_count_ = 0;

  void search_side(const EdgeScene& scene, const LaneFilter& filter, Side side);
  void search_window(const EdgeScene& scene, SearchedWindow window, double slant);
};

}  // namespace lanefuse
