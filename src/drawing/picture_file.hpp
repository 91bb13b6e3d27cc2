// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "camera/image.hpp"

namespace lanefuse {

/// Writes a picture as .png or .jpg, whole or not at all. The same picture gives the same bytes. Throws an
/// Error (configuration) for any other ending, and (input) where the file cannot be written.
void write_picture(const std::filesystem::path& path, const ImageView& image);

}  // namespace lanefuse
