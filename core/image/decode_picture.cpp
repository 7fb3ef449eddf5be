// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_io.h"
#include "core/image/load.h"

namespace etak {

AnyImage decode_picture(const std::string& path) {
  return read_any_image(path);
}

AnyImage decode_picture(std::string_view bytes, const std::string& label) {
  return read_any_image(bytes, label);
}

}  // namespace etak
