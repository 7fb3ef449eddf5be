// SPDX-License-Identifier: Apache-2.0
// The formula text in double over many wavelengths at once: a layer at a time, so that each loop is short enough for the
// compiler to run it in lanes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/clones.h"
#include "core/film/stack.h"
#include "core/math/functions.h"

#define ETAK_POLYNOMIALS_F64

namespace etak {
namespace {

#include "core/math/real_f64.h"

#include "core/film/texts.h"

constexpr std::size_t most = 64;  // wavelengths of a block: all that it holds stays in the nearest cache
using Row = std::array<double, most>;

// Complex numbers at the wavelengths of a block: n and k of a medium, or amplitudes.
struct Numbers {
  Row re, im;

  Complex at(std::size_t i) const { return {re[i], im[i]}; }
  void put(std::size_t i, const Complex& number) {
    re[i] = number.re;
    im[i] = number.im;
  }
  void read(const FilmSpectra::Medium& medium, std::size_t from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) re[i] = medium.n[from + i];
    for (std::size_t i = 0; i < count; ++i) im[i] = medium.k.empty() ? 0 : medium.k[from + i];
  }
};

// Amplitudes of both polarisations; at normal incidence s is both.
struct Amplitudes {
  Numbers s, p;
};

#define ETAK_LANES __attribute__((flatten)) ETAK_CLONES_O3("avx2")

ETAK_LANES void interface_ahead(const Numbers& a, const Numbers& b, Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) r.s.put(i, film_interface_ahead(a.at(i), b.at(i)));
}

ETAK_LANES void layer_ahead(const Numbers& a, const Numbers& b, const Row& turns, Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const Complex back = complex_product(r.s.at(i), film_way_back(b.at(i), turns[i]));
    r.s.put(i, film_seen(film_interface_ahead(a.at(i), b.at(i)), back));
  }
}

ETAK_LANES void interface_at(double c, const Row& outside, const Numbers& a, const Numbers& b,
                             Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const FilmPair seen = film_interface(film_wave(outside[i], c, a.re[i], a.im[i]),
                                         film_wave(outside[i], c, b.re[i], b.im[i]));
    r.s.put(i, seen.s);
    r.p.put(i, seen.p);
  }
}

ETAK_LANES void layer_at(double c, const Row& outside, const Numbers& a, const Numbers& b, const Row& turns,
                         Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const FilmWave layer = film_wave(outside[i], c, b.re[i], b.im[i]);
    const FilmPair upper = film_interface(film_wave(outside[i], c, a.re[i], a.im[i]), layer);
    const FilmPair seen =
        film_seen(upper, film_back({r.s.at(i), r.p.at(i)}, film_way_back(layer.s, turns[i])));
    r.s.put(i, seen.s);
    r.p.put(i, seen.p);
  }
}

// The reflectance of coherent layers at a cosine above 0.
void film_lanes(const FilmSpectra& film, double cosine, std::span<double> out) {
  Numbers above{}, below{};
  Amplitudes r{};
  above.re.fill(1);
  below.re.fill(1);
  Row outside{}, turns{};
  outside.fill(1);
  for (std::size_t from = 0; from < out.size(); from += most) {
    const std::size_t count = std::min(most, out.size() - from);
    std::copy_n(film.outside.begin() + static_cast<std::ptrdiff_t>(from), count, outside.begin());
    below.read(film.base, from, count);
    for (std::size_t j = film.layers.size() + 1; j-- > 0;) {
      // Medium j lies above `below`: layer j of the list, or the outside.
      if (j > 0)
        above.read(film.layers[j - 1].medium, from, count);
      else
        above.read({film.outside.subspan(from, count), {}}, 0, count);
      const bool at_base = j == film.layers.size();
      if (!at_base)
        for (std::size_t i = 0; i < count; ++i)
          turns[i] = 2 * std::numbers::pi * film.layers[j].thickness_nm / film.wavelength_nm[from + i];
      if (cosine == 1)
        at_base ? interface_ahead(above, below, r) : layer_ahead(above, below, turns, r);
      else
        at_base ? interface_at(cosine, outside, above, below, r)
                : layer_at(cosine, outside, above, below, turns, r);
      std::swap(above, below);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double s = complex_square(r.s.at(i));
      const Complex p = r.p.at(i);
      out[from + i] = cosine == 1 ? s : (s + p.re * p.re + p.im * p.im) / 2;
    }
  }
}

}  // namespace

void film_reflectance(const FilmSpectra& film, double cosine, std::span<double> out) {
  if (cosine > 0 && std::ranges::all_of(film.layers, &FilmSpectra::Layer::coherent))
    return film_lanes(film, cosine, out);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = film_light(film_at(film, i), film.wavelength_nm[i], cosine).reflected.mean();
}

}  // namespace etak
