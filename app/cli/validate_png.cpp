// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/image_program.h"
#include "app/cli/validate.h"
#include "core/image/image_io.h"

namespace etak {
namespace {

[[noreturn]] void become(const std::string& place) {
  cli::become_image_program(place,
                            "is no PNG of 8 or 16 bits, and the program that reads other pictures is missing",
                            "a PNG, or an etak built with OpenImageIO and OpenColorIO");
}

}  // namespace

// The bodies of OpenImageIO's door for this program, which does not link that library: loading it takes as
// long and as much memory as a check.
AnyImage read_any_image(const std::string& path) {
  become(path);
}
AnyImage read_any_image(std::string_view, const std::string& label) {
  become(label);
}

namespace cli {

void need_readers_of(const std::vector<std::string>& files) {
  constexpr std::array<std::string_view, 8> endings{".jpg",  ".jpeg", ".exr", ".tif",
                                                    ".tiff", ".webp", ".tga", ".hdr"};
  for (const std::string& file : files) {
    std::string ending = file.substr(std::min(file.rfind('.'), file.size()));
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (std::find(endings.begin(), endings.end(), ending) != endings.end()) become(file);
  }
}

}  // namespace cli
}  // namespace etak
