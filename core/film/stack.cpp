// SPDX-License-Identifier: Apache-2.0
#include "core/film/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/film/stack_lanes.h"

namespace etak {
namespace {

namespace text {
#include "core/math/real_f64.h"

#include "core/film/texts.h"
}  // namespace text

using text::Complex;
using text::FilmPair;
using text::FilmWave;

// What coherent layers between two media do to waves of one polarisation that come from above and from below.
struct Run {
  double above, below;  // reflectances
  double through;       // the square of the amplitude from the upper to the lower side
  double both_ways;     // that of the amplitudes through and back
};

double squared(const Complex& z) {
  return complex_square(z);
}

// The waves from the medium above some layers to the one below.
struct Waves {
  std::vector<FilmWave> waves;
  std::vector<double> turns;  // of the layers between
};

// The amplitudes that coherent layers reflect and let pass of light from the first medium. Amplitudes that pass are those
// of the field that the polarisation's N cos or cos / N belongs to, so that T = Re(last) / Re(first) times the square.
std::pair<FilmPair, FilmPair> amplitudes(const Waves& all, bool reversed) {
  const std::size_t last = all.waves.size() - 1;
  const auto wave = [&](std::size_t i) -> const FilmWave& { return all.waves[reversed ? last - i : i]; };
  const auto passing = [](const Complex& a, const Complex& b) {
    return complex_quotient({2 * a.re, 2 * a.im}, complex_sum(a, b));
  };
  FilmPair r = film_interface(wave(last - 1), wave(last));
  FilmPair t{passing(wave(last - 1).s, wave(last).s), passing(wave(last - 1).p, wave(last).p)};
  for (std::size_t j = last - 1; j > 0; --j) {
    const FilmWave& layer = wave(j);
    const double turns = all.turns[reversed ? last - 1 - j : j - 1];
    const Complex way = film_way_back(layer, turns), once = film_way_back(layer, turns / 2);
    const FilmPair upper = film_interface(wave(j - 1), layer);
    const auto pass = [&](const Complex& from, const Complex& to, const Complex& above, const Complex& below,
                          const Complex& next) {
      Complex under = complex_product(above, complex_product(below, way));
      under.re += 1;
      return complex_quotient(complex_product(complex_product(passing(from, to), next), once), under);
    };
    t = {pass(wave(j - 1).s, layer.s, upper.s, r.s, t.s), pass(wave(j - 1).p, layer.p, upper.p, r.p, t.p)};
    r = film_layer(upper, r, way);
  }
  return {r, t};
}

struct Runs {
  Run s, p;
};

Runs run_of(const Waves& waves) {
  const auto [down, through] = amplitudes(waves, false);
  const auto [up, back] = amplitudes(waves, true);
  const auto run = [](const Complex& above, const Complex& below, const Complex& t, const Complex& t_back) {
    return Run{squared(above), squared(below), squared(t), squared(t) * squared(t_back)};
  };
  return {run(down.s, up.s, through.s, back.s), run(down.p, up.p, through.p, back.p)};
}

// Reflectance, and the share through but for the ratio of the outermost media, of a run above a thick layer.
//   below   of what lies beneath that layer
//   keeps   the share of light that the layer leaves on one way
struct Intensity {
  double reflected, through;
};

Intensity over_thick(const Run& run, const Intensity& below, double keeps) {
  const double back = below.reflected * keeps * keeps;
  // What the run does not send down again is at least what it lets pass. Where that is nearly nothing the difference has
  // lost it.
  const double leaves = std::max({1 - run.below * back, std::sqrt(run.both_ways), 1e-300});
  return {run.above + run.both_ways * back / leaves, run.through * keeps * below.through / leaves};
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
  const auto turns_of = [&](const FilmLayer& layer) {
    return 2 * std::numbers::pi * layer.thickness_nm / wavelength_nm;
  };
  const FilmWave base = wave_in(film.base), outside = wave_in({film.outside, 0});
  // From the base up, a run of coherent layers at a time.
  Intensity s{0, 1}, p{0, 1};
  double keeps = 0;  // of the thick layer below the run
  bool on_base = true;
  Waves run{{base}, {}};
  const auto finish = [&] {
    std::reverse(run.waves.begin(), run.waves.end());
    std::reverse(run.turns.begin(), run.turns.end());
    const Runs both = run_of(run);
    s = on_base ? Intensity{both.s.above, both.s.through} : over_thick(both.s, s, keeps);
    p = on_base ? Intensity{both.p.above, both.p.through} : over_thick(both.p, p, keeps);
  };
  for (std::size_t i = film.layers.size(); i-- > 0;) {
    const FilmLayer& layer = film.layers[i];
    const FilmWave wave = wave_in(layer.medium);
    run.waves.push_back(wave);
    // A wave that decays more than it turns has no phase that could get out of step.
    if (layer.coherent || wave.s.im > wave.s.re) {
      run.turns.push_back(turns_of(layer));
      continue;
    }
    finish();
    on_base = false;
    keeps = std::exp(-2 * turns_of(layer) * wave.s.im);
    run = {{wave}, {}};
  }
  run.waves.push_back(outside);
  finish();
  return {{s.reflected, p.reflected},
          {base.s.re / outside.s.re * s.through, base.p.re / outside.p.re * p.through}};
}

void film_reflectance(const FilmSpectra& film, double cosine, std::span<double> out) {
  bool coherent = true;
  for (const FilmSpectra::Layer& layer : film.layers) coherent = coherent && layer.coherent;
  if (coherent && cosine > 0) return film_lanes(film, cosine, out);
  const auto medium = [](const FilmSpectra::Medium& m, std::size_t i) {
    return FilmMedium{m.n[i], m.k.empty() ? 0 : m.k[i]};
  };
  Film one;
  for (const FilmSpectra::Layer& layer : film.layers)
    one.layers.push_back({{}, layer.thickness_nm, layer.coherent});
  for (std::size_t i = 0; i < out.size(); ++i) {
    one.outside = film.outside[i];
    for (std::size_t j = 0; j < film.layers.size(); ++j)
      one.layers[j].medium = medium(film.layers[j].medium, i);
    one.base = medium(film.base, i);
    out[i] = film_light(one, film.wavelength_nm[i], cosine).reflected.mean();
  }
}

}  // namespace etak
