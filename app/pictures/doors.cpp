// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/doors.h"

#include "core/base/error.h"
#include "core/color/ocio.h"
#include "core/image/image_io.h"
#include "core/material/f0/f0_settings.h"

namespace etak {
namespace {

SpaceCurve open_source(const std::string& config, const std::string& name) {
  return [source = OcioConfig::open(config).source(name)](float* rgb, std::size_t count) {
    source.to_linear_srgb(rgb, count);
  };
}

CustomSpace open_space(const std::string& config, const std::string& name) {
  const OcioSpace space = [&] {
    try {
      return OcioConfig::open(config).space(name);
    } catch (const Error& error) {
      if (!config.empty()) throw;
      throw Error(std::string(error.what()) + ", or a built-in space: " + built_in_spaces);
    }
  }();
  return {space.name(), [space](const Xyz& color, const Xyz& white) { return space.from_xyz(color, white); }};
}

}  // namespace

PictureDoors picture_doors(const char* version) {
  return {version, &picture_door, &open_source, &open_space};
}

}  // namespace etak
