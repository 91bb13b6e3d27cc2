// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_cursor.hpp"

#include <utility>

#include "recording/mcap_format.hpp"

namespace lanefuse::mcap {

std::string Cursor::text() {
  const auto bytes = take(integer<std::uint32_t>());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

StringMap Cursor::text_map() {
  StringMap map;
  pairs([&map](Cursor& inside) {
    std::string key = inside.text();
    map.insert_or_assign(std::move(key), inside.text());
    if (map.size() > kMaxMapEntries) {
      inside.fail();
    }
  });
  return map;
}

}  // namespace lanefuse::mcap
