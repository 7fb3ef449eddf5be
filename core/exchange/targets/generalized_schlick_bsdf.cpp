// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

// MaterialX 1.39's node of F0 and F82, the latter as a tint of Schlick's edge; a roughness that is alpha in both directions,
// and a film whose thickness is in nm.
void write_generalized_schlick_bsdf(const TargetJob& j) {
  if (j.s.film) {
    const FilmNumbers& x = j.s.film->values("generalized_schlick_bsdf").numbers;
    j.add("color0", LinearRgb{x[0], x[1], x[2]}, plain_text);
    j.add("color82", LinearRgb{x[3], x[4], x[5]}, plain_text);
    j.add_alpha("roughness");
    j.add("thinfilm_ior", x[6]);
    j.add("thinfilm_thickness", x[7]);
  } else {
    const LinearRgb f0 = j.fit_f0("color0", "color0 ends at 1");
    j.add("color0", f0, plain_text);
    const LinearRgb tint = fitted(tint82(j.s, f0), {Fit::clamp, 1, j.s.space}, "color82",
                                  "the edge tint ends at 1", j.out.changes);
    j.add("color82", tint, plain_text);
    j.shows_f82(f0, tint);
    j.add_alpha("roughness");
  }
  j.note_no_transmission("the node draws by scatter_mode RT alone");
}

}  // namespace

constinit const TargetRow target_generalized_schlick_bsdf{{.id = "generalized_schlick_bsdf",
                                                           .title = "MaterialX generalized_schlick_bsdf",
                                                           .version = "MaterialX 1.39",
                                                           .formula = "Schlick less the F82 term of color82",
                                                           .film_on_metal = "generalized_schlick_bsdf",
                                                           .film_on_dielectric = "generalized_schlick_bsdf"},
                                                          write_generalized_schlick_bsdf};

}  // namespace etak
