// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

/// n and k of one colour channel, found from two reflectances.
struct SolvedIndex {
  double n = 1, k = 0;
};

/// The n and k that reflect f0 at normal incidence and f82 at cos 1/7: one channel's stand-in for a spectrum.
///   f0           at or above 1 no n and k give it: then the nearest that a metal of this f82 has
///   f82          where none gives both, f0 is kept and f82 missed by as little as can be
///   log_n_hint   where two n do, the one whose logarithm is nearest to this is taken
///   error        what is missed is for the caller to compute: f64::f0 and f64::fresnel_exact of the result
///   from         Gulbrandsen 2014, "Artist Friendly Metallic Fresnel": for one reflectance r the possible n
///   lie
///                between (1 - r)/(1 + r) and (1 + sqrt r)/(1 - sqrt r), and each has its k
SolvedIndex solve_index(double f0, double f82, double log_n_hint);

}  // namespace etak
