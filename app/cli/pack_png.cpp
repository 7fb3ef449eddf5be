// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"
#include "app/cli/pack.h"
#include "core/base/error.h"

namespace etak::cli {
namespace {

[[noreturn]] void become(const std::string& path) {
  become_image_program(path,
                       "is no PNG of 8 or 16 bits, and the program that reads other pictures is missing",
                       "a PNG, or an etak built with OpenImageIO and OpenColorIO");
}

}  // namespace

PictureDoor picture_door() {
  PictureDoor door;
  door.header = [](const std::string& path) -> PictureHeader { become(path); };
  door.load = [](const std::string& path) -> std::variant<Image8, Image> { become(path); };
  door.load_bytes = [](std::string_view, const std::string& label) -> std::variant<Image8, Image> {
    become(label);
  };
  return door;
}

void need_float_formats() {
  become_image_program("--format", "tiff and exr need OpenImageIO, and the program that has it is missing",
                       "png, ktx2 or dds, or an etak built with OpenImageIO and OpenColorIO");
}

SpaceOpener space_opener(const std::string&) {
  return [](const std::string& name) -> SpaceCurve {
    become_image_program(printable(name),
                         "is a space for OpenColorIO, and the program that has it is missing",
                         "srgb, linear or power-2.2, or an etak built with OpenColorIO");
  };
}

}  // namespace etak::cli
