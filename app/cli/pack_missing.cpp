// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack.h"
#include "core/base/error.h"

namespace etak::cli {

int pack_atlas(PackArguments&) {
  throw Error::at("etak pack", "this etak was built without zlib or OpenImageIO", "a build with both");
}

PictureDoor picture_door() {
  return {};
}

}  // namespace etak::cli
