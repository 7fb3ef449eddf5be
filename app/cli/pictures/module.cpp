// SPDX-License-Identifier: Apache-2.0
// The functions that libetak-pictures.so offers; see pictures.h.
#include "app/cli/pictures/choose.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/pictures/render.h"
#include "app/cli/pictures/report.h"
#include "core/base/error.h"
#include "core/color/ocio.h"
#include "core/image/image_io.h"
#include "core/material/f0_settings.h"

namespace etak::cli {
namespace {

SpaceCurve open_source(const std::string& config, const std::string& name) {
  return [source = OcioSource::open(config, name)](float* rgb, std::size_t count) {
    source.to_linear_srgb(rgb, count);
  };
}

CustomSpace open_space(const std::string& config, const std::string& name) {
  const OcioSpace space = [&] {
    try {
      return OcioSpace::open(config, name);
    } catch (const Error& error) {
      if (!config.empty()) throw;
      throw Error(std::string(error.what()) + ", or a built-in space: " + built_in_spaces);
    }
  }();
  return {space.name(), [space](const Xyz& color, const Xyz& white) { return space.from_xyz(color, white); }};
}

}  // namespace
}  // namespace etak::cli

extern "C" const etak::cli::PicturesModule* etak_pictures_module() {
  using namespace etak;
  static const cli::PicturesModule module{
      ETAK_VERSION, &picture_door, &cli::open_source,     &cli::open_space,
      &cli::draw,   &cli::measure, &cli::stability_on_gl, &cli::choose_materials};
  return &module;
}
