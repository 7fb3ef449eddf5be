// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cstring>

#include "core/image/picture.h"

namespace etak {
namespace {

class MemoryRows : public RowSource {
 public:
  MemoryRows(const ConstPixelsView8& pixels, PictureHeader header)
      : RowSource(std::move(header)), pixels_(pixels) {
    header_.width = pixels.width;
    header_.height = pixels.height;
    header_.channels = pixels.channels;
  }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    const auto channels = static_cast<std::size_t>(pixels_.channels),
               width = static_cast<std::size_t>(pixels_.width);
    for (int i = 0; i < count; ++i, ++next_, rgba += stride) {
      const std::uint8_t* from = pixels_.row(next_);
      if (channels == 4)
        std::memcpy(rgba, from, 4 * width);
      else
        for (std::size_t x = 0; x < width; ++x) {
          const auto texel = four_channels(from + x * channels, channels, std::uint8_t{255});
          std::memcpy(rgba + 4 * x, texel.data(), 4);
        }
    }
  }

 private:
  const ConstPixelsView8 pixels_;
  int next_ = 0;
};

}  // namespace

void RowSource::read_float_rows(float*, std::size_t, int) {
  assert(!"a source of codes has no floats");
}

std::unique_ptr<RowSource> rows_of(const Image8& image) {
  PictureHeader header;
  header.format = "memory";
  return rows_of(view(image), std::move(header));
}

std::unique_ptr<RowSource> rows_of(const ConstPixelsView8& pixels, PictureHeader header) {
  return std::make_unique<MemoryRows>(pixels, std::move(header));
}

}  // namespace etak
