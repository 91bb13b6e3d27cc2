// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/calibration_images.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {

void demand_any(const std::vector<Refusal>& refused, std::size_t found) {
  if (found > 0 || refused.empty()) return;
  const std::string others =
      refused.size() > 1 ? fmt::format("; nor can the other {} images be used", refused.size() - 1) : "";
  throw input_error(refused.front().image, fmt::format("{}{}", refused.front().reason, others));
}

nlohmann::ordered_json to_json(const std::vector<Refusal>& refused) {
  auto list = nlohmann::ordered_json::array();
  for (const Refusal& refusal : refused)
    list.push_back({{"image", refusal.image}, {"reason", refusal.reason}});
  return list;
}

std::string to_text(const std::vector<Refusal>& refused) {
  std::string text;
  for (const Refusal& refusal : refused)
    text += fmt::format("not used: {}: {}\n", refusal.image, refusal.reason);
  return text;
}

}  // namespace lanefuse
