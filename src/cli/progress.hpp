// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lanefuse {

/// A line on standard error that tells how far a long command is; silent where nobody looks (no terminal).
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// With a bar, `fraction` in [0, 1], and a note behind it.
  void show(double fraction, const std::string& note = {});
  /// Where the end is not known: seconds of the drive so far.
  void show_seconds(double seconds);

 private:
  void draw(const std::string& text);

  std::string what_;
  bool visible_;
  std::string drawn_;
};

}  // namespace lanefuse
