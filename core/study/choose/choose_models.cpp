// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose_models.h"

#include <algorithm>
#include <string>

#include "core/color/gloss.h"

namespace etak {

std::vector<const Model*> whole_models() {
  std::vector<const Model*> out;
  for (const Model& model : models()) {
    const auto& of = model.parameters;
    if (model.kind != ModelKind::specular || of.empty()) continue;
    const bool colors = takes_index(model) ? of.size() == 3 && of[1].role == Role::k
                                           : of.size() == 2 && of[0].role == Role::f0 && of[0].color;
    const Role width = of.back().role;
    const bool is_frame = model.distribution != nullptr && model.distribution->id == "ggx";
    if (colors && !is_frame && !model.compensated() &&
        (width == Role::gloss || width == Role::alpha || width == Role::exponent))
      out.push_back(&model);
  }
  return out;
}

bool masks_ggx(const Term& term) {
  return term.kind == TermKind::visibility && !term.compensated && !term.id.starts_with("smith-beckmann");
}

bool takes_index(const Model& model) {
  return model.parameters[0].role == Role::n;
}

std::vector<double> whole_model_numbers(const Model& model, const Vec3& f0, const FresnelValues& index,
                                        const SurfaceTexel& texel) {
  const Parameter& of = model.parameters.back();
  const double width = of.role == Role::gloss   ? double{texel.gloss}
                       : of.role == Role::alpha ? lobe_alpha(texel)
                                                : texel.gloss.exponent();
  std::vector<double> out(f0.begin(), f0.end());
  if (takes_index(model))
    out = {index[0][0], index[1][0], index[2][0], index[0][1], index[1][1], index[2][1]};
  out.push_back(std::clamp(width, of.min, of.max));
  return out;
}

const FresnelForm* form_of(const Model& model) {
  if (model.id.starts_with("schueler-optimized")) return nullptr;
  if (takes_index(model)) return fresnel_form("index");
  std::string id(model.fresnel != nullptr ? model.fresnel->id : "schueler");
  std::ranges::replace(id, '-', '_');
  return fresnel_form(id);
}

}  // namespace etak
