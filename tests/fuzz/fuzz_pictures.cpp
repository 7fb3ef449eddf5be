// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a picture that OpenImageIO decodes is read or refused with an Error, and a file says the same as its
// bytes do. The first byte picks the ending of the name. OpenImageIO itself is not instrumented; what is looked for is
// what it throws, where it reads or writes beyond memory, and what etak expects of it. Pictures that say that they are large
// are left out: their memory is theirs by right, and libFuzzer ends a run of more than 2 GiB.
#include <unistd.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/picture_bytes.h"

using namespace etak;

namespace {

constexpr std::array endings{"exr", "tif", "jpg", "hdr", "tga", "webp"};
constexpr int most_side = 512;

struct Folder {
  std::string path = "/tmp/fuzz_pictures.XXXXXX";
  Folder() {
    if (::mkdtemp(path.data()) == nullptr) std::abort();
  }
  ~Folder() { std::filesystem::remove_all(path); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const Folder folder;
  const std::vector<char> bytes(data + 1, data + size);
  const std::string name = std::string("f.") + endings[data[0] % endings.size()];
  const std::string path = folder.path + '/' + name;
  // A lossless WebP file of one colour needs few bytes for 1 GiB, which its decoder takes when it reads the head.
  if (const auto stated = stated_size({bytes.data(), bytes.size()}, "webp");
      picture_format({bytes.data(), bytes.size()}, name) == "webp" && stated &&
      (stated->width > most_side || stated->height > most_side))
    return 0;
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    const PictureHeader header = read_picture_header(path);
    if (header.width > most_side || header.height > most_side) return 0;
    const Picture picture = read_picture(path);
    assert(picture.header.width == header.width && picture.header.height == header.height &&
           picture.header.channels == header.channels);
    const Picture same = read_picture({bytes.data(), bytes.size()}, name);
    assert(same.header.width == header.width && same.header.channels == header.channels &&
           same.pixels.index() == picture.pixels.index());
  } catch (const Error&) {
  }
  return 0;
}
