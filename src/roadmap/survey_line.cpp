// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_line.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanefuse {
namespace {

constexpr double kSameLine = 0.9;           ///< [m] apart on the mean: both edges of any paint, but no lane
constexpr std::size_t kLeastCommon = 10;    ///< stations
constexpr std::size_t kLeastForWidth = 25;  ///< stations that were seen from both sides
constexpr double kInlier = 0.06;            ///< [m] from the median of the drives
constexpr int kRounds = 8;                  ///< of placing lines and drives in turn

/// Sets of traces that are joined one by one.
class Partition {
 public:
  explicit Partition(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0u); }
  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (parents_[i] != i) i = parents_[i];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[root(std::max(a, b))] = root(std::min(a, b)); }

 private:
  std::vector<std::size_t> parents_;
};

/// Where the traces of one side place the line, on the mean, without any drive's error.
StationSeries seen_from(Side side, const SurveyLine& line, std::span<const SurveyTrace> traces) {
  StationSeries sums(traces.front().lateral.size(), 0);
  std::vector<int> counts(sums.size(), 0);
  for (const std::size_t index : line.traces) {
    const SurveyTrace& trace = traces[index];
    if (trace.side != side || trace.paint_width > 0) continue;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (!is_known(trace.lateral[i])) continue;
      sums[i] += trace.lateral[i];
      ++counts[i];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : kUnknown;
  return sums;
}

MarkingVotes all_votes(const SurveyLine& line, std::span<const SurveyTrace> traces) {
  MarkingVotes votes;
  for (const std::size_t index : line.traces) {
    for (const MarkingVotes& station : traces[index].votes) votes += station;
  }
  return votes;
}

/// As the camera measured it, else from the edges that the lanes on both sides see, else by the type.
double paint_width(const SurveyLine& line, std::span<const SurveyTrace> traces, const SurveyConfig& config) {
  for (const std::size_t index : line.traces) {
    if (traces[index].paint_width > 0) return traces[index].paint_width;
  }
  // The lane to the left has the line on its right, and sees the paint's left edge.
  const MeanDifference width =
      mean_difference(seen_from(Side::right, line, traces), seen_from(Side::left, line, traces));
  if (width.count >= kLeastForWidth) return std::clamp(width.mean, 0.0, 0.6);
  const bool dashed = all_votes(line, traces).winner().type == MarkingType::dashed;
  return dashed ? config.lane_line_width : config.edge_line_width;
}

/// Where a trace says that the middle of the line's paint is.
double middle(const SurveyTrace& trace, const SurveyLine& line, std::size_t station) {
  if (trace.paint_width > 0) return trace.lateral[station];
  return trace.lateral[station] + (trace.side == Side::left ? 0.5 : -0.5) * line.paint_width;
}

bool is_left_of(const StationSeries& a, const StationSeries& b) {
  const MeanDifference difference = mean_difference(a, b);
  return difference.count > 0 ? difference.mean > 0 : mean_of(a) > mean_of(b);
}

/// A rough place of the line, for telling left from right.
StationSeries rough(const SurveyLine& line, std::span<const SurveyTrace> traces) {
  StationSeries place = seen_from(Side::left, line, traces);
  const StationSeries other = seen_from(Side::right, line, traces);
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!is_known(place[i])) place[i] = other[i];
  }
  for (const std::size_t index : line.traces) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (!is_known(place[i])) place[i] = traces[index].lateral[i];
    }
  }
  return place;
}

/// Finds, in turn, where the lines are and how far each drive is off.
class Merging {
 public:
  Merging(std::span<const SurveyTrace> traces, std::size_t drives, std::vector<SurveyLine>& lines)
      : traces_(traces),
        lines_(lines),
        stations_(traces.front().lateral.size()),
        drifts_(drives, StationSeries(stations_, 0)) {}

  void place_lines() {
    std::vector<double> values;
    for (SurveyLine& line : lines_) {
      line.lateral.assign(stations_, kUnknown);
      for (std::size_t i = 0; i < stations_; ++i) {
        values.clear();
        for (const std::size_t index : line.traces) {
          const SurveyTrace& trace = traces_[index];
          if (is_known(trace.lateral[i])) values.push_back(middle(trace, line, i) - drifts_[trace.drive][i]);
        }
        line.lateral[i] = robust_mean(values, kInlier);
      }
    }
  }

