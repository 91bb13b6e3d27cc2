// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lanefuse {

/// How a driver keeps speed and distance: the Intelligent Driver Model (Treiber, Hennecke, Helbing 2000).
struct CarFollowing {
  double wished_speed = 30;        ///< [m/s]
  double acceleration = 2;         ///< [m/s^2] at most
  double comfortable_braking = 2;  ///< [m/s^2]
  double headway = 1.2;            ///< [s]
  double standstill_gap = 3;       ///< [m]

  /// The acceleration [m/s^2] on a free road; who is too fast slows down in comfort.
  [[nodiscard]] double free(double speed) const;
  /// The acceleration [m/s^2] behind a leader: `gap` [m] from bumper to bumper.
  [[nodiscard]] double behind(double speed, double gap, double leader_speed) const;
};

}  // namespace lanefuse
