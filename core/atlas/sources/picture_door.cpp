// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/picture_door.h"

#include "core/image/image_io.h"
#include "core/image/load.h"

namespace etak {
namespace {

std::variant<Image8, Image> codes_or_floats(const LoadedImage& loaded) {
  if (const auto* codes = std::get_if<Image8>(&loaded.pixels)) return *codes;
  if (const auto* floats = std::get_if<Image>(&loaded.pixels)) return *floats;
  const auto& wide = std::get<Image16>(loaded.pixels);
  Image out(wide.width, wide.height, wide.channels);
  for (std::size_t i = 0; i < wide.values.size(); ++i)
    out.values[i] = static_cast<float>(wide.values[i] / 65535.0);
  return out;
}

}  // namespace

PictureDoor picture_door() {
  PictureDoor door;
  const PictureDecoder decoder = image_io_decoder();
  door.header = [](const std::string& path) {
    const ImageInfo info = read_image_info(path);
    return PictureHeader{info.width, info.height, info.channels, info.floating ? 32 : info.bits, false};
  };
  door.load = [decoder](const std::string& path) { return codes_or_floats(load_picture(path, decoder)); };
  door.load_bytes = [decoder](std::string_view bytes, const std::string& label) {
    return codes_or_floats(load_picture(bytes, label, decoder));
  };
  door.encode = [](const Image& image, std::string_view format, std::string_view fourth) {
    return format == "exr" ? exr_bytes(image, std::string(fourth)) : tiff_bytes(image, std::string(fourth));
  };
  return door;
}

}  // namespace etak
