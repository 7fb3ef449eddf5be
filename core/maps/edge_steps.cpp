// SPDX-License-Identifier: Apache-2.0
#include "core/maps/edge_steps.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace etak {
namespace {

using Row = std::vector<std::uint8_t>;  // RGBA

std::uint64_t step(const std::uint8_t* a, const std::uint8_t* b) {
  std::uint64_t out = 0;
  for (int c = 0; c < 3; ++c) out += static_cast<std::uint64_t>(std::abs(a[c] - b[c]));
  return out;
}

std::uint64_t step_of_rows(const Row& a, const Row& b) {
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) out += step(&a[i], &b[i]);
  return out;
}

}  // namespace

EdgeSteps edge_steps(RowSource& rows) {
  const auto width = static_cast<std::size_t>(rows.header().width);
  const int height = rows.header().height;
  Row first(4 * width), before, row(4 * width);
  std::vector<std::uint64_t> columns(width, 0);  // from this one to the next, which of the last is the first
  std::uint64_t most_of_rows = 0;
  for (int y = 0; y < height; ++y) {
    rows.read_rows(row.data(), row.size(), 1);
    for (std::size_t x = 0; x < width; ++x) columns[x] += step(&row[4 * x], &row[4 * ((x + 1) % width)]);
    if (y == 0)
      first = row;
    else
      most_of_rows = std::max(most_of_rows, step_of_rows(before, row));
    before = row;
  }
  const auto mean = [](std::uint64_t sum, double texels) { return static_cast<double>(sum) / (3 * texels); };
  EdgeSteps out;
  out.across = {mean(columns.back(), height), mean(step_of_rows(before, first), static_cast<double>(width))};
  columns.pop_back();
  if (!columns.empty()) out.inside[0] = mean(*std::max_element(columns.begin(), columns.end()), height);
  out.inside[1] = mean(most_of_rows, static_cast<double>(width));
  return out;
}

}  // namespace etak
