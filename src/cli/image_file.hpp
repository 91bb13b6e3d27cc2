// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "camera/image.hpp"

namespace lanefuse {

/// The image in a JPEG, PNG or WebP file; nothing where it cannot be read or holds none.
std::optional<Image> read_image(const std::filesystem::path& file);

}  // namespace lanefuse
