// SPDX-License-Identifier: Apache-2.0
#include "core/validate/target.h"

#include <array>
#include <cassert>
#include <cstring>
#include <utility>

namespace etak {

namespace {

constexpr std::array<std::pair<FileRole, std::string_view>, 11> roles{{{FileRole::diffuse_alpha, "diffuse"},
                                                                       {FileRole::specular_gloss, "specular"},
                                                                       {FileRole::f0_only, "f0"},
                                                                       {FileRole::base_color, "base-color"},
                                                                       {FileRole::metal_rough, "metal-rough"},
                                                                       {FileRole::metallic, "metallic"},
                                                                       {FileRole::roughness, "roughness"},
                                                                       {FileRole::layout, "layout"},
                                                                       {FileRole::scene, "scene"},
                                                                       {FileRole::material, "material"},
                                                                       {FileRole::spectrum, "spectrum"}}};

class MemoryRows : public RowSource {
 public:
  MemoryRows(const ConstPixelsView8& pixels, TextureHeader header)
      : pixels_(pixels), header_(std::move(header)) {
    header_.width = pixels.width;
    header_.height = pixels.height;
    header_.channels = pixels.channels;
  }

  const TextureHeader& header() const override { return header_; }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    const auto channels = static_cast<std::size_t>(pixels_.channels);
    for (int i = 0; i < count; ++i, ++next_, rgba += stride) {
      const std::uint8_t* from = pixels_.row(next_);
      const auto width = static_cast<std::size_t>(pixels_.width);
      if (channels == 4) {
        std::memcpy(rgba, from, 4 * width);
        continue;
      }
      for (std::size_t x = 0; x < width; ++x, from += channels) {
        std::uint8_t* to = rgba + 4 * x;
        for (std::size_t c = 0; c < 3; ++c) to[c] = from[channels >= 3 ? c : 0];
        to[3] = channels == 2 ? from[1] : std::uint8_t{255};
      }
    }
  }

 private:
  const ConstPixelsView8 pixels_;
  TextureHeader header_;
  int next_ = 0;
};

}  // namespace

std::string_view name(FileRole role) {
  for (const auto& [value, text] : roles)
    if (value == role) return text;
  return "";
}

std::optional<FileRole> role_named(std::string_view text) {
  for (const auto& [value, row] : roles)
    if (row == text) return value;
  return std::nullopt;
}

void RowSource::read_float_rows(float*, std::size_t, int) {
  assert(!"a source of codes has no floats");
}

std::unique_ptr<RowSource> rows_of(const Image8& image) {
  TextureHeader header;
  header.format = "memory";
  return rows_of(view(image), std::move(header));
}

std::unique_ptr<RowSource> rows_of(const ConstPixelsView8& pixels, TextureHeader header) {
  return std::make_unique<MemoryRows>(pixels, std::move(header));
}

}  // namespace etak
