// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/film/stack.h"
#include "core/material/f0.h"
#include "core/material/f0/f0_data.h"
#include "core/math/mat3.h"

// The steps from optics to F0, for f0.cpp: each takes what a solver fixed of its options, and data.
namespace etak {

/// Linear values in the chosen space and in sRGB of a weighted sum.
struct ColourSpaces {
  Xyz white;  // under the illuminant
  Mat3 to_space, to_srgb, from_srgb;
  LinearRgb space_white{1, 1, 1};
};

/// What a solver computes once, of its options alone.
struct F0Setup {
  F0Options options;
  WeightSums sums;
  Quadrature quadrature;        // of every method but exact and automatic
  ColourSpaces spaces;          // of every method but exact
  std::vector<double> outside;  // n of the outside medium at the quadrature's wavelengths; empty: constant
  double outside_n = 1;
  Flags outside_flags;

  bool exact() const { return options.method == Method::exact; }
  bool needs_knots() const { return exact() || options.method == Method::automatic; }
};

/// Throws Error as the constructor of F0Solver does.
F0Setup f0_setup(F0Options options);

/// Why data of that range have no colour; empty: they have.
std::string coverage_refusal(const F0Setup& setup, Range range, const Coverage& coverage);

/// Room for the spectra of one thread: kept between calls, so that a database run allocates once.
struct F0Spectra {
  std::vector<double> n, k, r0, r82, mean;
  void resize(std::size_t count, bool with_f82 = true, bool with_mean = false) {
    for (auto* v : {&n, &k, &r0}) v->resize(count);
    r82.resize(with_f82 ? count : 0);
    mean.resize(with_mean ? count : 0);
  }
};

/// n of `optics` at the nodes of `q` into `out`, which has their size.
void index_at(const F0Setup& setup, const OpticalConstants& optics, const Quadrature& q,
              std::span<double> out);

/// Optics that are no reflectance as a stack: a bare medium is one without layers.
Stack stack_of(const Optics& optics);

/// n and k of a stack's media at the nodes of a quadrature, and n of the outside.
struct StackSpectra {
  std::vector<std::vector<double>> n, k;
  std::vector<double> outside;
  FilmSpectra film;  // views into these and the quadrature
};

/// Returns why the data do not allow it; empty: they do.
std::string stack_spectra(const F0Setup& setup, const Stack& stack, const Quadrature& q, StackSpectra& out);

/// The mean reflectance over the cone of an aperture, s and p, uniform in the squared sine, at the nodes of `q`.
/// Returns why the data do not allow it; empty: they do.
///   aperture   above 0; of the index outside and more: the whole hemisphere
std::string cone_mean(const F0Setup& setup, const Optics& optics, const Quadrature& q, double aperture,
                      std::span<double> out);

/// Reflectance at the nodes of `q` into `room`, which has their size, as the options' instrument has it: r0 at normal
/// incidence or over the cone of the aperture and, of all but reflectance, r82 at cos 1/7 without an aperture, and the mean
/// over a hemisphere where the options ask for it.
///   room      with an empty r82 or mean none is computed
///   returns   why the data do not allow it; empty: they do
std::string reflectance_at(const F0Setup& setup, const Optics& optics, const Quadrature& q, F0Spectra& room,
                           Stopwatch& watch, F0Timing& timing);

ColourSpaces colour_spaces(const F0Options& options, const Quadrature& q);

/// `result` with the colours of reflectances at the nodes of `q`: all of F0Result from xyz to gamut_excess,
/// and the flags of gamut and zone.
///   r82   empty: no F82
F0Result with_colour(F0Result result, const F0Options& options, const Quadrature& q,
                     const ColourSpaces& spaces, std::span<const double> r0, std::span<const double> r82);

}  // namespace etak
