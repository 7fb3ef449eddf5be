// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/pictures.h"

#include <array>

#include "app/pictures/open_module.h"
#include "core/base/error.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

constexpr const char* module_file = "libetak-pictures.so";

// The absolute path of the running program's folder with '/' at its end; empty where the system does not tell
// it. The module is looked for in no other place, such as the working folder or the search path of the
// loader: a file of its name there may be anybody's.
std::string program_folder() {
  const std::string whole = sys::program_path();
  return whole.substr(0, whole.rfind('/') + 1);
}

// Opens the module, which lies beside etak in a build tree and in lib/etak where etak is installed.
OpenedModule open_beside_program() {
  const std::string here = program_folder();
  if (here.empty())
    return {nullptr, "the folder of etak, where it lies, cannot be told without /proc/self/exe"};
  const std::array candidates{here + module_file, here + ETAK_MODULES_FROM_BIN + "/" + module_file};
  return open_module(candidates, "etak_pictures_module", ETAK_VERSION);
}

}  // namespace

const PicturesModule& pictures(const std::string& place) {
  static const OpenedModule opened = open_beside_program();
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
