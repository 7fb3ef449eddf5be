// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"
#include "app/cli/pack.h"

namespace etak::cli {
namespace {

[[noreturn]] void become(const std::string& path) {
  become_image_program(path,
                       "is no PNG of 8 or 16 bits, and the program that reads other pictures is missing",
                       "a PNG, or an etak built with OpenImageIO and OpenColorIO");
}

}  // namespace

PictureDoor picture_door() {
  return {[](const std::string& path) -> PictureHeader { become(path); },
          [](const std::string& path) -> std::variant<Image8, Image> { become(path); },
          [](std::string_view, const std::string& label) -> std::variant<Image8, Image> { become(label); }};
}

}  // namespace etak::cli
