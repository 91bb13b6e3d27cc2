// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lanefuse {

/// What a NumPy array file says of itself.
struct NpyHeader {
  std::string type;            ///< NumPy's type string: "<f8" is a little-endian 8-byte float
  bool fortran_order = false;  ///< the first index runs fastest
  std::vector<std::size_t> shape;
};

/// Reads the header's dictionary, a Python literal such as {'descr': '<f8', 'fortran_order': False, 'shape':
/// (3, 2), }. Refuses with an Error at `place` whatever is not exactly these three entries.
NpyHeader parse_npy_header(std::string_view text, const std::string& place);

}  // namespace lanefuse
