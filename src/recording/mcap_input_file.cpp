// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_input_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/mcap_crc32.hpp"
#include "recording/mcap_cursor.hpp"

namespace lanefuse::mcap {
namespace {

Error read_error(const std::filesystem::path& path, int error) {
  return input_error(path.string(), "cannot be read: " + std::generic_category().message(error));
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
    throw read_error(path, errno);
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw input_error(path.string(), "is not a regular file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read_into(std::uint64_t offset, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto at = static_cast<off_t>(offset + done);
    const ssize_t got = ::pread(descriptor_, bytes.data() + done, bytes.size() - done, at);
    if (got < 0 && errno != EINTR) {
      throw read_error(path_, errno);
    }
    if (got == 0) {
      break;
    }
    done += got < 0 ? 0 : static_cast<std::size_t>(got);
  }
  return done;
}

Bytes InputFile::read(std::uint64_t offset, std::uint64_t length) const {
  const std::uint64_t left = offset < size_ ? size_ - offset : 0;
  Bytes bytes(std::min(length, left));
  bytes.resize(read_into(offset, bytes));
  return bytes;
}

std::optional<RecordHead> InputFile::record_head(std::uint64_t offset) const {
  std::array<std::byte, kRecordHeadSize> bytes{};
  if (read_into(offset, bytes) != bytes.size()) {
    return std::nullopt;
  }
  Cursor in(bytes);
  const auto opcode = in.integer<std::uint8_t>();
  const auto length = in.integer<std::uint64_t>();
  const bool fits = opcode != 0 && length <= size_ - offset - kRecordHeadSize;
  return fits ? std::optional(RecordHead{static_cast<Opcode>(opcode), offset, length}) : std::nullopt;
}

Bytes InputFile::content(const RecordHead& head, std::uint64_t limit) const {
  return read(head.content(), std::min(head.size, limit));
}

std::uint32_t InputFile::crc(std::uint64_t begin, std::uint64_t end) const {
  constexpr std::uint64_t kPiece = 1 << 18;
  std::uint32_t crc = 0;
  while (begin < end) {
    const Bytes piece = read(begin, std::min(kPiece, end - begin));
    if (piece.empty()) {
      break;
    }
    crc = crc32(piece, crc);
    begin += piece.size();
  }
  return crc;
}

void InputFile::check_magic() const {
  const Bytes begin = read(0, kMagic.size());
  const bool named = begin.size() == kMagic.size() &&
                     std::equal(begin.begin(), begin.begin() + kVersionByte, kMagic.begin());
  if (!named) {
    throw input_error(path_.string() + ", byte 0", "this is not an MCAP file");
  }
  if (begin[kVersionByte] != kMagic[kVersionByte]) {
    throw input_error(
        fmt::format("{}, byte {}", path_.string(), kVersionByte),
        fmt::format("the MCAP major version 0x{:02x} is not known; this program reads version '0'",
                    std::to_integer<unsigned>(begin[kVersionByte])));
  }
  if (!std::equal(begin.begin(), begin.end(), kMagic.begin())) {
    throw input_error(path_.string() + ", byte 6", "the line end of the MCAP magic was altered",
                      "copy the file again, as binary");
  }
}

}  // namespace lanefuse::mcap
