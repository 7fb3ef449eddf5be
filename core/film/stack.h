// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace etak {

// Exact reflectance of homogeneous, flat layers on a base under a medium that does not absorb, at one wavelength
// (Film) or over a spectrum (FilmSpectra). The formulas are in stack.glsl.

/// Layers on a base, numbered from the outside.
///   Number    of one wavelength, or a span with one for each
///   outside   index of the medium in front, above 0
template <class Number>
struct LayersOn {
  /// n + i k, absolute and not relative to the outside: n in [0, 1e4], k in [0, 1e6], not both 0.
  struct Medium {
    Number n{}, k{};
  };
  ///   thickness_nm   finite, 0 and above
  ///   coherent       whether light that is reflected at its two sides interferes. A layer that is thicker than the light
  ///                  stays in step (a pane, a coat of varnish) shows no interference: its intensities are added
  struct Layer {
    Medium medium;
    double thickness_nm = 0;
    bool coherent = true;
  };
  Number outside{};
  std::vector<Layer> layers;
  Medium base;
};

using Film = LayersOn<double>;
using FilmMedium = Film::Medium;
using FilmLayer = Film::Layer;

/// Shares of light that is polarised across (s) and along (p) the plane of incidence.
struct FilmShares {
  double s = 0, p = 0;
  double mean() const { return (s + p) / 2; }
};

/// Reflectance, and transmittance into the base (through its surface; of a base that absorbs that is what it takes in).
struct FilmLight {
  FilmShares reflected, passed;
};

/// Throws Error (naming `place` and the layer, the outermost being layer 1) for numbers outside of the stated ranges.
void validate(const Film& film, std::string_view place);

/// The light that a film reflects and lets pass. At grazing incidence (cosine 0) it reflects everything.
///   wavelength_nm   in vacuum, above 0
///   cosine          of incidence in the outside medium, [0, 1]
///   error           with coherent layers of up to 10 um in all: 1e-11 relative where the reflectance is at least 1e-4,
///                   below 1e-15 absolute; thicker: 1e-15 (1 + 2 pi |N| d / wavelength, summed over the layers)
FilmLight film_light(const Film& film, double wavelength_nm, double cosine);

/// A film over a spectrum: arrays of one length, but that an empty k is 0 everywhere.
struct FilmSpectra : LayersOn<std::span<const double>> {
  std::span<const double> wavelength_nm;
};

/// The film at the wavelength of that index.
Film film_at(const FilmSpectra& film, std::size_t index);

/// Unpolarised reflectance at each wavelength, in vector lanes where all layers are coherent. The numbers are those of
/// film_light() but for rounding. Values are not checked.
void film_reflectance(const FilmSpectra& film, double cosine, std::span<double> out);

}  // namespace etak
