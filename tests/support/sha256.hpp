// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace lanefuse::testing {

/// SHA-256 (FIPS 180-4), for comparing files with published sums. Small and slow.
class Sha256 {
 public:
  static std::string hex(std::span<const std::byte> bytes) {
    Sha256 sum;
    for (std::size_t i = 0; const auto block : padded(bytes)) {
      sum.block_[i++ % 64] = block;
      if (i % 64 == 0) {
        sum.add_block();
      }
    }
    std::string text;
    for (const std::uint32_t word : sum.state_) {
      text += fmt::format("{:08x}", word);
    }
    return text;
  }

 private:
  // The first bits behind the point of the roots of the first primes.
  static std::uint32_t root_bits(int prime, bool cube) {
    const long double root =
        cube ? std::cbrt(static_cast<long double>(prime)) : std::sqrt(static_cast<long double>(prime));
    return static_cast<std::uint32_t>((root - std::floor(root)) * 4294967296.0L);
  }

  static std::vector<int> primes(std::size_t count) {
    std::vector<int> found;
    for (int candidate = 2; found.size() < count; ++candidate) {
      bool prime = true;
      for (const int p : found) {
        prime = prime && candidate % p != 0;
      }
      if (prime) {
        found.push_back(candidate);
      }
    }
    return found;
  }

  Sha256() {
    const std::vector<int> list = primes(64);
    for (std::size_t i = 0; i < 64; ++i) {
      constants_[i] = root_bits(list[i], true);
    }
    for (std::size_t i = 0; i < 8; ++i) {
      state_[i] = root_bits(list[i], false);
    }
  }

  static std::vector<std::byte> padded(std::span<const std::byte> bytes) {
    std::vector<std::byte> all(bytes.begin(), bytes.end());
    all.push_back(std::byte{0x80});
    all.resize((all.size() + 8 + 63) / 64 * 64 - 8);
    for (int shift = 56; shift >= 0; shift -= 8) {
      all.push_back(static_cast<std::byte>((bytes.size() * 8) >> shift));
    }
    return all;
  }

  void add_block() {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) {
      w[i / 4] |= std::to_integer<std::uint32_t>(block_[i]) << (24 - 8 * (i % 4));
    }
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t a = w[i - 15];
      const std::uint32_t b = w[i - 2];
      w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[i - 7] +
             (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
    }
    auto s = state_;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
      const std::uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
      const std::uint32_t one = s[7] + (std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25)) +
                                choice + constants_[i] + w[i];
      const std::uint32_t two = (std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22)) + majority;
      s = {one + two, s[0], s[1], s[2], s[3] + one, s[4], s[5], s[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) {
      state_[i] += s[i];
    }
  }

  std::array<std::uint32_t, 64> constants_{};
  std::array<std::uint32_t, 8> state_{};
  std::array<std::byte, 64> block_{};
};

}  // namespace lanefuse::testing
