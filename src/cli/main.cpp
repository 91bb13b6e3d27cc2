// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <new>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "core/error.hpp"

int main(int argc, char** argv) {
  try {
    return lanefuse::parse_arguments(argc, argv)();
  } catch (const lanefuse::Error& error) {
    fmt::print(stderr, "lanefuse: {}\n", error.what());
    return error.kind() == lanefuse::Error::Kind::configuration ? 2 : 3;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "lanefuse: out of memory\n");
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lanefuse: internal error: {}\n", error.what());
    return 1;
  }
}
