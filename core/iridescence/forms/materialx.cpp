// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include "core/fresnel/fresnel.h"
#include "core/iridescence/forms/belcour_barla.h"
#include "core/iridescence/forms/rows.h"
#include "core/math/functions.h"

// The four forms of MaterialX 1.39.5: its nodes conductor_bsdf and generalized_schlick_bsdf, and its graph of OpenPBR,
// where a metal is generalized_schlick_bsdf, a dielectric dielectric_bsdf, and the film's weight mixes with the bare base.

namespace etak {
namespace {

constexpr double pi = std::numbers::pi;

// How a base reflects the light in the film, for one direction of polarisation; phases in radians.
struct BaseWaves {
  Vec3 reflected{}, phase{};
};
using BothWaves = std::array<BaseWaves, 2>;  // along and across the plane of incidence

// XYZ to CIE RGB under equal energy, which the renderer takes for its own linear RGB.
constexpr Mat3 to_cie_rgb{{{2.3706743, -0.9000405, -0.4706338},
                           {-0.5138850, 1.4253036, 0.0885814},
                           {0.0052982, -0.0146949, 1.0093968}}};

// Reflectance along and across the plane of incidence, of a real index.
std::array<double, 2> real_interface(double cosine, double index) {
  const double c2 = cosine * cosine, s2 = 1 - c2, under = std::max(index * index - s2, 0.0);
  const double sum = under + c2, twice = 2 * std::sqrt(under) * cosine,
               across = (sum - twice) / (sum + twice);
  const double a = c2 * under + s2 * s2, b = twice * s2;
  return {across * (a - b) / (a + b), across};
}

// mx_fresnel_airy. `base(inside)` has the waves at a cosine inside the film.
template <class Base>
Vec3 airy(double index_asked, double thickness_nm, double cosine, const Base& base) {
  const double index = std::max(index_asked, 1.0);
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  std::array<double, 2> outer = real_interface(cosine, index);
  if (inside <= 0) outer = {1, 1};
  const double brewster = math::cos(math::atan(index));
  const std::array<double, 2> outer_phase{cosine < brewster ? 0 : pi, pi};
  const BothWaves waves = base(inside);
  Vec3 xyz{};
  for (std::size_t p = 0; p < 2; ++p) {
    const double through = 1 - outer[p];
    Vec3 left{}, pair{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double inner = waves[p].reflected[c], all = through * through * inner / (1 - outer[p] * inner);
      xyz[c] += outer[p] + all;
      left[c] = all - through;
      pair[c] = std::sqrt(std::max(outer[p] * inner, 0.0));
    }
    for (int m = 1; m <= 2; ++m) {
      Vec3 phase = waves[p].phase;
      for (double& each : phase) each = m * (each + outer_phase[p]);
      const Vec3 wave = wave_seen(m * 2 * index * inside * thickness_nm, phase);
      for (std::size_t c = 0; c < 3; ++c) {
        left[c] *= pair[c];
        xyz[c] += left[c] * 2 * wave[c];
      }
    }
  }
  Vec3 out = to_cie_rgb * scaled(xyz, 0.5);
  for (double& each : out) each = std::clamp(each, 0.0, 1.0);
  return out;
}

// mx_fresnel_hoffman_schlick with F90 = 1 and exponent 5: Hoffman's F82.
Vec3 schlick82(const double* f0, const double* tint, double cosine) {
  return {f64::f_f82_tint(f0[0], tint[0], cosine), f64::f_f82_tint(f0[1], tint[1], cosine),
          f64::f_f82_tint(f0[2], tint[2], cosine)};
}

// The base of generalized_schlick_bsdf: half of F for each direction, and the phases of a real index.
Vec3 schlick_film(const double* f0, const double* tint, double film_index, double thickness_nm,
                  double cosine) {
  if (!(thickness_nm > 0)) return schlick82(f0, tint, cosine);
  return airy(film_index, thickness_nm, cosine, [&](double inside) {
    BaseWaves one{scaled(schlick82(f0, tint, inside), 0.5), {}};
    for (std::size_t c = 0; c < 3; ++c) {
      const double root = std::sqrt(std::clamp(f0[c], 0.01, 0.99));
      one.phase[c] = (1 + root) / (1 - root) < std::max(film_index, 1.0) ? pi : 0;
    }
    return BothWaves{one, one};
  });
}

// A base of n and k, each of red, green and blue.
BothWaves index_waves(const double* n, const double* k, double film_index, double inside) {
  BothWaves out;
  const double c2 = inside * inside, s2 = 1 - c2;
  for (std::size_t c = 0; c < 3; ++c) {
    const double rn = n[c] / film_index, rk = k[c] / film_index;
    const double t0 = rn * rn - rk * rk - s2, both = math::hypot(t0, 2 * rn * rk);
    const double a = std::sqrt(std::max((both + t0) / 2, 0.0)), sum = both + c2, twice = 2 * a * inside;
    out[1].reflected[c] = (sum - twice) / (sum + twice);
    const double near = c2 * both + s2 * s2, across = twice * s2;
    out[0].reflected[c] = out[1].reflected[c] * (near - across) / (near + across);
    // The phases, with the extinction as a share of the index.
    const double e1 = film_index, n2 = n[c] * n[c], share = k[c] / n[c];
    const double x = n2 * (1 - share * share) - e1 * e1 * s2, y = math::hypot(x, 2 * n2 * share);
    const double u = std::sqrt((x + y) / 2), v = std::sqrt(std::max((y - x) / 2, 0.0));
    out[1].phase[c] = math::atan2(2 * e1 * v * inside, u * u + v * v - e1 * e1 * c2);
    out[0].phase[c] =
        math::atan2(2 * e1 * n2 * inside * (2 * share * u - (1 - share * share) * v),
                    math::pow(n2 * (1 + share * share) * inside, 2) - e1 * e1 * (u * u + v * v));
  }
  return out;
}

Vec3 index_film(const double* n, const double* k, double film_index, double thickness_nm, double cosine) {
  if (thickness_nm > 0)
    return airy(film_index, thickness_nm, cosine,
                [&](double inside) { return index_waves(n, k, std::max(film_index, 1.0), inside); });
  return {f64::fresnel_exact(n[0], k[0], cosine), f64::fresnel_exact(n[1], k[1], cosine),
          f64::fresnel_exact(n[2], k[2], cosine)};
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
  return {a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share};
}

constexpr std::array<FilmNumber, 8> conductor_numbers{{{"ior.r", 0.01, 8},
                                                       {"ior.g", 0.01, 8},
                                                       {"ior.b", 0.01, 8},
                                                       {"extinction.r", 0, 12},
                                                       {"extinction.g", 0, 12},
                                                       {"extinction.b", 0, 12},
                                                       {"thinfilm_ior", 1, 3},
                                                       {"thinfilm_thickness", 1, 1200}}};
constexpr std::array<FilmNumber, 8> schlick_numbers{{{"color0.r"},
                                                     {"color0.g"},
                                                     {"color0.b"},
                                                     {"color82.r"},
                                                     {"color82.g"},
                                                     {"color82.b"},
                                                     {"thinfilm_ior", 1, 3},
                                                     {"thinfilm_thickness", 1, 1200}}};
Vec3 conductor_seen(const FilmNumbers& x, double cosine) {
  return index_film(x.data(), x.data() + 3, x[6], x[7], cosine);
}
FilmNumbers conductor_honest(const FilmFacts& f) {
  return {f.base_n[0], f.base_n[1], f.base_n[2], f.base_k[0],
          f.base_k[1], f.base_k[2], f.film_n,    f.thickness_nm};
}

Vec3 schlick_seen(const FilmNumbers& x, double cosine) {
  return schlick_film(x.data(), x.data() + 3, x[6], x[7], cosine);
}
Vec3 metal_seen(const FilmNumbers& x, double cosine) {
  return mixed(schlick82(x.data(), x.data() + 3, cosine), schlick_seen(x, cosine), x[8]);
}

Vec3 dielectric_seen(const FilmNumbers& x, double cosine) {
  const std::array<double, 3> n{x[3], x[3], x[3]}, k{};
  const Vec3 f = mixed(index_film(n.data(), k.data(), 1, 0, cosine),
                       index_film(n.data(), k.data(), x[4], x[5], cosine), x[6]);
  return {f[0] * x[0], f[1] * x[1], f[2] * x[2]};
}
constexpr std::string_view nodes =
                               "MaterialX 1.39.5, mx_microfacet_specular.glsl (mx_fresnel_airy, two waves)",
                           graph = "MaterialX 1.39.5, open_pbr_surface.mtlx over mx_microfacet_specular.glsl";

}  // namespace

constinit const FilmForm film_form_conductor{
    "conductor_bsdf", "MaterialX conductor_bsdf", nodes, true, false, conductor_numbers, 6, conductor_seen,
    conductor_honest};
constinit const FilmForm film_form_generalized_schlick{"generalized_schlick_bsdf",
                                                       "MaterialX generalized_schlick_bsdf",
                                                       nodes,
                                                       true,
                                                       true,
                                                       schlick_numbers,
                                                       6,
                                                       schlick_seen,
                                                       open_pbr_metal_honest};
constinit const FilmForm film_form_open_pbr_metal{
    "openpbr-metal", "OpenPBR metal in MaterialX", graph, true, false, open_pbr_metal_numbers, 6,
    metal_seen,      open_pbr_metal_honest};
constinit const FilmForm film_form_open_pbr_dielectric{"openpbr-dielectric",
                                                       "OpenPBR dielectric in MaterialX",
                                                       graph,
                                                       false,
                                                       true,
                                                       open_pbr_dielectric_numbers,
                                                       4,
                                                       dielectric_seen,
                                                       open_pbr_dielectric_honest};

}  // namespace etak
