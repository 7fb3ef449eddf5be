// SPDX-License-Identifier: Apache-2.0
// Functions of `etak eval`: lights, hemispheres, transparency and transfer curves.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/light/function_rows.h"
#include "core/math/functions.h"

namespace etak::function_rows {
namespace {

#include "core/light/formulas_f64.h"

using formulas::vec3;
using In = const double*;

constexpr FunctionInput lower{"lower", "radiance of the lower hemisphere", "", 0, largest};
constexpr FunctionInput upper{"upper", "radiance of the upper hemisphere", "", 0, largest};
constexpr FunctionInput nv{"nv", "cosine of the viewer; taken as 0 below 0", "", -1, 1};
constexpr FunctionInput diffuse_inputs[] = {
    {"K", "diffuse colour", "", -10, 10}, lower, upper, {"nz", "cosine between normal and axis", "", -1, 1}};
constexpr FunctionInput specular_inputs[] = {
    K, g, nv, {"rz", "cosine between mirrored view and axis", "", -1, 1}, lower, upper};
constexpr FunctionInput reference_inputs[] = {
    K,
    g,
    nv,
    {"z_theta", "polar angle of the axis", "deg", 0, 180},
    {"z_phi", "azimuth of the axis; the viewer is at 0", "deg", -3600, 3600}};
constexpr FunctionInput total_inputs[] = {K, g, nv};
constexpr FunctionInput x_input[] = {{"x", "linear light", "", -largest, largest}};
constexpr FunctionInput y_input[] = {{"y", "encoded value", "", -largest, largest}};
constexpr FunctionInput codes_input[] = {
    {"codes", "how many codes there are, from 0", "", 2, 65536, false, {}, 256}};
constexpr FunctionInput point_inputs[] = {
    {"I", "radiant intensity", "W/sr", 0, largest}, {"r", "distance", "m", 0, largest, true}, cosine};
constexpr FunctionInput spot_inputs[] = {{"cos", "cosine between the ray and the cone's axis", "", -1, 1},
                                         {"inner_deg", "half-angle of full light", "deg", 0, 90},
                                         {"outer_deg", "half-angle of the cone", "deg", 0, 90}};
constexpr FunctionInput opacity_inputs[] = {{"alpha", "opacity of the body", "", 0, 1}, K, nv};

using Hemisphere = vec3 (*)(vec3 K, double g, double nv, double rz, vec3 lower, vec3 upper);
template <Hemisphere specular>
double hemisphere(In x) {
  return specular(vec3(x[0]), x[1], std::max(x[2], 0.0), x[3], vec3(x[4]), vec3(x[5])).x;
}

// The integral of Schueler's Simplified model over the light l with dot(l, z) > 0 (all light where there is
// no z), for a viewer in the xz plane at cosine nv.
double hemisphere_reference(double K_value, double g_value, double nv_value, std::optional<Vec3> z) {
  if (!(nv_value > 0)) return 0;
  const Model& model = *find_model("schueler-simplified");
  const double values[] = {K_value, K_value, K_value, g_value};
  AlbedoOptions options;
  options.lobe_width = alpha_of_gloss(g_value);
  options.half_space = z;
  return directional_albedo(
      [&](const Directions& d) {
        double rgb[3];
        model.f64(d, values, rgb);
        return rgb[0];
      },
      math::acos(std::min(nv_value, 1.0)) * (180 / 3.14159265358979323846), options);
}

// How many codes change when they are decoded and encoded again. The input is how many codes there are: 256
// for 8 bits.
double roundtrip_mismatches(In x) {
  if (x[0] != std::floor(x[0])) throw Error("codes: a whole number is expected");
  const double most = x[0] - 1;
  int count = 0;
  for (double code = 0; code <= most; ++code)
    count += std::floor(most * std::clamp(srgb_encode(srgb_decode(code / most)), 0.0, 1.0) + 0.5) != code;
  return count;
}

double spot(In x) {
  if (x[1] > x[2]) throw Error("inner_deg: larger than outer_deg; expected at most outer_deg");
  return formulas::spot_share(x[0], direction_deg(x[1], 0)[2], direction_deg(x[2], 0)[2]);
}

constexpr Function rows[] = {
    {"hemi_diffuse", "K lerp(lower, upper, (1 + nz) / 2)", "Schueler 2009", diffuse_inputs, false,
     [](In x) { return formulas::hemisphere_diffuse(vec3(x[0]), vec3(x[1]), vec3(x[2]), x[3]).x; }},
    {"hemi_specular", "radiance, corrected form",
     "Schueler 2009, with the share in [0, 1] and the Fresnel term of rough surfaces", specular_inputs, false,
     hemisphere<formulas::hemisphere_specular>},
    {"hemi_specular_wide", "radiance, with a transition that is never a step",
     "width min(1, 1.8 2^(-6 g)) by etak", specular_inputs, false,
     hemisphere<formulas::hemisphere_specular_wide>},
    {"hemi_specular_printed", "radiance, as printed", "Schueler 2009", specular_inputs, false,
     hemisphere<formulas::hemisphere_specular_printed>},
    {"hemi_reference_upper", "integral of f nl over light with l . z > 0",
     "Schueler 2009, technique 2 by quadrature", reference_inputs, false,
     [](In x) { return hemisphere_reference(x[0], x[1], x[2], direction_deg(x[3], x[4])); }},
    {"hemi_reference_total", "integral of f nl over all light", "Schueler 2009, technique 2 by quadrature",
     total_inputs, false, [](In x) { return hemisphere_reference(x[0], x[1], x[2], std::nullopt); }},
    {"srgb_encode", "encoded value", "IEC 61966-2-1", x_input, false, [](In x) { return srgb_encode(x[0]); }},
    {"srgb_decode", "linear light", "IEC 61966-2-1", y_input, false, [](In x) { return srgb_decode(x[0]); }},
    {"srgb_u8", "8-bit code, rounded to nearest", "IEC 61966-2-1", x_input, false,
     [](In x) { return static_cast<double>(srgb_u8(x[0])); }},
    {"srgb_u8_roundtrip_mismatches", "codes that do not come back", "IEC 61966-2-1", codes_input, false,
     roundtrip_mismatches},
    {"point_irradiance", "irradiance of the surface, W/m^2", "I / r^2 cos", point_inputs, false,
     [](In x) { return formulas::point_irradiance(vec3(x[0]), x[1]).x * std::max(x[2], 0.0); }},
    {"spot_share", "share of the beam", "smoothstep in the cosine, by etak", spot_inputs, false, spot},
    {"fresnel_opacity", "opacity with the Fresnel reflection", "Schueler 2009, 1 - (1 - alpha)(1 - F(nv))",
     opacity_inputs, false, [](In x) { return formulas::fresnel_opacity(x[0], x[1], x[2]); }},
};

}  // namespace

std::span<const Function> lighting() {
  return rows;
}

}  // namespace etak::function_rows
