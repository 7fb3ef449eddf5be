// SPDX-License-Identifier: Apache-2.0
// In place of app/cli/pictures/pictures.cpp: there are no libraries that could be opened.
#include "app/cli/pictures/pictures.h"

#include "app/pictures/open_module.h"
#include "core/base/error.h"

namespace etak::cli {

const PicturesModule& pictures(const std::string& place) {
  throw Error::at(place,
                  "needs OpenImageIO, OpenColorIO or another library that etak does not have in a browser",
                  "PNG, DDS, KTX2 without Zstandard and built-in spaces, or etak as a program");
}

PictureDoor picture_door() {
  return picture_door_behind(
      [](const std::string& place) -> const PictureDoors& { return pictures(place).doors; });
}

}  // namespace etak::cli
