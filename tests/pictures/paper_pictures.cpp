// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "drawing/svg.hpp"
#include "pictures/paper_views.hpp"

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

/// paper_pictures FOLDER draws the pictures; paper_pictures --check FOLDER fails where a file there is
/// another.
int main(int argc, char** argv) {
  const bool check = argc == 3 && std::strcmp(argv[1], "--check") == 0;
  if (argc != 2 && !check) {
    fmt::print(stderr, "usage: paper_pictures [--check] FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  int different = 0;
  for (const lanefuse::NamedView& picture : lanefuse::paper_views()) {
    const std::string svg = lanefuse::standalone_svg(lanefuse::draw_graph(picture.view));
    if (!check) {
      std::ofstream(folder / picture.name, std::ios::binary) << svg;
    } else if (text_of(folder / picture.name) != svg) {
      fmt::print(stderr, "{} is not what is drawn now\n", picture.name);
      ++different;
    }
  }
  return different == 0 ? 0 : 1;
}
