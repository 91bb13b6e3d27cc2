// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/ground_view.hpp"

#include "core/pose2.hpp"

namespace lanefuse {

GroundView::GroundView(const CameraPosePreset& preset, Random& random)
    : preset_(preset),
      pitch_(preset.residual_pitch, preset.residual_pitch_tau, random),
      yaw_(preset.yaw_bias, preset.yaw_bias_tau, random) {}

void GroundView::advance(double seconds, Random& random) {
  pitch_.advance(seconds, random);
  yaw_.advance(seconds, random);
}

std::optional<Eigen::Vector2d> GroundView::see(const Eigen::Vector2d& point, double height,
                                               const PixelError& error) const {
  const double dip = (preset_.height - height) / point.x();
  const double believed_dip = dip + pitch_.value() + error.row;
  const double believed_x = preset_.height / believed_dip;
  if (believed_dip <= 0 || believed_x > 4 * point.x()) return {};
  const Eigen::Vector2d believed(believed_x, believed_x * (point.y() / point.x() + error.column));
  return rotation(yaw_.value()) * believed;
}

}  // namespace lanefuse
