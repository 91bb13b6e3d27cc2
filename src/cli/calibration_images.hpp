// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/image_file.hpp"
#include "cli/progress.hpp"

namespace lanefuse {

/// An image that was not used, and why.
struct Refusal {
  std::string image;
  std::string reason;
};

/// What came of every image: things found in some, reasons for the others.
template <typename View>
struct Findings {
  std::vector<View> views;
  std::vector<std::string> names;  ///< of the views' images
  std::vector<Refusal> refused;
};

/// Throws an input Error that names the first image and its reason, where none is left.
void demand_any(const std::vector<Refusal>& refused, std::size_t found);

/// Looks at every image with `find(image, why)`, which gives a view, or nothing and says why not.
template <typename View, typename Find>
Findings<View> look_at(const std::vector<std::filesystem::path>& images, Find find) {
  Findings<View> findings;
  Progress progress("looking");
  std::size_t done = 0;
  for (const std::filesystem::path& file : images) {
    std::string why = "cannot be read as a JPEG, PNG or WebP image";
    const std::optional<Image> image = read_image(file);
    if (const std::optional<View> view = image ? find(*image, why) : std::nullopt) {
      findings.views.push_back(*view);
      findings.names.push_back(file.string());
    } else {
      findings.refused.push_back({file.string(), why});
    }
    progress.show(static_cast<double>(++done) / static_cast<double>(images.size()));
  }
  demand_any(findings.refused, findings.views.size());
  return findings;
}

nlohmann::ordered_json to_json(const std::vector<Refusal>& refused);

/// As lines for people.
std::string to_text(const std::vector<Refusal>& refused);

}  // namespace lanefuse
