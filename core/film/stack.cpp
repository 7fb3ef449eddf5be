// SPDX-License-Identifier: Apache-2.0
#include "core/film/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/math/functions.h"

namespace etak {
namespace {

namespace text {
#include "core/math/real_f64.h"

#include "core/film/texts.h"
}  // namespace text

using text::Complex;
using text::FilmPair;
using text::FilmWave;

// The waves from the medium above some layers to the one below.
struct Waves {
  std::vector<FilmWave> waves;
  std::vector<double> turns;  // of the layers between
};

// The amplitudes that coherent layers reflect and let pass of light from the first medium. Amplitudes that pass are those
// of the field that the polarisation's N cos or cos / N belongs to, so that T = Re(last) / Re(first) times the square.
std::pair<FilmPair, FilmPair> amplitudes(const Waves& all) {
  const std::vector<FilmWave>& wave = all.waves;
  const std::size_t last = wave.size() - 1;
  const auto passing = [](const Complex& a, const Complex& b) {
    return complex_quotient({2 * a.re, 2 * a.im}, complex_sum(a, b));
  };
  FilmPair r = film_interface(wave[last - 1], wave[last]);
  FilmPair t{passing(wave[last - 1].s, wave[last].s), passing(wave[last - 1].p, wave[last].p)};
  for (std::size_t j = last - 1; j > 0; --j) {
    const FilmWave& layer = wave[j];
    const double turns = all.turns[j - 1];
    const Complex way = film_way_back(layer.s, turns), once = film_way_back(layer.s, turns / 2);
    const FilmPair upper = film_interface(wave[j - 1], layer);
    const FilmPair back = film_back(r, way);
    const auto pass = [&](const Complex& entering, const Complex& above, const Complex& from_below,
                          const Complex& next) {
      Complex under = complex_product(above, from_below);
      under.re += 1;
      return complex_quotient(complex_product(complex_product(entering, next), once), under);
    };
    t = {pass(passing(wave[j - 1].s, layer.s), upper.s, back.s, t.s),
         pass(passing(wave[j - 1].p, layer.p), upper.p, back.p, t.p)};
    r = film_seen(upper, back);
  }
  return {r, t};
}

// Intensities at the upper side of some layers.
//   reflected   a share of light
//   through     the squared amplitude that passes to the base; times Re(base) / Re(above) it is a share
struct Intensity {
  double reflected, through;
};

// Coherent layers above a thick one, for one polarisation.
//   r, t         amplitudes that they reflect and let pass of light from above
//   r_up, t_up   amplitudes of light from below
//   below        of what lies beneath the thick layer
//   keeps        the share of light that the thick layer leaves on one way
Intensity over_thick(const Complex& r, const Complex& t, const Complex& r_up, const Complex& t_up,
                     const Intensity& below, double keeps) {
  const double back = below.reflected * keeps * keeps;
  const double through = complex_square(t), both_ways = through * complex_square(t_up);
  // The share that the layers do not send down again is at least the one that they let pass. Where nearly nothing passes,
  // the difference from 1 has lost it by rounding.
  const double leaves = std::max({1 - complex_square(r_up) * back, std::sqrt(both_ways), 1e-300});
  return {complex_square(r) + both_ways * back / leaves, through * keeps * below.through / leaves};
}

std::string layer_name(std::string_view place, std::size_t i) {
  return std::string(place) + " layer " + std::to_string(i + 1);
}

void check(const FilmMedium& medium, const std::string& place) {
  if (!(medium.n >= 0 && medium.n <= 1e4)) throw Error::at(place, "n " + number(medium.n, 6), "0 to 1e4");
  if (!(medium.k >= 0 && medium.k <= 1e6)) throw Error::at(place, "k " + number(medium.k, 6), "0 to 1e6");
  if (medium.n == 0 && medium.k == 0) throw Error::at(place, "n = k = 0", "n above 0, or k above 0");
}

}  // namespace

void validate(const Film& film, std::string_view place) {
  if (!(film.outside > 0 && film.outside <= 1e4))
    throw Error::at(std::string(place) + " outside medium", "n " + number(film.outside, 6),
                    "above 0, at most 1e4");
  for (std::size_t i = 0; i < film.layers.size(); ++i) {
    check(film.layers[i].medium, layer_name(place, i));
    if (const double d = film.layers[i].thickness_nm; !(d >= 0 && std::isfinite(d)))
      throw Error::at(layer_name(place, i), "thickness " + number(d, 6) + " nm",
                      "a finite one of at least 0");
  }
  check(film.base, std::string(place) + " base");
}

FilmLight film_light(const Film& film, double wavelength_nm, double cosine) {
  if (cosine == 0) return {{1, 1}, {0, 0}};
  const auto wave_in = [&](const FilmMedium& m) { return text::film_wave(film.outside, cosine, m.n, m.k); };
  const FilmWave base = wave_in(film.base), outside = wave_in({film.outside, 0});
  // From the base up, a run of coherent layers at a time.
  Intensity s{0, 1}, p{0, 1};
  double keeps = 0;  // of the thick layer below the run
  bool on_base = true;
  Waves run{{base}, {}};
  const auto finish = [&] {
    const auto [r_up, t_up] = on_base ? std::pair<FilmPair, FilmPair>() : amplitudes(run);
    std::reverse(run.waves.begin(), run.waves.end());
    std::reverse(run.turns.begin(), run.turns.end());
    const auto [r, t] = amplitudes(run);
    if (on_base) {
      s = {complex_square(r.s), complex_square(t.s)};
      p = {complex_square(r.p), complex_square(t.p)};
      return;
    }
    s = over_thick(r.s, t.s, r_up.s, t_up.s, s, keeps);
    p = over_thick(r.p, t.p, r_up.p, t_up.p, p, keeps);
  };
  for (std::size_t i = film.layers.size(); i-- > 0;) {
    const FilmLayer& layer = film.layers[i];
    const FilmWave wave = wave_in(layer.medium);
    const double turns = 2 * std::numbers::pi * layer.thickness_nm / wavelength_nm;
    run.waves.push_back(wave);
    // A wave that decays more than it turns has no phase that could get out of step.
    if (layer.coherent || wave.s.im > wave.s.re) {
      run.turns.push_back(turns);
      continue;
    }
    finish();
    on_base = false;
    keeps = math::exp(-2 * turns * wave.s.im);
    run = {{wave}, {}};
  }
  run.waves.push_back(outside);
  finish();
  return {{s.reflected, p.reflected},
          {base.s.re / outside.s.re * s.through, base.p.re / outside.p.re * p.through}};
}

Film film_at(const FilmSpectra& film, std::size_t index) {
  const auto medium = [&](const FilmSpectra::Medium& m) {
    return FilmMedium{m.n[index], m.k.empty() ? 0 : m.k[index]};
  };
  Film out{film.outside[index], {}, medium(film.base)};
  for (const FilmSpectra::Layer& layer : film.layers)
    out.layers.push_back({medium(layer.medium), layer.thickness_nm, layer.coherent});
  return out;
}

}  // namespace etak
