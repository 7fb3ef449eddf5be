// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/pictures.h"

#include <algorithm>
#include <array>

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

// Address space and threads that the libraries of the module take while the loader initialises them.
// Liblog4cplus, which Debian's OpenImageIO links, starts its threads then, and ends or halts the process
// where it cannot. Therefore sys::has_room() is asked before.
constexpr std::size_t library_bytes = std::size_t{448} << 20;
constexpr std::size_t library_threads = 4;

struct OpenModule {
  const PicturesModule* module = nullptr;
  std::string found;  // why there is none
};

// Opens the module, which lies beside etak in a build tree and in lib/etak where etak is installed. It is
// never closed.
OpenModule open_module() {
  const std::string here = program_folder();
  if (here.empty())
    return {nullptr, "the folder of etak, where it lies, cannot be told without /proc/self/exe"};
  const std::array candidates{here + module_file, here + ETAK_MODULES_FROM_BIN + "/" + module_file};
  const auto there = std::find_if(candidates.begin(), candidates.end(),
                                  [](const std::string& file) { return sys::may_read(file); });
  if (there == candidates.end()) return {nullptr, "is neither " + candidates[0] + " nor " + candidates[1]};
  if (!sys::has_room(library_threads, library_bytes))
    return {nullptr, "there is not room for its libraries: 448 MiB of addresses and four threads"};
  void* const module = sys::open_library(*there);
  using Open = const PicturesModule* (*)();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the one way from a symbol to a function
  const auto open = module == nullptr
                        ? nullptr
                        : reinterpret_cast<Open>(sys::library_symbol(module, "etak_pictures_module"));
  if (open != nullptr) {
    const PicturesModule* const found = open();
    if (found->version == std::string_view(ETAK_VERSION)) return {found, {}};
    return {nullptr, *there + " is of etak " + found->version + ", not " + ETAK_VERSION};
  }
  return {nullptr, "cannot be opened: " + sys::library_fault()};
}

}  // namespace

const PicturesModule& pictures(const std::string& place) {
  static const OpenModule opened = open_module();
  if (opened.module == nullptr)
    throw Error::at(place, std::string("needs ") + module_file + "; " + opened.found,
                    "an etak built with OpenImageIO, OpenColorIO and OpenGL, and memory for them");
  return *opened.module;
}

PictureDoor picture_door() {
  PictureDoor door;
  door.header = [](const std::string& path) { return pictures(path).picture_door().header(path); };
  door.file = [](const std::string& path) { return pictures(path).picture_door().file(path); };
  door.bytes = [](std::string_view bytes, const std::string& label) {
    return pictures(label).picture_door().bytes(bytes, label);
  };
  door.encode = [](const Image& image, std::string_view format, std::string_view fourth) {
    return pictures("--format").picture_door().encode(image, format, fourth);
  };
  return door;
}

}  // namespace etak::cli
