// SPDX-License-Identifier: Apache-2.0
// Functions of `etak eval`: distributions of microfacets, their integrals, shadowing and masking.
#include <cmath>

#include "core/brdf/integrals/albedo.h"
#include "core/brdf/integrals/normalise.h"
#include "core/color/gloss.h"
#include "core/light/function_rows.h"
#include "core/math/functions.h"

namespace etak::function_rows {
namespace {

#include "core/light/formulas_f64.h"

using In = const double*;

constexpr FunctionInput nm{"nm", "cosine between normal and facet; taken as 0 below 0", "", -1, 1};
constexpr FunctionInput alpha_nm[] = {alpha, nm};
constexpr FunctionInput m_nm[] = {m, nm};
constexpr FunctionInput e_nm[] = {e, nm};
constexpr FunctionInput p_sgd{"p", "fall-off", "", -50, 50};
constexpr FunctionInput alpha_sgd{"alpha", "width", "", 1e-12, 100};
constexpr FunctionInput sgd_inputs[] = {alpha_sgd, p_sgd, nm};
constexpr FunctionInput abc_inputs[] = {{"a1", "width", "", 0, 1e12}, {"a2", "fall-off", "", 0, 1e6}};
constexpr FunctionInput abc_nm[] = {abc_inputs[0], abc_inputs[1], nm};
constexpr FunctionInput width_parameter[] = {{"param", "width alpha, or rms slope m", "", 1e-4, 100}};
constexpr FunctionInput exponent_parameter[] = {{"param", "exponent e", "", 0, 1e9}};
constexpr FunctionInput ct_inputs[] = {{"nh", "cosine", "", -1, 1},
                                       {"nv", "cosine", "", -1, 1},
                                       {"nl", "cosine", "", -1, 1},
                                       {"vh", "cosine", "", -1, 1}};
constexpr FunctionInput cos_alpha[] = {cosine, alpha};
constexpr FunctionInput cos_m[] = {cosine, m};
constexpr FunctionInput nl_nv_alpha[] = {
    {"nl", "cosine of the light", "", -1, 1}, {"nv", "cosine of the viewer", "", -1, 1}, alpha};

constexpr FunctionInput nl_nv[] = {nl_nv_alpha[0], nl_nv_alpha[1]};
constexpr FunctionInput nl_nv_vh[] = {
    nl_nv_alpha[0], nl_nv_alpha[1], {"vh", "cosine between viewer and half vector", "", 0, 1, true}};
constexpr FunctionInput gloss_input[] = {g};

double at_least_0(double x) {
  return std::max(x, 0.0);
}

// G = 4 nl nv V of a visibility that needs no more than the angle between viewer and half vector.
double g_of(double (*v)(formulas::Angles), In x, double vh) {
  formulas::Angles a{};
  a.lh = vh;
  return 4 * at_least_0(x[0]) * at_least_0(x[1]) * v(a);
}

using Distribution = double (*)(double parameter, double nm, double s2);
template <Distribution D>
double integral(double parameter, double width) {
  return integral_of_distribution([&](double nm_value, double s2) { return D(parameter, nm_value, s2); },
                                  width);
}

constexpr Function rows[] = {
    {"D_ggx", "density of facets, 1/sr", "Walter et al. 2007, eq. 33", alpha_nm, false,
     [](In x) { return formulas::d_ggx(x[0], at_least_0(x[1])); }},
    {"D_beckmann", "density of facets, 1/sr", "Cook and Torrance 1981, 1 / (pi m^2 nm^4)", m_nm, false,
     [](In x) { return formulas::d_beckmann(x[0], at_least_0(x[1])); }},
    {"D_beckmann_printed", "as printed, integral pi / 4", "TU Graz, 1 / (4 m^2 nm^4)", m_nm, false,
     [](In x) { return formulas::d_beckmann_printed(x[0], at_least_0(x[1])); }},
    {"D_phong", "density of facets, 1/sr", "Hoffman, (e + 2) / (2 pi) nm^e", e_nm, false,
     [](In x) { return formulas::d_phong(x[0], at_least_0(x[1])); }},
    {"D_schueler", "as printed, pi-scaled", "Schueler 2009, (1 + e) / 2 nm^e", e_nm, false,
     [](In x) { return formulas::d_schueler(x[0], at_least_0(x[1])); }},
    {"D_sgd", "density of facets, 1/sr", "Bagher et al. 2012", sgd_inputs, false,
     [](In x) { return formulas::d_sgd(x[0], x[1], log_sgd_norm(x[0], x[1]), at_least_0(x[2])); }},
    {"D_abc", "density of facets, 1/sr, normalised", "Hoffman, with uabc_norm", abc_nm, false,
     [](In x) { return formulas::d_abc(x[0], x[1], abc_norm(x[0], x[1]), at_least_0(x[2])); }},
    {"D_abc_printed", "as printed, not normalised", "Hoffman, (1 + a1 (1 - nm))^-a2", abc_nm, false,
     [](In x) {
       const double c = at_least_0(x[2]);
       return formulas::d_abc_printed_s2(x[0], x[1], c, (1 - c) * (1 + c));
     }},
    {"uabc_norm", "the constant that normalises ABC, 1/sr", "integral of c (1 + a1 (1 - nm))^-a2 nm is 1",
     abc_inputs, false, [](In x) { return abc_norm(x[0], x[1]); }},
    {"integral_D_ggx", "integral of D nm", "by quadrature", width_parameter, false,
     [](In x) { return integral<formulas::d_ggx_s2>(x[0], x[0]); }},
    {"integral_D_beckmann", "integral of D nm", "by quadrature", width_parameter, false,
     [](In x) { return integral<formulas::d_beckmann_s2>(x[0], x[0]); }},
    {"integral_D_beckmann_printed", "integral of D nm", "by quadrature", width_parameter, false,
     [](In x) { return integral<formulas::d_beckmann_printed_s2>(x[0], x[0]); }},
    {"integral_D_phong", "integral of D nm", "by quadrature", exponent_parameter, false,
     [](In x) { return integral<formulas::d_phong_s2>(x[0], alpha_of_exponent(x[0])); }},
    {"integral_D_schueler_over_pi", "integral of D nm / pi", "by quadrature", exponent_parameter, false,
     [](In x) { return integral<formulas::d_schueler_over_pi_s2>(x[0], alpha_of_exponent(x[0])); }},
    {"G_ct", "shadowing and masking", "Torrance and Sparrow 1967", ct_inputs, false,
     [](In x) {
       return formulas::g_cook_torrance(at_least_0(x[0]), at_least_0(x[1]), at_least_0(x[2]),
                                        at_least_0(x[3]));
     }},
    {"G_implicit", "shadowing and masking, nl nv", "Hoffman", nl_nv, false,
     [](In x) { return g_of(formulas::v_implicit, x, 1); }},
    {"G_kelemen", "shadowing and masking, nl nv / vh^2", "Kelemen and Szirmay-Kalos 2001", nl_nv_vh, false,
     [](In x) { return g_of(formulas::v_kelemen, x, x[2]); }},
    {"gloss_exponent", "exponent of the lobe, 2^(12 g)", "Schueler 2009", gloss_input, false,
     [](In x) { return formulas::gloss_exponent(x[0]); }},
    {"G1_ggx", "masking", "Smith 1967; Walter et al. 2007, eq. 34", cos_alpha, false,
     [](In x) { return formulas::g1_ggx(at_least_0(x[0]), x[1]); }},
    {"G1_beckmann_exact", "masking, with erf", "Smith 1967", cos_m, false,
     [](In x) { return formulas::g1_beckmann_exact(at_least_0(x[0]), x[1]); }},
    {"G2_ggx_uncorrelated", "shadowing and masking", "Smith 1967; Hoffman", nl_nv_alpha, false,
     [](In x) { return formulas::g2_ggx_uncorrelated(at_least_0(x[0]), at_least_0(x[1]), x[2]); }},
    {"G2_ggx_height", "shadowing and masking, height-correlated", "Heitz 2014, eq. 99", nl_nv_alpha, false,
     [](In x) { return formulas::g2_ggx_height(at_least_0(x[0]), at_least_0(x[1]), x[2]); }},
    {"lost_ggx", "share that one reflection of F = 1 loses", "fit for Kulla and Conty 2017", cos_alpha, false,
     [](In x) { return formulas::lost_ggx(at_least_0(x[0]), std::min(x[1], 1.0)); }},
    {"lost_beckmann", "share that one reflection of F = 1 loses", "fit for Kulla and Conty 2017", cos_m,
     false, [](In x) { return formulas::lost_beckmann(at_least_0(x[0]), std::min(x[1], 1.0)); }},
};

}  // namespace

std::span<const Function> distributions() {
  return rows;
}

}  // namespace etak::function_rows
