// SPDX-License-Identifier: Apache-2.0
// The rows of the terms: what terms.inc compiles, with titles, sources and parameters.
#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "core/brdf/evaluate/evaluators.h"
#include "core/brdf/integrals/normalise.h"
#include "core/brdf/parameters.h"

namespace etak {
namespace {

using Files = std::span<const std::string_view>;

#define ETAK_PARAMETERS(name, ...) constexpr Parameter name[] = {__VA_ARGS__}
ETAK_PARAMETERS(alpha_only, parameters::alpha);
ETAK_PARAMETERS(slope_only, parameters::m_slope);
ETAK_PARAMETERS(exponent_only, parameters::e);
constexpr Parameter abc_parameters[] = {
    {"a1", "width: larger is glossier", "", 0, 1e6, 100, Role::other, false},
    {"a2", "fall-off", "", 0, 100, 2, Role::other, false}};
constexpr Parameter sgd_parameters[] = {parameters::alpha,
                                        {"p", "fall-off", "", 0.01, 10, 1.5, Role::other, false}};
constexpr Parameter abc_derived[] = {
    {"norm", "makes the integral one", "1/sr", 0, 1e9, 1, Role::other, false}};
constexpr Parameter sgd_derived[] = {
    {"log_norm", "makes the integral one", "", -1e3, 1e3, 0, Role::other, false}};

ETAK_PARAMETERS(index, parameters::n, parameters::k);
constexpr Parameter two_indices[] = {{"n1", "index outside", "", 1e-3, 1e4, 1, Role::other, true},
                                     {"n2", "index inside", "", 1e-3, 1e4, 1.5, Role::n, true}};
ETAK_PARAMETERS(f0_only, parameters::f0);
ETAK_PARAMETERS(K_only, parameters::K);
constexpr Parameter f82_parameters[] = {parameters::f0,
                                        {"f82", "reflectance at cosine 1/7", "", 0, 1, 0.4, Role::f82, true}};
constexpr Parameter tint_parameters[] = {
    parameters::f0, {"tint", "share of Schlick's value at cosine 1/7", "", 0, 1, 1, Role::f82, true}};
constexpr Parameter lazanyi_parameters[] = {
    parameters::n,
    parameters::k,
    {"fit_a", "depth of the fitted dip", "", -10, 10, 0, Role::other, true},
    {"fit_alpha", "exponent of the fitted dip", "", 0.1, 20, 6, Role::other, true}};
constexpr Parameter gulbrandsen_parameters[] = {
    {"r", "reflectance at normal incidence", "", 0, 1, 0.9, Role::f0, true},
    {"g", "edge tint", "", 0, 1, 0.5, Role::other, true}};
#undef ETAK_PARAMETERS

constexpr std::string_view ggx_files[] = {"brdf/geometry.glsl", "brdf/d_ggx.glsl"};
constexpr std::string_view beckmann_files[] = {"brdf/geometry.glsl", "brdf/d_beckmann.glsl"};
constexpr std::string_view d_phong_files[] = {"brdf/geometry.glsl", "brdf/d_phong.glsl"};
constexpr std::string_view abc_files[] = {"brdf/geometry.glsl", "brdf/d_abc.glsl"};
constexpr std::string_view sgd_files[] = {"brdf/geometry.glsl", "brdf/d_sgd.glsl"};
constexpr std::string_view exact_files[] = {"fresnel/conductor.glsl"};
constexpr std::string_view dielectric_files[] = {"fresnel/dielectric.glsl"};
constexpr std::string_view schlick_files[] = {"fresnel/schlick.glsl"};
constexpr std::string_view f_schueler_files[] = {"fresnel/schueler.glsl"};
constexpr std::string_view f82_files[] = {"fresnel/schlick.glsl", "fresnel/f82.glsl"};
constexpr std::string_view lazanyi_files[] = {"fresnel/lazanyi.glsl"};
constexpr std::string_view gulbrandsen_files[] = {"fresnel/conductor.glsl", "fresnel/gulbrandsen.glsl"};
constexpr std::string_view from_f0_files[] = {"fresnel/from_f0.glsl"};
constexpr std::string_view by_f0_files[] = {"fresnel/schlick.glsl", "fresnel/from_f0.glsl",
                                            "fresnel/by_f0.glsl"};
constexpr std::string_view gaussian_files[] = {"fresnel/spherical_gaussian.glsl"};
constexpr std::string_view v_ct_files[] = {"brdf/geometry.glsl", "brdf/g_cook_torrance.glsl"};
constexpr std::string_view v_simple_files[] = {"brdf/geometry.glsl", "brdf/g_simple.glsl"};
constexpr std::string_view v_ggx_files[] = {"brdf/geometry.glsl", "brdf/g_smith_ggx.glsl"};
constexpr std::string_view v_beckmann_files[] = {"brdf/geometry.glsl", "brdf/g_smith_beckmann.glsl"};

constexpr TermKind D = TermKind::distribution, F = TermKind::fresnel, V = TermKind::visibility;

constexpr Term rows[] = {
    {"ggx",
     "Trowbridge-Reitz (GGX)",
     "Trowbridge and Reitz 1975; Walter et al. 2007, eq. 33; Hoffman",
     D,
     alpha_only,
     {},
     ggx_files,
     "d_ggx_s2",
     "integral 1",
     true},
    {"beckmann",
     "Beckmann",
     "Beckmann and Spizzichino 1963; Cook and Torrance 1981; Hoffman",
     D,
     slope_only,
     {},
     beckmann_files,
     "d_beckmann_s2",
     "integral 1",
     true},
    {"beckmann-printed",
     "Beckmann, as printed in the lecture",
     "TU Graz, 1 / (4 m^2 nm^4)",
     D,
     slope_only,
     {},
     beckmann_files,
     "d_beckmann_printed_s2",
     "as printed: integral pi / 4",
     false},
    {"phong",
     "Phong (Blinn)",
     "Blinn 1977; Hoffman, (e + 2) / (2 pi) nm^e",
     D,
     exponent_only,
     {},
     d_phong_files,
     "d_phong_s2",
     "integral 1",
     true},
    {"schueler",
     "Schueler's lobe, as printed",
     "Schueler 2009, (1 + e) / 2 nm^e over pi",
     D,
     exponent_only,
     {},
     d_phong_files,
     "d_schueler_over_pi_s2",
     "as printed: integral (1 + e) / (2 + e)",
     false},
    {"abc", "ABC", "Hoffman; Low et al. 2012; constant by etak", D, abc_parameters, abc_derived, abc_files,
     "d_abc_s2", "integral 1", true},
    {"abc-printed",
     "ABC, as printed",
     "Hoffman, without its constant",
     D,
     abc_parameters,
     {},
     abc_files,
     "d_abc_printed_s2",
     "as printed: not normalised",
     false},
    {"sgd", "Shifted gamma", "Bagher, Soler and Holzschuch 2012; Hoffman", D, sgd_parameters, sgd_derived,
     sgd_files, "d_sgd_s2", "integral 1", true},

    {"exact",
     "exact, complex index",
     "Fresnel; Cook and Torrance 1981",
     F,
     index,
     {},
     exact_files,
     "fresnel_exact",
     "free of cancellation"},
    {"dielectric",
     "exact pair of two clear media",
     "TU Graz, Fresnel slides",
     F,
     two_indices,
     {},
     dielectric_files,
     "fresnel_dielectric",
     "total reflection included"},
    {"schlick",
     "Schlick",
     "Schlick 1994, eq. 15",
     F,
     f0_only,
     {},
     schlick_files,
     "f_schlick",
     "metals off by up to 0.20"},
    {"schueler",
     "Schueler's F",
     "Schueler 2009",
     F,
     K_only,
     {},
     f_schueler_files,
     "f_schueler",
     "rises to min(60 K, 1) with the 4th power"},
    {"f82", "F82, absolute", "Hoffman 2019", F, f82_parameters, {}, f82_files, "f_f82", "for metals"},
    {"f82-tint",
     "F82, tint",
     "Kutz et al. 2021 (OpenPBR)",
     F,
     tint_parameters,
     {},
     f82_files,
     "f_f82_tint",
     "for metals"},
    {"lazanyi",
     "Lazanyi and Szirmay-Kalos",
     "Lazanyi and Szirmay-Kalos 2005",
     F,
     lazanyi_parameters,
     {},
     lazanyi_files,
     "f_lazanyi",
     "two numbers fitted per channel"},
    {"gulbrandsen",
     "Gulbrandsen",
     "Gulbrandsen 2014",
     F,
     gulbrandsen_parameters,
     {},
     gulbrandsen_files,
     "f_gulbrandsen",
     "reflectance and edge tint into n and k, then exact"},
    {"from-f0",
     "exact dielectric from F0",
     "n = (1 + sqrt F0) / (1 - sqrt F0)",
     F,
     f0_only,
     {},
     from_f0_files,
     "f_from_f0",
     "for dielectrics: k = 0"},
    {"by-f0",
     "exact below F0 of 0.2, Schlick above",
     "k = 0 below the forbidden zone; Schlick 1994, eq. 15",
     F,
     f0_only,
     {},
     by_f0_files,
     "f_by_f0",
     "for textures that mix dielectrics and metals"},
    {"spherical-gaussian",
     "spherical-Gaussian Schlick",
     "Lagarde 2012",
     F,
     f0_only,
     {},
     gaussian_files,
     "f_spherical_gaussian",
     "Schlick with an exponential"},

    {"cook-torrance",
     "V-grooves",
     "Torrance and Sparrow 1967; Cook and Torrance 1981",
     V,
     {},
     {},
     v_ct_files,
     "v_cook_torrance",
     ""},
    {"kelemen",
     "Kelemen's approximation, 1 / (4 lh^2)",
     "Kelemen and Szirmay-Kalos 2001",
     V,
     {},
     {},
     v_simple_files,
     "v_kelemen",
     ""},
    {"implicit", "implicit, G = nl nv", "Hoffman", V, {}, {}, v_simple_files, "v_implicit", ""},
    {"smith-ggx-uncorrelated",
     "Smith for GGX, uncorrelated",
     "Smith 1967; Walter et al. 2007; Hoffman",
     V,
     alpha_only,
     {},
     v_ggx_files,
     "v_smith_ggx_uncorrelated",
     ""},
    {"smith-ggx-height",
     "Smith for GGX, height-correlated",
     "Heitz 2014, eq. 99",
     V,
     alpha_only,
     {},
     v_ggx_files,
     "v_smith_ggx_height",
     ""},
    {"smith-beckmann-uncorrelated",
     "Smith for Beckmann, uncorrelated",
     "Smith 1967; Hoffman",
     V,
     slope_only,
     {},
     v_beckmann_files,
     "v_smith_beckmann_uncorrelated",
     "with erf, not the rational fit"},
    {"smith-beckmann-height",
     "Smith for Beckmann, height-correlated",
     "Heitz 2014",
     V,
     slope_only,
     {},
     v_beckmann_files,
     "v_smith_beckmann_height",
     "with erf, not the rational fit"},
};

}  // namespace

std::string_view name(TermKind kind) {
  return kind == D ? "D" : kind == F ? "F" : "V";
}

std::size_t number_count(std::span<const Parameter> list) {
  std::size_t count = 0;
  for (const Parameter& each : list) count += each.color ? 3 : 1;
  return count;
}

std::span<const Term> terms() {
  return rows;
}

const Term* find_term(TermKind kind, std::string_view id) {
  const auto found = std::find_if(std::begin(rows), std::end(rows),
                                  [&](const Term& t) { return t.kind == kind && t.id == id; });
  return found == std::end(rows) ? nullptr : found;
}

void Term::f64(const Directions& d, const double* values, double rgb[3]) const {
  double numbers[16];
  const std::size_t count = number_count(parameters);
  std::copy(values, values + count, numbers);
  evaluators::derive(*this, values, numbers + count);
  evaluators::compiled<double>(*this).evaluate(d, numbers, rgb);
}

namespace evaluators {

void derive(const Term& term, const double* values, double* out) {
  if (term.derived.empty()) return;
  *out = term.entry == "d_abc_s2" ? abc_norm(values[0], values[1]) : log_sgd_norm(values[0], values[1]);
}

std::string compiled_name(std::string_view id) {
  std::string out(id);
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

namespace {

template <class Real>
const One<Real>& compiled_by_name(const Term& term) {
  std::span<const One<Real>> all;
  if constexpr (std::is_same_v<Real, double>)
    all = all_f64();
  else
    all = all_f32();
  const std::string name = std::string(etak::name(term.kind)) + '_' + compiled_name(term.id);
  for (const One<Real>& each : all)
    if (each.entry == name) return each;
  throw std::logic_error("term " + name + " is not compiled");
}

}  // namespace

template <class Real>
const One<Real>& compiled(const Term& term) {
  // Terms are evaluated by the million, and comparing names took a quarter of that time.
  static const std::vector<const One<Real>*> of_rows = [] {
    std::vector<const One<Real>*> out;
    for (const Term& each : rows) out.push_back(&compiled_by_name<Real>(each));
    return out;
  }();
  return *of_rows[static_cast<std::size_t>(&term - std::begin(rows))];
}
template const One<double>& compiled(const Term&);
template const One<float>& compiled(const Term&);

}  // namespace evaluators
}  // namespace etak
