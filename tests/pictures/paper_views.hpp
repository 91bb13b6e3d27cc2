// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "drawing/graph_view.hpp"

namespace lanefuse {

/// A picture and the name of its file.
struct NamedView {
  std::string name;
  GraphView view;
};

/// Every picture of docs/pictures: the paper's two examples.
std::vector<NamedView> paper_views();

}  // namespace lanefuse
