// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/files.hpp"

namespace lanefuse::testing {

/// A map file with that text in a folder of its own, gone with this object.
class ScratchMap {
 public:
  ScratchMap(const std::string& name, const std::string& text) : path_(folder_ / name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

/// `text` with its first `from` replaced; the test fails if there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Gives `read` a file of that name with the text cut short and with bytes changed, many times over. It must
/// succeed or throw an input error.
inline void survive_damage(const std::string& name, const std::string& text,
                           const std::function<void(const std::filesystem::path&)>& read) {
  const TemporaryFolder folder;
  const auto try_to_read = [&](const std::string& damaged, const char* how, std::size_t which) {
    write_file(folder / name, std::as_bytes(std::span(damaged)));
    try {
      read(folder / name);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input) << error.what();
    } catch (const std::exception& other) {
      ADD_FAILURE() << how << " " << which << ": " << other.what();
    }
  };
  const std::size_t stride = std::max<std::size_t>(1, text.size() / 300);
  for (std::size_t length = 0; length < text.size(); length += stride) {
    try_to_read(text.substr(0, length), "cut at", length);
  }
  std::mt19937_64 random(20161009);
  for (std::size_t trial = 0; trial < 600; ++trial) {
    std::string damaged = text;
    const std::size_t bytes = 1 + random() % 3;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t at = random() % damaged.size();
      // mostly a digit or a sign, which parses more often than any byte would
      damaged[at] = trial % 2 == 0 ? "0123456789-e."[random() % 13] : static_cast<char>(random());
    }
    try_to_read(damaged, "trial", trial);
  }
}

}  // namespace lanefuse::testing
