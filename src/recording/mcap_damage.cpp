// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_damage.hpp"

#include <fmt/format.h>

namespace lanefuse::mcap {

void Damage::note(std::uint64_t byte, const std::string& what) {
  if (!any || byte < first_byte) {
    first_byte = byte;
    first_place = fmt::format("byte {}: {}", byte, what);
  }
  any = true;
}

}  // namespace lanefuse::mcap
