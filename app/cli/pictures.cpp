// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures.h"

#include <dlfcn.h>

#include "core/base/error.h"
#include "core/image/load.h"

namespace etak {
namespace cli {

const PicturesModule& pictures(const std::string& place) {
  using Open = const PicturesModule* (*)();
  constexpr const char* file = "libetak-pictures.so";
  // Looked for beside the program in a build, else where it was installed (the program's run path). Never closed.
  static void* const module = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    const char* const why = ::dlerror();
    throw Error::at(place, std::string("needs ") + file + ", which cannot be opened: " + (why == nullptr ? "" : why),
                    "an etak built with OpenImageIO, OpenColorIO and OpenGL, and memory for them");
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the one way from a symbol to a function
  static const auto open = reinterpret_cast<Open>(::dlsym(module, "etak_pictures_module"));
  if (open == nullptr) throw Error::at(file, "is of another version", "that of this etak");
  return *open();
}

PictureDoor picture_door() {
  PictureDoor door;
  door.header = [](const std::string& path) { return pictures(path).picture_door().header(path); };
  door.load = [](const std::string& path) { return pictures(path).picture_door().load(path); };
  door.load_bytes = [](std::string_view bytes, const std::string& label) {
    return pictures(label).picture_door().load_bytes(bytes, label);
  };
  door.encode = [](const Image& image, std::string_view format, std::string_view fourth) {
    return pictures("--format").picture_door().encode(image, format, fourth);
  };
  return door;
}

}  // namespace cli

AnyImage decode_picture(const std::string& path) {
  return cli::pictures(path).read_file(path);
}

AnyImage decode_picture(std::string_view bytes, const std::string& label) {
  return cli::pictures(label).read_bytes(bytes, label);
}

}  // namespace etak
