// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/strip_reader.h"

namespace etak {

StripReader::StripReader(const PackInput& m, Texture texture, std::array<FileBytes, 2>& files)
    : width_(static_cast<std::size_t>(m.width)),
      color_(m.color[index_of(texture)], files[0]),
      grey_(m.grey[index_of(texture)], files[1]) {
  for (const PlaneRows* rows : {&color_, &grey_})
    if (rows->width() != 0) check_size(rows->source(), rows->width(), rows->height(), m.width, m.height);
}

}  // namespace etak
