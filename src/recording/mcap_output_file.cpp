// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_output_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include "core/error.hpp"
#include "recording/mcap_crc32.hpp"

namespace lanefuse::mcap {
namespace {

namespace fs = std::filesystem;

bool is_written_in_place(const fs::path& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

OutputFile::OutputFile(const fs::path& path)
    : path_(path), written_path_(is_written_in_place(path) ? path : fs::path(path.string() + ".part")) {
  descriptor_ = ::open(written_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    fail(errno);
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!placed_ && written_path_ != path_) {
    std::error_code ignored;  // a destructor has nobody to tell, and the file's own path was never touched
    fs::remove(written_path_, ignored);
  }
}

void OutputFile::write(std::span<const std::byte> bytes) {
  crc_ = crc32(bytes, crc_);
  size_ += bytes.size();
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      fail(errno);
    }
    bytes = bytes.subspan(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

void OutputFile::place() {
  // EINVAL, EROFS: a device that has nothing to make durable.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
    fail(errno);
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) {
    fail(errno);
  }
  if (written_path_ != path_ && ::rename(written_path_.c_str(), path_.c_str()) != 0) {
    fail(errno);
  }
  placed_ = true;
}

void OutputFile::fail(int error) const {
  throw input_error(path_.string(), "cannot be written: " + std::generic_category().message(error),
                    error == ENOSPC ? "make room on the disk and start again" : "");
}

}  // namespace lanefuse::mcap
