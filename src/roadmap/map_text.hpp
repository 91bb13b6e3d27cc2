// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lanefuse {

/// A map file's bytes. Throws where it cannot be read, is empty, or is longer than a record may be (64 MiB).
std::string read_map_text(const std::filesystem::path& path);

/// Text for an XML attribute in double quotes: what has a meaning in XML is escaped, control characters are
/// blanks.
std::string xml_escaped(const std::string& text);

}  // namespace lanefuse
