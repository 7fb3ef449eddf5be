// SPDX-License-Identifier: Apache-2.0
#include "core/image/mean_squares.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/base/parallel.h"

namespace etak {

namespace {

// Adds the values of a row to the sums of the squares that it goes through.
template <std::size_t channels>
void add_row(const float* from, int width, int step, std::vector<double>& sums) {
  double* sum = sums.data();
  for (int x = 0; x < width; x += step, sum += channels)
    for (int u = std::min(step, width - x); u > 0; --u, from += channels)
      for (std::size_t c = 0; c < channels; ++c) sum[c] += double{from[c]};
}

}  // namespace

Image mean_squares(int width, int height, int channels, int most,
                   const std::function<RowReader(int first)>& open) {
  assert(channels == 1 || channels == 3 || channels == 4 || channels == 8);
  const auto add = channels == 1   ? add_row<1>
                   : channels == 3 ? add_row<3>
                   : channels == 4 ? add_row<4>
                                   : add_row<8>;
  const int step = std::max(1, (std::max(width, height) + most - 1) / most);
  Image out((width + step - 1) / step, (height + step - 1) / step, channels);
  const auto each = static_cast<std::size_t>(channels);
  constexpr std::size_t rows_at_once = 32;
  const auto work = [&](std::size_t begin, std::size_t end, unsigned) {
    const RowReader next = open(static_cast<int>(begin) * step);
    std::vector<double> sums(static_cast<std::size_t>(out.width) * each);
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      std::ranges::fill(sums, 0);
      const int last = std::min(height, (y + 1) * step);
      for (int v = y * step; v < last; ++v) add(next(v), width, step, sums);
      for (int x = 0; x < out.width; ++x) {
        const int count = (last - y * step) * (std::min(width, (x + 1) * step) - x * step);
        for (std::size_t c = 0; c < each; ++c)
          out.at(x, y)[c] = static_cast<float>(sums[static_cast<std::size_t>(x) * each + c] / count);
      }
    }
  };
  parallel_chunks(static_cast<std::size_t>(out.height), thread_count(0), rows_at_once, work);
  return out;
}

}  // namespace etak
