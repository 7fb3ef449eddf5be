// SPDX-License-Identifier: Apache-2.0
// Means of the reflectance over a cone of directions.
#include <algorithm>
#include <cmath>

#include "core/film/stack.h"
#include "core/material/f0/f0_steps.h"
#include "core/math/quadrature.h"

namespace etak {
namespace {

constexpr double most_pieces = 1000;

// The wavelengths from `begin` to `end` of a film.
FilmSpectra part_of(FilmSpectra film, std::size_t begin, std::size_t end) {
  const auto cut = [&](std::span<const double>& values) {
    if (!values.empty()) values = values.subspan(begin, end - begin);
  };
  for (std::span<const double>* values : {&film.wavelength_nm, &film.outside, &film.base.n, &film.base.k})
    cut(*values);
  for (FilmSpectra::Layer& layer : film.layers) {
    cut(layer.medium.n);
    cut(layer.medium.k);
  }
  return film;
}

// For a film whose cone is the same at all wavelengths: the integral of 2 c R over the cosines from `least` to 1, divided by that of
// 2 c, by 16 points for each fringe: of these a coherent layer has 2 d (1 - least) / wavelength at most in air, and not many
// more in another medium.
void mean_from(const FilmSpectra& film, double least, std::span<double> out) {
  static const GaussLegendre<16> rule;
  double fringes = 0;
  for (const FilmSpectra::Layer& layer : film.layers)
    if (layer.coherent) fringes += 2 * layer.thickness_nm * (1 - least) / film.wavelength_nm.front();
  const int pieces = 1 + static_cast<int>(std::min(fringes, most_pieces));
  const double half = (1 - least) / (2 * pieces);
  std::vector<double> one(out.size());
  std::fill(out.begin(), out.end(), 0.0);
  for (int piece = 0; piece < pieces; ++piece)
    for (std::size_t node = 0; node < rule.node.size(); ++node) {
      const double cosine = least + half * (2 * piece + 1 + rule.node[node]);
      film_reflectance(film, cosine, one);
      const double weight = rule.weight[node] * half * 2 * cosine / (1 - least * least);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * one[i];
    }
}

}  // namespace

std::string cone_mean(const F0Setup& setup, const Optics& optics, const Quadrature& q, double aperture,
                      std::span<double> out) {
  if (std::holds_alternative<Reflectance>(optics))
    return "reflectance at normal incidence tells nothing of the cone of an aperture";
  StackSpectra spectra;
  if (std::string why = stack_spectra(setup, stack_of(optics), q, spectra); !why.empty()) return why;
  const FilmSpectra& film = spectra.film;
  // An aperture is the sine of the cone times the index outside. All directions are a cone that no index changes.
  const auto sine_at = [&](std::size_t i) { return std::min(aperture / film.outside[i], 1.0); };
  for (std::size_t begin = 0, end = 0; begin < out.size(); begin = end) {
    const double sine = sine_at(begin);
    while (end < out.size() && sine_at(end) == sine) ++end;
    mean_from(part_of(film, begin, end), std::sqrt(1 - sine * sine), out.subspan(begin, end - begin));
  }
  return {};
}

}  // namespace etak
