// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/fresnel.h"
#include "core/iridescence/forms/rows.h"

namespace etak {
namespace {

constexpr std::array<FilmNumber, 6> f82_numbers{
    {{"f0.r"}, {"f0.g"}, {"f0.b"}, {"f82_tint.r"}, {"f82_tint.g"}, {"f82_tint.b"}}};

Vec3 f82_seen(const FilmNumbers& x, double cosine) {
  return {f64::f_f82_tint(x[0], x[3], cosine), f64::f_f82_tint(x[1], x[4], cosine),
          f64::f_f82_tint(x[2], x[5], cosine)};
}

FilmNumbers f82_honest(const FilmFacts& f) {
  FilmNumbers out{f.whole_f0.r, f.whole_f0.g, f.whole_f0.b};
  const Vec3 edge = vec(f.whole_f82);
  for (std::size_t c = 0; c < 3; ++c) out[c + 3] = edge[c] / f64::f_schlick(out[c], f82_cosine);
  return out;
}

}  // namespace

constinit const FilmForm film_form_f82{"f82",
                                       "F0 and F82 of the whole, no film",
                                       "Kutz, Hasan, Edmondson 2021; OpenPBR 1.1.1, metal",
                                       true,
                                       true,
                                       f82_numbers,
                                       f82_numbers.size(),
                                       f82_seen,
                                       f82_honest};

}  // namespace etak
