// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_compression.hpp"

#include <cassert>
#include <memory>
#include <stdexcept>

#include <lz4frame.h>
#include <zstd.h>

#include "recording/mcap_cursor.hpp"

namespace lanefuse::mcap {
namespace {

constexpr int kZstdLevel = 3;

Bytes compress_lz4(std::span<const std::byte> bytes) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = bytes.size();
  Bytes packed(LZ4F_compressFrameBound(bytes.size(), &preferences));
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
  assert(!LZ4F_isError(size));
  packed.resize(size);
  return packed;
}

Bytes compress_zstd(std::span<const std::byte> bytes) {
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  assert(!ZSTD_isError(size));
  packed.resize(size);
  return packed;
}

bool decompress_lz4(std::span<const std::byte> packed, Bytes& bytes) {
  LZ4F_dctx* raw_context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw_context, LZ4F_VERSION))) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw_context, &LZ4F_freeDecompressionContext);
  std::size_t written = 0;
  while (!packed.empty()) {
    std::size_t produced = bytes.size() - written;
    std::size_t consumed = packed.size();
    const std::size_t hint =
        LZ4F_decompress(context.get(), bytes.data() + written, &produced, packed.data(), &consumed, nullptr);
    // No progress: there is more in the frame than was announced.
    if (LZ4F_isError(hint) || (produced == 0 && consumed == 0)) {
      return false;
    }
    written += produced;
    packed = packed.subspan(consumed);
  }
  return written == bytes.size();
}

bool decompress_zstd(std::span<const std::byte> packed, Bytes& bytes) {
  return ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size()) == bytes.size();
}

}  // namespace

std::string to_string(Compression compression) {
  switch (compression) {
    case Compression::none:
      return "";
    case Compression::lz4:
      return "lz4";
    case Compression::zstd:
      return "zstd";
  }
  return "";
}

Bytes compress(Compression compression, std::span<const std::byte> bytes) {
  switch (compression) {
    case Compression::none:
      return to_bytes(bytes);
    case Compression::lz4:
      return compress_lz4(bytes);
    case Compression::zstd:
      return compress_zstd(bytes);
  }
  return {};
}

std::optional<Bytes> decompress(const std::string& compression, std::span<const std::byte> packed,
                                std::uint64_t size) {
  if (compression.empty()) {
    return packed.size() == size ? std::optional(to_bytes(packed)) : std::nullopt;
  }
  const bool is_lz4 = compression == "lz4";
  if (!is_lz4 && compression != "zstd") {
    return std::nullopt;
  }
  Bytes bytes(size);
  const bool sound = is_lz4 ? decompress_lz4(packed, bytes) : decompress_zstd(packed, bytes);
  return sound ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace lanefuse::mcap
