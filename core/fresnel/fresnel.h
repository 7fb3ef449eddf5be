// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace etak {

/// The cosine at which edge reflectance is stated: 1/7, 81.8 degrees, where (1/7)(6/7)^6 of Hoffman's F82
/// term peaks.
inline constexpr double f82_cosine = 1.0 / 7;

/// The formulas of conductor.glsl, schlick.glsl, f82.glsl, gulbrandsen.glsl and under_coat.glsl in double: the reference.
namespace f64 {
double f0(double n, double k);
double absorptance0(double n, double k);
double fresnel_exact(double n, double k, double c);
double f_schlick(double f0_value, double c);
double f_f82_tint(double f0_value, double tint, double c);
double f_gulbrandsen(double r, double g, double c);
double f0_under(double f0_value, double f82, double n);
double f82_under(double f0_value, double f82, double n);
double f82_mean(double f0_value, double f82);

/// The formulas over arrays of one length; out may not overlap the inputs.
void f0(std::span<const double> n, std::span<const double> k, std::span<double> out);
void fresnel_exact(std::span<const double> n, std::span<const double> k, double c, std::span<double> out);
}  // namespace f64

/// The formula text in float: what a GPU gets.
namespace f32 {
float f0(float n, float k);
float absorptance0(float n, float k);
float fresnel_exact(float n, float k, float c);
float f_schlick(float f0_value, float c);
float f0_under(float f0_value, float f82, float n);
float f82_under(float f0_value, float f82, float n);
}  // namespace f32

/// n and k of one colour channel, found from two reflectances.
struct SolvedIndex {
  double n = 1, k = 0;
};

/// The n and k that reflect f0 at normal incidence and f82 at cos 1/7: one channel's stand-in for a spectrum. There is
/// one such pair (index_of_edge in under_coat.glsl).
///   f0      no n and k give an f0 of 1 or more: it is then replaced by the nearest one that a metal of this f82 has
///   f82     where no n and k give both, f0 is kept and f82 is missed by as little as possible
///   error   1e-9 of f82 for f0 of at least 0.02; the caller computes what is missed, from f64::f0 and f64::fresnel_exact
///           of the result
SolvedIndex solve_index(double f0, double f82);

}  // namespace etak
