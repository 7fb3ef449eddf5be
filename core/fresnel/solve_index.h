// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

/// n and k of one colour channel, found from two reflectances.
struct SolvedIndex {
  double n = 1, k = 0;
};

/// The n and k that reflect f0 at normal incidence and f82 at cos 1/7: one channel's stand-in for a spectrum.
///   f0           no n and k give an f0 of 1 or more: it is then replaced by the nearest one that a metal of
///                this f82 has
///   f82          where no n and k give both, f0 is kept and f82 is missed by as little as possible
///   log_n_hint   where two n give both, the one whose logarithm is nearest to this is taken
///   error        the caller computes what is missed, from f64::f0 and f64::fresnel_exact of the result
///   from         Gulbrandsen 2014, "Artist Friendly Metallic Fresnel": for one reflectance r the possible n
///                lie between (1 - r)/(1 + r) and (1 + sqrt r)/(1 - sqrt r), and each has its k
SolvedIndex solve_index(double f0, double f82, double log_n_hint);

}  // namespace etak
