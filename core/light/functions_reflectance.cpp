// SPDX-License-Identifier: Apache-2.0
// Functions of `etak eval`: reflectance models for a pair of directions, and their directional albedo under
// light of radiance 1 from all directions (the white furnace).
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/light/function_rows.h"
#include "core/math/functions.h"

namespace etak::function_rows {
namespace {

using std::numbers::pi;
using In = const double*;

constexpr FunctionInput cd{"cd", "diffuse colour", "", 0, 10};
constexpr FunctionInput cs{"cs", "specular colour", "", 0, 10};
constexpr FunctionInput exponent{"m", "exponent", "", 0, 1e9};
constexpr FunctionInput schueler[] = {theta_l, theta_v, phi_v, K, g};
constexpr FunctionInput n_k_m[] = {theta_l, theta_v, phi_v, n, k, m};
constexpr FunctionInput cd_cs_m[] = {theta_l, theta_v, phi_v, cd, cs, exponent};
constexpr FunctionInput rs{"rs", "specular colour", "", 0, 10};
constexpr FunctionInput as_spec[] = {theta_l,
                                     theta_v,
                                     phi_v,
                                     rs,
                                     {"nu", "exponent along +x", "", 0, 1e9},
                                     {"nv", "exponent along +y", "", 0, 1e9}};
constexpr FunctionInput as_diff[] = {theta_l, theta_v, phi_v, rs, {"rd", "diffuse colour", "", 0, 10}};
constexpr FunctionInput oren_nayar_inputs[] = {
    theta_l,
    theta_v,
    phi_v,
    {"rho", "albedo", "", 0, 10},
    {"sigma", "standard deviation of the slope angle", "rad", 0, 1.5707963267948966}};
constexpr FunctionInput exponent_furnace[] = {{"param", "exponent e", "", 0, 1e6},
                                              {"theta_v", "polar angle of the viewer", "deg", 0, 90}};
constexpr FunctionInput width_furnace[] = {{"param", "width alpha, or rms slope m", "", 1e-4, 10},
                                           {"theta_v", "polar angle of the viewer", "deg", 0, 90}};

// Light at azimuth 0, viewer at phi_v, normal +z.
Directions directions(In x) {
  const Vec3 l = direction_deg(x[0], 0), v = direction_deg(x[1], x[2]);
  return {l[0], l[1], l[2], v[0], v[1], v[2]};
}

constexpr std::string_view axes[] = {"x", "y", "z"};
constexpr FunctionInput axis{"axis", "component: x of the tangent, z of the normal", "", 0, 2, false, axes};
constexpr FunctionInput light_axis[] = {theta_l, axis};
constexpr FunctionInput pair_axis[] = {theta_l, theta_v, phi_v, axis};

// A component of r = 2 n (n . l) - l, for the light at azimuth 0.
double reflected(In x) {
  const Vec3 l = direction_deg(x[0], 0);
  return Vec3{-l[0], -l[1], l[2]}[static_cast<std::size_t>(x[1])];
}

// A component of h = (l + v) / |l + v|. Throws Error for l = -v.
double half_vector(In x) {
  const Directions d = directions(x);
  const Vec3 sum{d.lx + d.vx, d.ly + d.vy, d.lz + d.vz};
  const double length = math::hypot(sum[0], sum[1], sum[2]);
  if (length < 1e-12) throw Error::at("theta_v", "a viewer opposite to the light", "another direction");
  return sum[static_cast<std::size_t>(x[3])] / length;
}

// The first channel of a model's f_r for the directions in x[0..2].
//   values   the model's parameters; the number of a colour is given three times
double reflectance_at(const char* id, In x, const std::vector<double>& values) {
  double rgb[3];
  find_model(id)->f64(directions(x), values.data(), rgb);
  return rgb[0];
}

// pi f_r nl: the value that Schueler's article prints, per unit of its pi-scaled irradiance.
double printed(const char* id, In x, const std::vector<double>& values) {
  const Directions d = directions(x);
  return d.lz > 0 ? pi * d.lz * reflectance_at(id, x, values) : 0;
}

double schueler_at(const char* id, In x) {
  return printed(id, x, {x[3], x[3], x[3], x[4]});
}
std::vector<double> index_and_slope(In x) {
  const auto [n, k] = medium(x[3], x[4]);
  return {n, n, n, k, k, k, x[5]};
}

// The directional albedo for inputs x = {param, theta_v}.
//   values   the model's parameters, with F = 1
//   width    of the lobe, as in AlbedoOptions
double furnace(const char* id, In x, std::vector<double> values, double width) {
  const Model& model = *find_model(id);
  AlbedoOptions options;
  options.lobe_width = width;
  return directional_albedo(
      [&](const Directions& d) {
        double rgb[3];
        model.f64(d, values.data(), rgb);
        return rgb[0];
      },
      x[1], options);
}
double furnace_exponent(const char* id, In x) {
  return furnace(id, x, {1, 1, 1, x[0]}, alpha_of_exponent(x[0]));
}
double furnace_width(const char* id, In x) {
  return furnace(id, x, {1, 1, 1, x[0]}, x[0]);
}

constexpr Function rows[] = {
    {"R", "component of the mirrored light, 2 n (n . l) - l", "Schueler 2009; TU Graz", light_axis, false,
     reflected},
    {"H", "component of the half vector, (l + v) / |l + v|", "Schueler 2009; TU Graz", pair_axis, false,
     half_vector},
    {"schueler_full", "pi f nl", "Schueler 2009, technique 1", n_k_m, true,
     [](In x) { return printed("cook-torrance", x, index_and_slope(x)); }},
    {"schueler_simplified", "pi f nl", "Schueler 2009, technique 2, as printed", schueler, true,
     [](In x) { return schueler_at("schueler-simplified", x); }},
    {"schueler_ksk", "pi f nl", "Schueler 2009, technique 3, as printed", schueler, true,
     [](In x) { return schueler_at("schueler-ksk", x); }},
    {"schueler_optimized", "pi f nl", "Schueler 2009, technique 4, as printed", schueler, true,
     [](In x) { return schueler_at("schueler-optimized", x); }},
    {"schueler_optimized_bounded", "pi f nl", "Schueler 2009, technique 4 with K / lh at most 1", schueler,
     true, [](In x) { return schueler_at("schueler-optimized-bounded", x); }},
    {"phong", "pi f nl; specular gated by nl > 0", "TU Graz, as printed", cd_cs_m, true,
     [](In x) {
       return printed("phong", x, {x[3], x[3], x[3], x[4], x[4], x[4], x[5]});
     }},
    {"blinn_phong", "f, 1/sr", "TU Graz, (m + 8) / (8 pi)", cd_cs_m, true,
     [](In x) {
       return reflectance_at("blinn-phong", x, {x[3], x[3], x[3], x[4], x[4], x[4], x[5]});
     }},
    {"blinn_phong_exact", "f, 1/sr", "Giesen 2009", cd_cs_m, true,
     [](In x) {
       return reflectance_at("blinn-phong-exact", x, {x[3], x[3], x[3], x[4], x[4], x[4], x[5]});
     }},
    {"cook_torrance", "f, 1/sr", "TU Graz, with 1 / (pi m^2)", n_k_m, true,
     [](In x) { return reflectance_at("cook-torrance", x, index_and_slope(x)); }},
    {"cook_torrance_printed", "f, 1/sr", "TU Graz, with 1 / (4 m^2)", n_k_m, true,
     [](In x) { return reflectance_at("cook-torrance-printed", x, index_and_slope(x)); }},
    {"ashikhmin_shirley_spec", "f, 1/sr", "Ashikhmin and Shirley 2000, eq. 4", as_spec, true,
     [](In x) {
       return reflectance_at("ashikhmin-shirley-specular", x, {x[3], x[3], x[3], x[4], x[5]});
     }},
    {"ashikhmin_shirley_diff", "f, 1/sr", "Ashikhmin and Shirley 2000, eq. 5", as_diff, true,
     [](In x) {
       return reflectance_at("ashikhmin-shirley-diffuse", x, {x[3], x[3], x[3], x[4], x[4], x[4]});
     }},
    {"oren_nayar", "f, 1/sr", "Oren and Nayar 1994, eq. 30", oren_nayar_inputs, true,
     [](In x) {
       return reflectance_at("oren-nayar", x, {x[3], x[3], x[3], x[4]});
     }},
    {"oren_nayar_grazing_albedo_max",
     "largest directional albedo, rho = 1",
     "Oren and Nayar 1994, eq. 30",
     {},
     false,
     [](In) { return oren_nayar_grazing_albedo_max(); }},
    {"furnace_simplified", "directional albedo, F = 1", "Schueler 2009, technique 2", exponent_furnace, false,
     [](In x) { return furnace_exponent("microfacet:schueler,schlick,cook-torrance", x); }},
    {"furnace_ksk", "directional albedo, F = 1", "Schueler 2009, technique 3", exponent_furnace, false,
     [](In x) { return furnace_exponent("microfacet:schueler,schlick,kelemen", x); }},
    {"furnace_optimized", "directional albedo, K = 1", "Schueler 2009, technique 4, as printed",
     exponent_furnace, false,
     [](In x) {
       return furnace("schueler-optimized", x, {1, 1, 1, gloss_of_exponent(x[0])}, alpha_of_exponent(x[0]));
     }},
    {"furnace_blinn", "directional albedo, cs = 1", "TU Graz, (m + 8) / (8 pi)", exponent_furnace, false,
     [](In x) {
       return furnace("blinn-phong", x, {0, 0, 0, 1, 1, 1, x[0]}, alpha_of_exponent(x[0]));
     }},
    {"furnace_beckmann_ct", "directional albedo, F = 1", "Beckmann, V-grooves", width_furnace, false,
     [](In x) { return furnace_width("microfacet:beckmann,schlick,cook-torrance", x); }},
    {"furnace_beckmann_ct_printed", "directional albedo, F = 1", "Beckmann with 1 / (4 m^2), V-grooves",
     width_furnace, false,
     [](In x) { return furnace_width("microfacet:beckmann-printed,schlick,cook-torrance", x); }},
    {"furnace_ggx_ct", "directional albedo, F = 1", "GGX, V-grooves", width_furnace, false,
     [](In x) { return furnace_width("microfacet:ggx,schlick,cook-torrance", x); }},
    {"furnace_ggx_smith", "directional albedo, F = 1", "GGX, Smith uncorrelated", width_furnace, false,
     [](In x) { return furnace_width("microfacet:ggx,schlick,smith-ggx-uncorrelated", x); }},
    {"furnace_ggx_smith_corr", "directional albedo, F = 1", "GGX, Smith height-correlated", width_furnace,
     false, [](In x) { return furnace_width("microfacet:ggx,schlick,smith-ggx-height", x); }},
    {"furnace_ggx_compensated", "directional albedo, F = 1", "Kulla and Conty 2017", width_furnace, false,
     [](In x) { return furnace_width("microfacet:ggx,schlick,smith-ggx-compensated", x); }},
    {"furnace_beckmann_smith_corr", "directional albedo, F = 1", "Beckmann, Smith height-correlated",
     width_furnace, false,
     [](In x) { return furnace_width("microfacet:beckmann,schlick,smith-beckmann-height", x); }},
    {"furnace_beckmann_compensated", "directional albedo, F = 1", "Kulla and Conty 2017", width_furnace,
     false, [](In x) { return furnace_width("microfacet:beckmann,schlick,smith-beckmann-compensated", x); }},
};

}  // namespace

std::span<const Function> reflectance() {
  return rows;
}

}  // namespace etak::function_rows
