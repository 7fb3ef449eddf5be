// SPDX-License-Identifier: Apache-2.0
// Functions of `etak eval`: the reflectance of interfaces, and its approximations.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/brdf/integrals/albedo.h"
#include "core/light/function_rows.h"
#include "core/math/functions.h"
#include "core/math/quadrature.h"

namespace etak::function_rows {
namespace {

#include "core/light/formulas_f64.h"

using In = const double*;

// n = 1 with k = 0 is allowed: it reflects nothing. n = 0 with k > 0 is a metal without loss; medium()
// refuses n and k that are both 0.
constexpr FunctionInput n_k[] = {n, k};
constexpr FunctionInput n_k_cos[] = {n, k, cosine};
constexpr FunctionInput pair[] = {{"n1", "index on the light's side", "", 0, 1e4, true},
                                  {"n2", "index beyond", "", 0, 1e4, true},
                                  {"theta_deg", "angle of incidence", "deg", 0, 90}};
constexpr FunctionInput f0_cos[] = {f0, cosine};
constexpr FunctionInput schueler_inputs[] = {K, {"t", "cosine; taken as 0 below 0", "", -1, 1}};
constexpr FunctionInput edge{"f82", "reflectance at cosine 1/7", "", -10, 10};
constexpr FunctionInput f82_inputs[] = {f0, edge, cosine};
constexpr FunctionInput f0_f82[] = {f0, edge};
constexpr FunctionInput f0_f82_coat[] = {
    f0, edge, {"coat", "index of the coat against the outside", "", 0, 1e4, true}};
constexpr FunctionInput tint_inputs[] = {
    f0, {"tint", "share of Schlick's value at cosine 1/7", "", 0, 1}, cosine};
constexpr FunctionInput lazanyi_inputs[] = {n,
                                            k,
                                            cosine,
                                            {"a", "depth of the dip, fitted", "", -1e6, 1e6},
                                            {"alpha", "exponent of the dip, fitted", "", 0, 1e6, true}};
constexpr FunctionInput r_g[] = {
    {"r", "reflectance at normal incidence; taken as at most 1 - 1e-12", "", 0, 10},
    {"g", "edge tint", "", 0, 1}};
constexpr std::string_view approximations[] = {"schlick", "schueler_F", "f82"};
constexpr FunctionInput error_inputs[] = {
    {"model", "approximation, given its F0 (and F82)", "", 0, 2, false, approximations},
    n,
    k,
    {"step_deg", "step of the angle", "deg", 1e-3, 90}};

double c01(double c) {
  return std::clamp(c, 0.0, 1.0);
}
double cos_deg(double x) {
  return direction_deg(x, 0)[2];
}

double of_medium(double (*formula)(double n, double k), In x) {
  const Medium m = medium(x[0], x[1]);
  return formula(m.n, m.k);
}

// For n < 1, F has a corner at the critical angle.
double mean_fresnel_exact(double index, double extinction) {
  const double corner = index < 1 ? std::sqrt(1 - index * index) : 0;
  const auto weighted = [&](double c) { return 2 * c * formulas::fresnel_exact(index, extinction, c); };
  return adaptive_integral(weighted, 0, corner, 1e-13) + adaptive_integral(weighted, corner, 1, 1e-13);
}

double approximation(int model, double f0_value, double f82_value, double c) {
  return model == 0   ? formulas::f_schlick(f0_value, c)
         : model == 1 ? formulas::f_schueler(f0_value, c)
                      : formulas::f_f82(f0_value, f82_value, c);
}

// Calls visit(cosine, |approximation - exact|) at 0, step, 2 step, ... and 90 degrees.
template <class Visit>
void visit_errors(In x, Visit visit) {
  const int model = static_cast<int>(x[0]);
  const auto [index, extinction] = medium(x[1], x[2]);
  const double step = x[3];
  const double f0_value = formulas::f0(index, extinction);
  const double f82_value = formulas::fresnel_exact(index, extinction, formulas::f82_cosine);
  const auto pieces = static_cast<int>(std::ceil(90 / step - 1e-9));
  for (int i = 0; i <= pieces; ++i) {
    const double c = cos_deg(std::min(i * step, 90.0));
    const double truth = formulas::fresnel_exact(index, extinction, c);
    visit(c, std::abs(approximation(model, f0_value, f82_value, c) - truth));
  }
}

double max_abs_error(In x) {
  double worst = 0;
  visit_errors(x, [&](double, double error) { worst = std::max(worst, error); });
  return worst;
}

// The mean error with the weight 2 cos d(cos): the integral of the error over cos^2, by the trapezoidal rule.
double mean_abs_error(In x) {
  double sum = 0, last_c2 = 0, last_error = 0;
  bool first = true;
  visit_errors(x, [&](double c, double error) {
    if (!first) sum += (last_error + error) / 2 * (last_c2 - c * c);
    first = false;
    last_c2 = c * c;
    last_error = error;
  });
  return sum;
}

constexpr Function rows[] = {
    {"f0", "reflectance at normal incidence", "Fresnel", n_k, false,
     [](In x) { return of_medium(formulas::f0, x); }},
    {"absorptance0", "1 - F0 without cancellation", "4 n / ((n + 1)^2 + k^2)", n_k, false,
     [](In x) { return of_medium(formulas::absorptance0, x); }},
    {"fresnel_exact", "unpolarised reflectance, complex index",
     "Cook and Torrance 1981, without cancellation", n_k_cos, false,
     [](In x) {
       const Medium m = medium(x[0], x[1]);
       return formulas::fresnel_exact(m.n, m.k, c01(x[2]));
     }},
    {"fresnel_dielectric", "unpolarised reflectance, total reflection included", "TU Graz, Fresnel slides",
     pair, false, [](In x) { return formulas::fresnel_dielectric(x[0], x[1], cos_deg(x[2])); }},
    {"schlick", "reflectance", "Schlick 1994, eq. 15", f0_cos, false,
     [](In x) { return formulas::f_schlick(x[0], x[1]); }},
    {"schueler_F", "lerp(K, min(60 K, 1), (1 - t)^4)", "Schueler 2009", schueler_inputs, false,
     [](In x) { return formulas::f_schueler(x[0], x[1]); }},
    {"f82_hoffman", "reflectance", "Hoffman 2019", f82_inputs, false,
     [](In x) { return formulas::f_f82(x[0], x[1], x[2]); }},
    {"f82_tint", "reflectance", "Kutz et al. 2021 (OpenPBR)", tint_inputs, false,
     [](In x) { return formulas::f_f82_tint(x[0], x[1], x[2]); }},
    {"lazanyi", "reflectance", "Lazanyi and Szirmay-Kalos 2005", lazanyi_inputs, false,
     [](In x) {
       const Medium m = medium(x[0], x[1]);
       return formulas::f_lazanyi(m.n, m.k, x[3], x[4], x[2]);
     }},
    {"spherical_gaussian", "reflectance", "Lagarde 2012", f0_cos, false,
     [](In x) { return formulas::f_spherical_gaussian(x[0], x[1]); }},
    {"from_f0", "reflectance of the dielectric of this F0", "n = (1 + sqrt F0) / (1 - sqrt F0), then exact",
     f0_cos, false, [](In x) { return formulas::f_from_f0(x[0], x[1]); }},
    {"gulbrandsen_n", "index of refraction", "Gulbrandsen 2014", r_g, false,
     [](In x) { return formulas::gulbrandsen_n(x[0], x[1]); }},
    {"gulbrandsen_k", "extinction", "Gulbrandsen 2014", r_g, false,
     [](In x) { return formulas::gulbrandsen_k(x[0], x[1]); }},
    {"gulbrandsen_r", "reflectance at normal incidence", "Gulbrandsen 2014", n_k, false,
     [](In x) { return of_medium(formulas::gulbrandsen_r, x); }},
    {"gulbrandsen_g", "edge tint", "Gulbrandsen 2014", n_k, false,
     [](In x) { return of_medium(formulas::gulbrandsen_g, x); }},
    {"n_of_f82", "index of refraction of F0 and F82", "the circle of one F0, Gulbrandsen 2014", f0_f82, false,
     [](In x) { return formulas::index_of_edge(x[0], x[1]).n; }},
    {"k_of_f82", "extinction of F0 and F82", "the circle of one F0, Gulbrandsen 2014", f0_f82, false,
     [](In x) { return formulas::index_of_edge(x[0], x[1]).k; }},
    {"f0_under", "F0 under a clear coat of F0 and F82 in air", "n and k of F0 and F82", f0_f82_coat, false,
     [](In x) { return formulas::f0_under(x[0], x[1], x[2]); }},
    {"f82_under", "F82 under a clear coat, at cosine 1/7 in it", "n and k of F0 and F82", f0_f82_coat, false,
     [](In x) { return formulas::f82_under(x[0], x[1], x[2]); }},
    {"f82_mean", "mean of F82 over a diffuse hemisphere, weighted by 2 cos d(cos)", "OpenPBR 1.1.1", f0_f82,
     false, [](In x) { return formulas::f82_mean(x[0], x[1]); }},
    {"fresnel_mean", "that mean of fresnel_exact", "the integral, within 1e-12", n_k, false,
     [](In x) {
       const Medium m = medium(x[0], x[1]);
       return mean_fresnel_exact(m.n, m.k);
     }},
    {"fresnel_max_abs_error", "largest error of the approximation", "against fresnel_exact, 0 to 90 degrees",
     error_inputs, false, max_abs_error},
    {"fresnel_cosmean_abs_error", "mean error, weighted by 2 cos d(cos)",
     "against fresnel_exact, 0 to 90 degrees", error_inputs, false, mean_abs_error},
};

}  // namespace

Medium medium(double index, double extinction) {
  if (index == 0 && extinction == 0) throw Error::at("n", "0 beside k = 0", "n above 0, or k above 0");
  return {index, extinction};
}

std::span<const Function> fresnel() {
  return rows;
}

}  // namespace etak::function_rows
