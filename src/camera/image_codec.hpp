// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "camera/image.hpp"

namespace lanefuse {

inline constexpr std::int64_t kMaxPixels = 64'000'000;  ///< of an image; what claims more is not decoded

/// The image (blue, green, red) in the bytes of a JPEG, PNG or WebP file; nothing where they hold none, or
/// one that is larger than kMaxPixels. Parts that are missing from a file cut short are grey.
std::optional<Image> decode_image(std::span<const std::byte> bytes);

/// JPEG; `quality` in [1, 100]. The same image gives the same bytes.
std::vector<std::byte> encode_jpeg(const ImageView& image, int quality);

}  // namespace lanefuse
