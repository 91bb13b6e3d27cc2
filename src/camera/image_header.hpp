// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace lanefuse {

struct ImageSize {
  std::int64_t width = 0;   ///< [px]
  std::int64_t height = 0;  ///< [px]
  [[nodiscard]] std::int64_t pixels() const { return width * height; }
};

/// What the head of a JPEG, PNG or WebP file says of its size, so that nothing large is allocated on a false
/// word. Nothing for any other bytes.
std::optional<ImageSize> image_size(std::span<const std::byte> bytes);

}  // namespace lanefuse