  /// `belief` in [0, 1]: how much of what a drive is off is its own error.
  void place_drives(std::size_t reach, double belief) {
    for (std::size_t drive = 0; drive < drifts_.size(); ++drive) {
      StationSeries off = box_mean(how_far_off(drive), reach);
      for (double& value : off) value = is_known(value) ? belief * value : 0;
      drifts_[drive] = std::move(off);
    }
  }

 private:
  std::span<const SurveyTrace> traces_;
  std::vector<SurveyLine>& lines_;
  std::size_t stations_;
  std::vector<StationSeries> drifts_;  ///< [m] a drive, its error to the left

  [[nodiscard]] StationSeries how_far_off(std::size_t drive) const {
    StationSeries sums(stations_, 0);
    std::vector<int> counts(stations_, 0);
    for (const SurveyLine& line : lines_) {
      for (const std::size_t index : line.traces) {
        const SurveyTrace& trace = traces_[index];
        for (std::size_t i = 0; trace.drive == drive && i < stations_; ++i) {
          if (!is_known(trace.lateral[i]) || !is_known(line.lateral[i])) continue;
          sums[i] += middle(trace, line, i) - line.lateral[i];
          ++counts[i];
        }
      }
    }
    for (std::size_t i = 0; i < stations_; ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : kUnknown;
    return sums;
  }
};

}  // namespace

std::vector<SurveyLine> lines_of(std::span<const SurveyTrace> traces, const SurveyConfig& config) {
  Partition partition(traces.size());
  for (std::size_t a = 0; a < traces.size(); ++a) {
    for (std::size_t b = a + 1; b < traces.size(); ++b) {
      const MeanDifference apart = mean_difference(traces[a].lateral, traces[b].lateral);
      if (apart.count >= kLeastCommon && std::abs(apart.mean) < kSameLine) partition.join(a, b);
    }
  }
  std::vector<SurveyLine> lines;
  std::vector<StationSeries> places;
  for (std::size_t root = 0; root < traces.size(); ++root) {
    if (partition.root(root) != root) continue;
    SurveyLine line;
    for (std::size_t i = root; i < traces.size(); ++i) {
      if (partition.root(i) == root) line.traces.push_back(i);
    }
    line.paint_width = paint_width(line, traces, config);
    const StationSeries place = rough(line, traces);
    std::size_t at = 0;
    while (at < places.size() && !is_left_of(place, places[at])) ++at;
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(at), place);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), std::move(line));
  }
  return lines;
}

void merge_lines(std::span<const SurveyTrace> traces, std::size_t drives, double step,
                 const SurveyConfig& config, std::vector<SurveyLine>& lines) {
  if (traces.empty()) return;
  const double drift = config.drift_sigma * config.drift_sigma;
  const double noise = config.marking_sigma * config.marking_sigma;
  Merging merging(traces, drives, lines);
  merging.place_lines();
  for (int round = 0; round < kRounds; ++round) {
    merging.place_drives(static_cast<std::size_t>(config.drift_reach / step), drift / (drift + noise));
    merging.place_lines();
  }
}

std::vector<MarkingEvidence> painted(const SurveyLine& line, std::span<const SurveyTrace> traces,
                                     std::size_t reach) {
  const std::size_t stations = line.lateral.size();
  std::vector<MarkingVotes> votes(stations);
  for (const std::size_t index : line.traces) {
    for (std::size_t i = 0; i < stations; ++i) votes[i] += traces[index].votes[i];
  }
  std::vector<MarkingEvidence> paint(stations);
  for (std::size_t i = 0; i < stations; ++i) {
    MarkingVotes around;
    const std::size_t end = std::min(i + reach + 1, stations);
    for (std::size_t k = i > reach ? i - reach : 0; k < end; ++k) around += votes[k];
    paint[i] = around.winner();
  }
  return paint;
}

}  // namespace lanefuse
