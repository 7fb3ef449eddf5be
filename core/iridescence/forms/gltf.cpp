// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/fresnel/fresnel.h"
#include "core/iridescence/forms/belcour_barla.h"
#include "core/iridescence/forms/rows.h"

namespace etak {
namespace {

constexpr std::array<FilmNumber, 6> gltf_numbers{{{"f0.r"},
                                                  {"f0.g"},
                                                  {"f0.b"},
                                                  {"iridescenceFactor"},
                                                  {"iridescenceIor", 1, 3},
                                                  {"iridescenceThicknessMaximum", 1, 1200}}};

// XYZ under equal energy to linear sRGB, with the digits of the definition, and without a change of white.
constexpr Mat3 to_rec709{{{3.2404542, -1.5371385, -0.4985314},
                          {-0.9692660, 1.8760108, 0.0415560},
                          {0.0556434, -0.2040259, 1.0572252}}};

// The film's own part: the base is a real index, its F over the angle is Schlick's, and two waves are summed.
Vec3 gltf_film(const FilmNumbers& numbers, double cosine) {
  // The index becomes that of air where the thickness, in nm, goes from 0.03 to 0.
  const double thickness = numbers[5], t = std::clamp(thickness / 0.03, 0.0, 1.0);
  const double index = 1 + (numbers[4] - 1) * t * t * (3 - 2 * t);
  const double inside2 = 1 - (1 - cosine * cosine) / (index * index);
  if (inside2 < 0) return {1, 1, 1};
  const double inside = std::sqrt(inside2), outer = f64::f_schlick(f64::f0(index, 0), cosine),
               through = 1 - outer;
  const double outer_phase = index < 1 ? 0 : std::numbers::pi;
  Vec3 phase{}, base{}, pair{}, left{}, sum{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(numbers[c], 0.0, 0.9999)), base_index = (1 + root) / (1 - root);
    base[c] = f64::f_schlick(f64::f0(base_index / index, 0), inside);
    phase[c] = outer_phase + (base_index < index ? std::numbers::pi : 0);
    pair[c] = std::clamp(outer * base[c], 1e-5, 0.9999);
    const double all = through * through * base[c] / (1 - pair[c]);
    sum[c] = outer + all;
    left[c] = all - through;
  }
  for (int m = 1; m <= 2; ++m) {
    const Vec3 wave = to_rec709 * wave_seen(m * 2 * index * thickness * inside, scaled(phase, m));
    for (std::size_t c = 0; c < 3; ++c) {
      left[c] *= std::sqrt(pair[c]);
      sum[c] += left[c] * 2 * wave[c];
    }
  }
  for (double& each : sum) each = std::max(each, 0.0);
  return sum;
}

Vec3 gltf_seen(const FilmNumbers& numbers, double cosine) {
  Vec3 out = gltf_film(numbers, cosine);
  for (std::size_t c = 0; c < 3; ++c) {
    const double bare = f64::f_schlick(numbers[c], cosine);
    out[c] = bare + (out[c] - bare) * numbers[3];
  }
  return out;
}

FilmNumbers gltf_honest(const FilmFacts& f) {
  return {f.base_f0.r, f.base_f0.g, f.base_f0.b, 1, f.film_n, f.thickness_nm};
}

}  // namespace

constinit const FilmForm film_form_gltf{
    "gltf",
    "glTF KHR_materials_iridescence",
    "Khronos Group, KHR_materials_iridescence (ratified 2022), section Implementation; as three.js 0.187 has it",
    true,
    true,
    gltf_numbers,
    4,
    gltf_seen,
    gltf_honest};

}  // namespace etak
