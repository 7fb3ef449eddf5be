// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/fresnel/fresnel.h"
#include "core/iridescence/forms/rows.h"
#include "core/math/functions.h"

// OpenPBR as Adobe's own implementation has it, which other renderers take over. Unlike MaterialX's graph it takes the exact
// reflectance of one film at three wavelengths, on a metal by Gulbrandsen's n and k. Their edge tint is set to F82's tint,
// though the two are different scales: F82 of gold's red, 1, becomes the edge of the darkest n.

namespace etak {
namespace {

using Complex = std::complex<double>;

constexpr Vec3 adobe_nm{620, 540, 450};

// Those of <complex> differ between libraries in the last digits.
Complex quotient(const Complex& a, const Complex& b) {
  return a * std::conj(b) / std::norm(b);
}
Complex root(const Complex& z) {
  const double size = math::hypot(z.real(), z.imag());
  const double large = std::sqrt((size + std::abs(z.real())) / 2);
  const double small = large == 0 ? 0 : std::abs(z.imag()) / (2 * large);
  return {z.real() < 0 ? small : large, std::copysign(z.real() < 0 ? large : small, z.imag())};
}

// One film of a real index of at least 1 in air, on a base of any index: the mean of s and p (Airy's sum).
double adobe_airy(const Complex& base, double film, double thickness_nm, double nm, double cosine) {
  const double sine2 = 1 - cosine * cosine, inside = std::sqrt(std::max(1 - sine2 / (film * film), 0.0));
  Complex under = root(1.0 - quotient(sine2, base * base));
  if ((base * under).imag() < 0) under = -under;
  const double angle = 4 * std::numbers::pi * film * thickness_nm * inside / nm;
  const Complex turn{math::cos(angle), math::sin(angle)};
  const auto seen = [&](double outer, const Complex& inner) {
    return std::norm(outer + inner * turn) / std::norm(1.0 + outer * inner * turn);
  };
  return (seen((cosine - film * inside) / (cosine + film * inside),
               quotient(film * inside - base * under, film * inside + base * under)) +
          seen((film * cosine - inside) / (film * cosine + inside),
               quotient(base * inside - film * under, base * inside + film * under))) /
         2;
}

// Gulbrandsen 2014.
Complex adobe_metal_index(double f0, double tint) {
  const double r = std::clamp(f0, 0.0, 0.99), root = std::sqrt(r);
  const double most = (1 + root) / (1 - root), n = most + ((1 - r) / (1 + r) - most) * tint;
  return {n, std::sqrt(std::max((r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r), 0.0))};
}

// The film comes in from 0 to 30 nm.
double adobe_presence(double weight, double thickness_nm) {
  const double t = std::clamp(thickness_nm / 30, 0.0, 1.0);
  return weight * t * t * (3 - 2 * t);
}

Vec3 adobe_metal_seen(const FilmNumbers& x, double cosine) {
  const double presence = adobe_presence(x[8], x[7]);
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double bare = std::clamp(f64::f_f82_tint(x[c], x[c + 3], cosine), 0.0, 1.0);
    const double film = adobe_airy(adobe_metal_index(x[c], x[c + 3]), x[6], x[7], adobe_nm[c], cosine);
    out[c] = bare + (film - bare) * presence;
  }
  return out;
}

Vec3 adobe_dielectric_seen(const FilmNumbers& x, double cosine) {
  const double presence = adobe_presence(x[6], x[5]), bare = f64::fresnel_exact(x[3], 0, cosine);
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = x[c] * (bare + (adobe_airy(x[3], x[4], x[5], adobe_nm[c], cosine) - bare) * presence);
  return out;
}

constexpr std::string_view adobe =
    "Adobe, openpbr-bsdf of 2026-08-04 (a29da969), openpbr_thin_film_iridescence_utils.h, with its base wavelengths";

}  // namespace

constinit const FilmForm film_form_adobe_metal{
    "openpbr-adobe-metal", "OpenPBR metal by Adobe", adobe, true, false, open_pbr_metal_numbers, 6,
    adobe_metal_seen,      open_pbr_metal_honest};
constinit const FilmForm film_form_adobe_dielectric{"openpbr-adobe-dielectric",
                                                    "OpenPBR dielectric by Adobe",
                                                    adobe,
                                                    false,
                                                    true,
                                                    open_pbr_dielectric_numbers,
                                                    4,
                                                    adobe_dielectric_seen,
                                                    open_pbr_dielectric_honest};

}  // namespace etak
