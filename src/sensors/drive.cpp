// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/drive.hpp"

namespace lanefuse {

const char* to_string(WitnessRule rule) {
  switch (rule) {
    case WitnessRule::radar_and_camera:
      return "radar_and_camera";
    case WitnessRule::radar_only:
      return "radar_only";
  }
  return "unknown";
}

}  // namespace lanefuse
