// SPDX-License-Identifier: Apache-2.0
#include "core/image/load.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/base/memory.h"
#include "core/image/any_image.h"
#include "core/image/files/png.h"
#include "core/image/picture_bytes.h"

namespace etak {
namespace {

// nullopt: no PNG, or one for the decoder.
std::optional<LoadedImage> load_png(std::string_view bytes, const std::string& label) {
  std::optional<PngReader> reader = PngReader::open(bytes, label);
  if (!reader) return std::nullopt;
  const PngInfo& info = reader->info();
  LoadedImage out;
  const auto read = [&]<class Value>(Pixels<Value> image) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
    reader->read_rows(reinterpret_cast<std::uint8_t*>(image.values.data()),
                      static_cast<std::size_t>(image.width * image.channels) * sizeof(Value), image.height);
    out.pixels = std::move(image);
  };
  if (info.bits == 8)
    read(Image8(info.width, info.height, info.channels));
  else
    read(Image16(info.width, info.height, info.channels));
  out.format = "png";
  return out;
}

// What `decode` makes of `source`, a path or bytes and their label.
template <class Decode, class... Source>
LoadedImage decoded(const Decode& decode, const std::string& label, const Source&... source) {
  if (!decode) throw Error::at(label, "is of a form that needs a decoder of pictures", "a plain PNG");
  AnyImage image = decode(source...);
  LoadedImage out;
  out.pixels = std::move(image.pixels);
  out.format = image.info.format;
  out.lossy = image.info.lossy;
  out.srgb = image.info.srgb_tag;
  out.icc_profile = image.info.icc_profile;
  out.oiio_colour_space = image.info.colour_space;
  return out;
}

void add_png_colour(LoadedImage& image, std::string_view bytes) {
  const PngColour colour = png_colour(bytes);
  image.srgb = colour.srgb;
  image.icc_profile = colour.icc_profile;
  image.gamma = colour.gamma;
}

template <class Get>
int of_pixels(const LoadedImage& image, Get get) {
  return std::visit([&](const auto& pixels) { return static_cast<int>(get(pixels)); }, image.pixels);
}

}  // namespace

int LoadedImage::width() const {
  return of_pixels(*this, [](const auto& p) { return p.width; });
}

int LoadedImage::height() const {
  return of_pixels(*this, [](const auto& p) { return p.height; });
}

int LoadedImage::channels() const {
  return of_pixels(*this, [](const auto& p) { return p.channels; });
}

int LoadedImage::bits() const {
  return of_pixels(*this, [](const auto& p) { return 8 * sizeof(p.values[0]); });
}

LoadedImage load_picture(std::string_view bytes, const std::string& label, const PictureDecoder& decoder) {
  return with_memory_for(
      label, [] { return "its pixels"; },
      [&] {
        if (picture_format(bytes, label) != "png") return decoded(decoder.bytes, label, bytes, label);
        std::optional<LoadedImage> png = load_png(bytes, label);
        LoadedImage out = png ? std::move(*png) : decoded(decoder.bytes, label, bytes, label);
        add_png_colour(out, bytes);
        return out;
      });
}

LoadedImage load_picture(const std::string& path, const PictureDecoder& decoder) {
  if (picture_format(read_head(path, 8), path) != "png")
    return with_memory_for(
        path, [] { return "its pixels"; }, [&] { return decoded(decoder.file, path, path); });
  return load_picture(SteadyFile(path, largest_picture_bytes).all(), path, decoder);
}

}  // namespace etak
