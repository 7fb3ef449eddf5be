// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/pictures.h"

#include "app/pictures/open_module.h"
#include "core/base/error.h"

namespace etak::cli {
namespace {

constexpr const char* module_file = "libetak-pictures.so";

}  // namespace

const PicturesModule& pictures(const std::string& place) {
  static const OpenedModule opened =
      open_module_of_program(module_file, ETAK_MODULES_FROM_BIN, "etak_pictures_module", ETAK_VERSION);
  if (opened.table == nullptr)
    throw Error::at(place, std::string("needs ") + module_file + "; " + opened.fault,
                    "an etak built with OpenImageIO, OpenColorIO and OpenGL, and memory for them");
  return *static_cast<const PicturesModule*>(opened.table);
}

PictureDoor picture_door() {
  return picture_door_behind(
      [](const std::string& place) -> const PictureDoors& { return pictures(place).doors; });
}

}  // namespace etak::cli
