// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack.h"
#include "core/atlas/sources/picture_door.h"
#include "core/color/ocio.h"

namespace etak::cli {

PictureDoor picture_door() {
  return etak::picture_door();
}

void need_float_formats() {}

SpaceOpener space_opener(const std::string& config) {
  return [config](const std::string& name) -> SpaceCurve {
    return [source = OcioSource::open(config, name)](float* rgb, std::size_t count) {
      source.to_linear_srgb(rgb, count);
    };
  };
}

}  // namespace etak::cli
