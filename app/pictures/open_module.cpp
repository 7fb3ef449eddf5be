// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/open_module.h"

#include <algorithm>
#include <array>

#include "app/pictures/doors.h"
#include "core/base/setting.h"
#include "core/base/system.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

// Address space and threads that the libraries of the module take while the loader initialises them.
// Liblog4cplus, which Debian's OpenImageIO links, starts its threads then, and ends or halts the process
// where it cannot. Therefore sys::has_room() is asked before.
constexpr std::size_t library_bytes = std::size_t{448} << 20;
constexpr std::size_t library_threads = 4;

}  // namespace

OpenedModule open_module(std::span<const std::string> candidates, const char* function,
                         std::string_view version) {
  const auto there = std::find_if(candidates.begin(), candidates.end(),
                                  [](const std::string& file) { return sys::may_read(file); });
  if (there == candidates.end())
    return {nullptr, candidates.size() > 1 ? "is neither " + joined(candidates, " nor ")
                                           : "is not " + joined(candidates)};
  if (!sys::has_room(library_threads, library_bytes))
    return {nullptr, "there is not room for its libraries: 448 MiB of addresses and four threads"};
  void* const module = sys::open_library(*there);
  using Open = const PictureDoors* (*)();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the one way from a symbol to a function
  const auto open =
      module == nullptr ? nullptr : reinterpret_cast<Open>(sys::library_symbol(module, function));
  if (open == nullptr) return {nullptr, "cannot be opened: " + sys::library_fault()};
  const PictureDoors* const found = open();
  if (found->version == version) return {found, {}};
  return {nullptr, *there + " is of etak " + found->version + ", not " + std::string(version)};
}

OpenedModule open_module_of_program(const std::string& file, const std::string& from_bin,
                                    const char* function, std::string_view version) {
  const std::string program = sys::program_path();
  const std::string here = program.substr(0, program.rfind('/') + 1);
  if (here.empty())
    return {nullptr, "the folder of etak, where it lies, cannot be told without /proc/self/exe"};
  const std::array candidates{here + file, here + from_bin + "/" + file};
  return open_module(candidates, function, version);
}

PictureDoor picture_door_behind(const OpenDoors& doors) {
  PictureDoor door;
  door.header = [doors](const std::string& path) { return doors(path).picture_door().header(path); };
  door.file = [doors](const std::string& path) { return doors(path).picture_door().file(path); };
  door.bytes = [doors](std::string_view bytes, const std::string& label) {
    return doors(label).picture_door().bytes(bytes, label);
  };
  door.encode = [doors](const Image& image, std::string_view format, std::string_view fourth) {
    return doors(setting("textures")).picture_door().encode(image, format, fourth);
  };
  door.text = [doors](std::string_view text, int size) {
    return doors("pictures of plots").picture_door().text(text, size);
  };
  door.mesh.meshopt = [doors](const MeshoptElements& elements, const std::string& place) {
    return doors(place).picture_door().mesh.meshopt(elements, place);
  };
  door.mesh.draco = [doors](std::string_view bytes, const std::vector<DracoArray>& arrays,
                            const std::string& place) {
    return doors(place).picture_door().mesh.draco(bytes, arrays, place);
  };
  door.astc.encode = [doors](std::span<const AnyBlock> blocks, const AstcEncoding& how, std::uint8_t* bytes) {
    doors(setting("compress")).picture_door().astc.encode(blocks, how, bytes);
  };
  door.astc.decode = [doors](std::string_view bytes, const AstcEncoding& how, int width, int height,
                             const std::string& place) {
    return doors(place).picture_door().astc.decode(bytes, how, width, height, place);
  };
  return door;
}

}  // namespace etak
