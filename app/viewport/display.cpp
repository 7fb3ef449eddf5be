// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/display.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/render/display.h"

namespace etak {

ViewDisplay open_display(const std::string& config, const std::string& display, const std::string& view,
                         Tone tone) {
  ViewDisplay out{config, display, view, nullptr, nullptr, Tone::plain};
  if (config.empty() && display.empty() && view.empty()) {
    out.tone = tone;
    return out;
  }
  out.cpu = std::make_shared<const OcioDisplay>(OcioConfig::open(config).display(display, view));
  out.gpu = std::make_shared<const OcioShader>(out.cpu->shader());
  return out;
}

QImage shown(const Image& linear, const ViewDisplay& display, unsigned threads) {
  QImage out(linear.width, linear.height, QImage::Format_RGB888);
  const auto row_of = [&](int y, std::uint8_t* codes) {
    const std::span<const float> pixels(linear.at(0, y).data(), static_cast<std::size_t>(linear.width) * 4);
    if (display.cpu) {
      Image row(linear.width, 1, 3);
      for (int x = 0; x < linear.width; ++x) std::copy_n(linear.at(x, y).data(), 3, row.at(x, 0).data());
      display.cpu->apply(row.values.data(), row.pixel_count());
      std::transform(row.values.begin(), row.values.end(), codes, to_code);
      return;
    }
    to_codes(pixels, 1, Transfer::srgb, display.tone, codes);
  };
  std::vector<std::uint8_t*>
      lines;  // found before the threads start, because scanLine() may copy the picture
  for (int y = 0; y < out.height(); ++y) lines.push_back(out.scanLine(y));
  parallel_chunks(lines.size(), threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t y = begin; y < end; ++y) row_of(static_cast<int>(y), lines[y]);
  });
  return out;
}

QImage cpu_picture(const ViewState& state, const ViewDisplay& display, const QSize& size, unsigned threads,
                   const RowsDone& rows_done) {
  return shown(draw_view(state, size.width(), size.height(), threads, rows_done), display, threads);
}

}  // namespace etak
