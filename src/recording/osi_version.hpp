// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace lanefuse {

/// The version of ASAM OSI whose field numbers and meanings the osi3 messages follow.
inline constexpr std::uint32_t kOsiMajor = 3;
inline constexpr std::uint32_t kOsiMinor = 8;
inline constexpr std::uint32_t kOsiPatch = 0;
inline constexpr char kOsiVersion[] = "3.8.0";

}  // namespace lanefuse
