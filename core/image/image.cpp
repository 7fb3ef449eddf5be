// SPDX-License-Identifier: Apache-2.0
#include "core/image/image.h"

namespace etak {

Image shrunk(const Image& image, int width, int height) {
  assert(width >= 1 && width <= image.width && height >= 1 && height <= image.height);
  // The old columns or rows that a new one covers: index of the first, and the share of each in the mean.
  struct Part {
    int first;
    std::vector<double> share;
  };
  const auto parts = [](int from, int to) {
    std::vector<Part> out;
    for (int i = 0; i < to; ++i) {
      const double begin = double(i) * from / to, end = double(i + 1) * from / to;
      Part part{static_cast<int>(begin), {}};
      for (int at = part.first; at < from && at < end; ++at)
        part.share.push_back((std::min(end, at + 1.0) - std::max(begin, double(at))) / (end - begin));
      out.push_back(std::move(part));
    }
    return out;
  };
  const std::vector<Part> columns = parts(image.width, width), rows = parts(image.height, height);
  Image out(width, height, image.channels);
  for (int y = 0; y < height; ++y) {
    const Part& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < width; ++x) {
      const Part& column = columns[static_cast<std::size_t>(x)];
      for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < row.share.size(); ++i)
          for (std::size_t j = 0; j < column.share.size(); ++j)
            sum += row.share[i] * column.share[j] *
                   double{image.at(column.first + static_cast<int>(j), row.first + static_cast<int>(i))[c]};
        out.at(x, y)[c] = static_cast<float>(sum);
      }
    }
  }
  return out;
}

std::uint8_t to_code(float value) {
  // NaN fails both comparisons and ends at 0.
  const float clamped = value > 0 ? (value < 1 ? value : 1.0f) : 0.0f;
  return static_cast<std::uint8_t>(255 * clamped + 0.5f);
}

}  // namespace etak
