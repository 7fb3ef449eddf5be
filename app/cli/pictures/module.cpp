// SPDX-License-Identifier: Apache-2.0
// The functions that libetak-pictures.so offers; see pictures.h.
#include "app/cli/pictures/choose.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/pictures/render.h"
#include "app/cli/pictures/report.h"

extern "C" const etak::cli::PicturesModule* etak_pictures_module() {
  using namespace etak;
  static const cli::PicturesModule module{picture_doors(ETAK_VERSION), &cli::draw, &cli::measure,
                                          &cli::stability_on_gl, &cli::choose_materials};
  return &module;
}
