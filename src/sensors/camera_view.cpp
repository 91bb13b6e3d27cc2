// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/camera_view.hpp"

namespace lanefuse {

const char* to_string(ImageFault fault) {
  switch (fault) {
    case ImageFault::none:
      return "none";
    case ImageFault::empty:
      return "empty";
    case ImageFault::corrupt:
      return "corrupt";
    case ImageFault::wrong_size:
      return "wrong_size";
    case ImageFault::too_dark:
      return "too_dark";
    case ImageFault::overexposed:
      return "overexposed";
    case ImageFault::incomplete:
      return "incomplete";
    case ImageFault::frozen:
      return "frozen";
  }
  return "unknown";
}

const char* to_string(CalibrationStatus status) {
  switch (status) {
    case CalibrationStatus::learning:
      return "learning";
    case CalibrationStatus::steady:
      return "steady";
    case CalibrationStatus::bumped:
      return "bumped";
  }
  return "unknown";
}

}  // namespace lanefuse
