// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/fresnel/fresnel.h"
#include "core/iridescence/forms/rows.h"

namespace etak {

FilmNumbers open_pbr_metal_honest(const FilmFacts& f) {
  FilmNumbers out{f.base_f0.r, f.base_f0.g, f.base_f0.b, 0, 0, 0, f.film_n, f.thickness_nm, 1};
  // The edge as a share of Schlick's.
  const Vec3 edge = vec(f.base_f82);
  for (std::size_t c = 0; c < 3; ++c) out[c + 3] = edge[c] / f64::f_schlick(out[c], f82_cosine);
  return out;
}

FilmNumbers open_pbr_dielectric_honest(const FilmFacts& f) {
  return {1, 1, 1, f.base_n[1], f.film_n, f.thickness_nm, 1};
}

std::span<const FilmForm* const> film_forms() {
  static constexpr const FilmForm* rows[] = {
#define ETAK_FILM_FORM(name) &film_form_##name,
#include "core/iridescence/forms/forms.inc"
#undef ETAK_FILM_FORM
  };
  return rows;
}

const FilmForm* film_form(std::string_view id) {
  const auto rows = film_forms();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const FilmForm* row) { return row->id == id; });
  return found == rows.end() ? nullptr : *found;
}

}  // namespace etak
