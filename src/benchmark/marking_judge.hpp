// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "benchmark/error_figure.hpp"
#include "benchmark/true_lines.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Marking features of rendered images against what was painted there.
struct MarkingFigures {
  static constexpr int kBins = 7;
  static constexpr double kBinLength = 20;  ///< [m]

  /// Of the markings between two distances from the car.
  struct Bin {
    ErrorFigure lateral_px;  ///< centre of a bar against the line's centre in its row
    ErrorFigure lateral;     ///< [m] of a feature across the true line, with its own covariance there
    ErrorFigure heading;     ///< [rad] of a feature against the line
    Share found;             ///< of the stretches of paint that were visible
    Share believed_falsely;  ///< of the bars believed: those where there is no paint
  };
  std::array<Bin, kBins> bins;

  MarkingFigures& operator+=(const MarkingFigures& other);
};

/// What one image's features add.
void judge_markings(const Scene& scene, const ImageTruth& truth, const CameraIntrinsics& camera,
                    const CameraView& view, std::span<const Feature> features, MarkingFigures& figures);

}  // namespace lanefuse
