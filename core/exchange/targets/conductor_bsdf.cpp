// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/rgb_index.h"

namespace etak {
namespace {

// MaterialX 1.39's node of metals: n and k of each channel, a roughness that is alpha in both directions, and a film whose
// thickness is in nm.
void write_conductor_bsdf(const TargetJob& j) {
  if (j.s.film && j.metal()) {
    const FilmNumbers& x = j.s.film->values("conductor_bsdf").numbers;
    j.add("ior", LinearRgb{x[0], x[1], x[2]}, plain_text);
    j.add("extinction", LinearRgb{x[3], x[4], x[5]}, plain_text);
    j.add_alpha("roughness");
    j.add("thinfilm_ior", x[6]);
    j.add("thinfilm_thickness", x[7]);
    return;
  }
  const RgbIndex index = rgb_index(j.s);
  note_residual(j, index);
  j.add("ior", index.n, plain_text);
  j.add("extinction", index.k, plain_text);
  j.shows_conductor(index.n, index.k);
  j.add_alpha("roughness");
  if (!j.metal()) j.note("the node is made for metals: a dielectric has its surface alone");
  j.note_no_transmission("the node does not draw");
}

}  // namespace

constinit const TargetRow target_conductor_bsdf{{.id = "conductor_bsdf",
                                                 .title = "MaterialX conductor_bsdf",
                                                 .version = "MaterialX 1.39",
                                                 .formula = "Fresnel's equations of each channel",
                                                 .film_on_metal = "conductor_bsdf"},
                                                write_conductor_bsdf};

}  // namespace etak
