// SPDX-License-Identifier: Apache-2.0
// The formula text in double over many wavelengths at once: a layer at a time, so that each loop is short enough for the
// compiler to run it in lanes.
#include "core/film/stack_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/clones.h"

#define ETAK_POLYNOMIALS_F64

namespace etak {
namespace {

#include "core/math/real_f64.h"

#include "core/film/texts.h"

constexpr std::size_t most = 64;  // wavelengths of a block: all that it holds stays in the nearest cache
using Row = std::array<double, most>;

// n and k of a medium at the wavelengths of a block.
struct Block {
  Row n, k;

  void read(const FilmSpectra::Medium& medium, std::size_t from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) n[i] = medium.n[from + i];
    for (std::size_t i = 0; i < count; ++i) k[i] = medium.k.empty() ? 0 : medium.k[from + i];
  }
};

struct Amplitudes {
  Row s_re, s_im, p_re, p_im;
};

#define ETAK_LANES __attribute__((flatten)) ETAK_CLONES_O3("avx2")

ETAK_LANES void interface_ahead(const Block& a, const Block& b, Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const Complex s = film_interface_ahead({a.n[i], a.k[i]}, {b.n[i], b.k[i]});
    r.s_re[i] = s.re;
    r.s_im[i] = s.im;
  }
}

ETAK_LANES void layer_ahead(const Block& a, const Block& b, const Row& turns, Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const Complex layer{b.n[i], b.k[i]}, upper = film_interface_ahead({a.n[i], a.k[i]}, layer);
    const Complex below{r.s_re[i], r.s_im[i]};
    const Complex s = film_joined(upper, below, film_way_back(layer, turns[i]));
    r.s_re[i] = s.re;
    r.s_im[i] = s.im;
  }
}

ETAK_LANES void interface_at(double c, const Row& outside, const Block& a, const Block& b, Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const FilmPair f =
        film_interface(film_wave(outside[i], c, a.n[i], a.k[i]), film_wave(outside[i], c, b.n[i], b.k[i]));
    r.s_re[i] = f.s.re;
    r.s_im[i] = f.s.im;
    r.p_re[i] = f.p.re;
    r.p_im[i] = f.p.im;
  }
}

ETAK_LANES void layer_at(double c, const Row& outside, const Block& a, const Block& b, const Row& turns,
                         Amplitudes& r) {
  for (std::size_t i = 0; i < most; ++i) {
    const FilmWave layer = film_wave(outside[i], c, b.n[i], b.k[i]);
    const FilmPair upper = film_interface(film_wave(outside[i], c, a.n[i], a.k[i]), layer);
    const Complex way = film_way_back(layer.s, turns[i]);
    const Complex s = film_joined(upper.s, {r.s_re[i], r.s_im[i]}, way);
    const Complex p = film_joined(upper.p, {r.p_re[i], r.p_im[i]}, way);
    r.s_re[i] = s.re;
    r.s_im[i] = s.im;
    r.p_re[i] = p.re;
    r.p_im[i] = p.im;
  }
}

}  // namespace

void film_lanes(const FilmSpectra& film, double cosine, std::span<double> out) {
  Block above{}, below{};
  above.n.fill(1);
  below.n.fill(1);
  Row outside{}, turns{};
  outside.fill(1);
  Amplitudes r{};
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
      const double s = r.s_re[i] * r.s_re[i] + r.s_im[i] * r.s_im[i];
      out[from + i] = cosine == 1 ? s : (s + r.p_re[i] * r.p_re[i] + r.p_im[i] * r.p_im[i]) / 2;
    }
  }
}

}  // namespace etak
