// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace lanefuse::mcap {

/// A file that appears at `path` only when it is finished: it is written to `path` + ".part" and renamed by
/// place(). What is no regular file (a device, a pipe) is written in place. Every failure throws Error
/// (input, naming the file).
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();  ///< removes the .part file unless place() was called
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Hands all of `bytes` to the operating system: a killed program loses nothing that was written.
  void write(std::span<const std::byte> bytes);

  /// Makes what was written durable and puts it in its place.
  void place();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }  ///< of all that was written
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  std::filesystem::path written_path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
  bool placed_ = false;
};

}  // namespace lanefuse::mcap
