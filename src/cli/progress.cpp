// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace lanefuse {

Progress::Progress(std::string what) : what_(std::move(what)), visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (!drawn_.empty()) fmt::print(stderr, "\r{:{}}\r", "", drawn_.size());
}

void Progress::show(double fraction, const std::string& note) {
  if (!visible_) return;
  constexpr int kWidth = 40;
  const int full = static_cast<int>(kWidth * std::clamp(fraction, 0.0, 1.0));
  draw(fmt::format("{} [{:=<{}}{:{}}] {:3.0f} %  {}", what_, "", full, "", kWidth - full, 100 * fraction,
                   note));
}

void Progress::show_seconds(double seconds) {
  if (visible_) draw(fmt::format("{} {:.0f} s of the drive", what_, seconds));
}

void Progress::draw(const std::string& text) {
  if (text == drawn_) return;
  fmt::print(stderr, "\r{:{}}", text, drawn_.size());
  std::fflush(stderr);
  drawn_ = text;
}

}  // namespace lanefuse
