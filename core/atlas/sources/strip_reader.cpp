// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/strip_reader.h"

#include "core/base/error.h"

namespace etak {

StripReader::StripReader(const PackInput& m, Texture texture, std::array<FileBytes, 2>& files)
    : width_(static_cast<std::size_t>(m.width)),
      color_(m.color[index_of(texture)], files[0]),
      grey_(m.grey[index_of(texture)], files[1]) {
  for (const PlaneRows* rows : {&color_, &grey_})
    if (rows->width() != 0 && (rows->width() != m.width || rows->height() != m.height))
      throw Error::at(
          rows->source().path, "is " + std::to_string(rows->width()) + " x " + std::to_string(rows->height()),
          std::to_string(m.width) + " x " + std::to_string(m.height) + ", as when it was looked at");
}

}  // namespace etak
