// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/fresnel.h"

#include <algorithm>
#include <cmath>

#include "core/math/functions.h"

// The formula text comes into namespaces of its own, so that the shim's min, sqrt, ... are not seen
// elsewhere.
namespace etak::f64::text {
namespace {
#include "core/math/real_f64.h"

#include "core/fresnel/texts.h"
}  // namespace
}  // namespace etak::f64::text

namespace etak::f32::text {
namespace {
#include "core/math/real_f32.h"

#include "core/fresnel/texts.h"
}  // namespace
}  // namespace etak::f32::text

namespace etak::f64 {
double f0(double n, double k) {
  return text::f0(n, k);
}
double absorptance0(double n, double k) {
  return text::absorptance0(n, k);
}
double fresnel_exact(double n, double k, double c) {
  return text::fresnel_exact(n, k, c);
}
double f_schlick(double f0_value, double c) {
  return text::f_schlick(f0_value, c);
}
double f_f82_tint(double f0_value, double tint, double c) {
  return text::f_f82_tint(f0_value, tint, c);
}
double f_gulbrandsen(double r, double g, double c) {
  return text::f_gulbrandsen(r, g, c);
}
double f0_under(double f0_value, double f82, double n) {
  return text::f0_under(f0_value, f82, n);
}
double f82_under(double f0_value, double f82, double n) {
  return text::f82_under(f0_value, f82, n);
}
double f82_mean(double f0_value, double f82) {
  return text::f82_mean(f0_value, f82);
}

void f0(std::span<const double> n, std::span<const double> k, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = text::f0(n[i], k[i]);
}

void fresnel_exact(std::span<const double> n, std::span<const double> k, double c, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = text::fresnel_exact(n[i], k[i], c);
}
}  // namespace etak::f64

namespace etak::f32 {
float f0(float n, float k) {
  return text::f0(n, k);
}
float absorptance0(float n, float k) {
  return text::absorptance0(n, k);
}
float fresnel_exact(float n, float k, float c) {
  return text::fresnel_exact(n, k, c);
}
float f_schlick(float f0_value, float c) {
  return text::f_schlick(f0_value, c);
}
float f0_under(float f0_value, float f82, float n) {
  return text::f0_under(f0_value, f82, n);
}
float f82_under(float f0_value, float f82, float n) {
  return text::f82_under(f0_value, f82, n);
}
}  // namespace etak::f32

namespace etak {
SolvedIndex solve_index(double f0, double f82) {
  // The F0 of a colour may be above 1 (gold in sRGB). Its F82 is then that of a metal whose F0 is about the same.
  constexpr double largest_f0 = 0.9999, least_of_metals = 0.5;
  if (!(f0 < largest_f0)) {
    f0 = std::clamp(f82, least_of_metals, largest_f0);
    f82 = std::min(f82, f0);
  }
  const f64::text::EdgeIndex found = f64::text::index_of_edge(f0, f82);
  return {found.n, found.k};
}
}  // namespace etak
