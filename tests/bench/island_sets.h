// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/atlas/plan.h"

namespace etak::test {

/// The islands of a set of tests/bench/islands, which make_islands.py writes, as regions of one picture. Throws
/// std::runtime_error for another text.
inline std::vector<Region> read_islands(std::istream& text) {
  std::vector<Region> out;
  std::string line, word;
  while (std::getline(text, line)) {
    std::istringstream head(line);
    int width = 0, height = 0;
    if (!(head >> word >> width >> height) || word != "island" || width < 1 || height < 1)
      throw std::runtime_error("'" + line + "'; expected island WIDTH HEIGHT");
    Region region{0, {0, 0, width, height}};
    for (int row = 0; row < height && std::getline(text, line); ++row) {
      std::istringstream runs(line);
      for (int begin = 0, end = 0; runs >> begin >> end;) region.texels.push_back({row, begin, end});
    }
    out.push_back(std::move(region));
  }
  return out;
}

}  // namespace etak::test
