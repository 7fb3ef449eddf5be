// SPDX-License-Identifier: Apache-2.0
// Based on: Karis 2013, "Real Shading in Unreal Engine 4" (split sum; k = alpha / 2 of Schlick's masking under environments);
// Guy and Agopian, "Physically Based Rendering in Filament", section 5.3; Unity's Lit.hlsl and URP's BRDF.hlsl
// (github.com/Unity-Technologies/Graphics); Khronos' glTF Sample Renderer (ibl.glsl) with Fdez-Aguera 2019, "A Multiple-Scattering
// Microfacet Model for Real-Time Image Based Lighting".
#include "core/render/ambient/engine_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"

namespace etak {
namespace {

// The albedo of GGX with Schlick's F as scale of F0 and bias: the table that these engines read.
struct ScaleBias {
  double scale = 0, bias = 0;
  double whole() const { return scale + bias; }  // for F = 1
};

double smith(double c, double alpha) {
  return std::sqrt(alpha * alpha + (1 - alpha * alpha) * c * c);
}

// Scale and bias by half vectors that are spread as D nh.
//   karis   Schlick's masking with k = alpha / 2 in place of Smith's, height-correlated
ScaleBias scale_bias(double nv, double alpha, bool karis) {
  constexpr int heights = 96, azimuths = 24;
  const double vx = std::sqrt((1 - nv) * (1 + nv)), k = alpha / 2;
  ScaleBias out;
  for (int i = 0; i < heights; ++i) {
    const double u = (i + 0.5) / heights, nh = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)),
                 s = std::sqrt((1 - nh) * (1 + nh));
    for (int j = 0; j < azimuths; ++j) {
      const double vh = vx * s * math::cos(std::numbers::pi * (j + 0.5) / azimuths) + nv * nh,
                   nl = 2 * vh * nh - nv;
      if (!(vh > 0) || !(nl > 0)) continue;
      const double v = karis ? 0.25 / ((nl * (1 - k) + k) * (nv * (1 - k) + k))
                             : 0.5 / (nl * smith(nv, alpha) + nv * smith(nl, alpha));
      const double share = 4 * v * nl * vh / nh / (heights * azimuths),
                   rise = math::pow(1 - std::min(vh, 1.0), 5);
      out.scale += share * (1 - rise);
      out.bias += share * rise;
    }
  }
  return out;
}

double largest_of(const Vec3& c) {
  return std::ranges::max(c);
}

template <class Channel>
Vec3 each_channel(const Vec3& f0, const Channel& channel) {
  return {channel(f0[0]), channel(f0[1]), channel(f0[2])};
}

Vec3 rest_of(const Vec3& specular) {
  return each_channel(specular, [](double e) { return std::max(1 - e, 0.0); });
}

EngineLight unreal(double nv, double alpha, const Vec3& f0) {
  const ScaleBias table = scale_bias(nv, alpha, true);
  return {each_channel(f0, [&](double f) { return f * table.scale + table.bias; }), Vec3{1, 1, 1}};
}

// Filament and Unity HDRP: with 1 + F0 (1 / E - 1) for what facets reflect to each other.
Vec3 compensated(double nv, double alpha, const Vec3& f0) {
  const ScaleBias table = scale_bias(nv, alpha, false);
  return each_channel(
      f0, [&](double f) { return (f * table.scale + table.bias) * (1 + f * (1 / table.whole() - 1)); });
}

EngineLight filament(double nv, double alpha, const Vec3& f0) {
  const double held = std::max(alpha, 0.045 * 0.045);
  const ScaleBias table = scale_bias(nv, held, false);
  return {compensated(nv, held, f0),
          rest_of(each_channel(f0, [&](double f) { return f * table.scale + table.bias; }))};
}

EngineLight unity_urp(double nv, double alpha, const Vec3& f0) {
  const double rise = math::pow(1 - nv, 4),
               grazing = std::clamp(1 - std::sqrt(alpha) + largest_of(f0), 0.0, 1.0);
  return {each_channel(f0, [&](double f) { return std::lerp(f, grazing, rise) / (alpha * alpha + 1); }), {}};
}

EngineLight gltf(double nv, double alpha, const Vec3& f0) {
  const ScaleBias table = scale_bias(nv, alpha, false);
  const double lost = 1 - table.whole(), rise = math::pow(1 - nv, 5), smooth = 1 - std::sqrt(alpha);
  const Vec3 out = each_channel(f0, [&](double f) {
    const double once = (f + (std::max(smooth, f) - f) * rise) * table.scale + table.bias,
                 mean = f + (1 - f) / 21;
    return once + lost * once * mean / (1 - mean * lost);
  });
  return {out, rest_of(out)};
}

}  // namespace

std::optional<EngineLight> engine_light(std::string_view model, double nv, double alpha, const Vec3& f0) {
  if (model == "as-unreal") return unreal(nv, alpha, f0);
  if (model == "as-unity-hdrp") return EngineLight{compensated(nv, alpha, f0), {}};
  if (model == "as-unity-urp") return unity_urp(nv, alpha, f0);
  if (model == "as-filament") return filament(nv, alpha, f0);
  if (model == "as-gltf") return gltf(nv, alpha, f0);
  return std::nullopt;
}

}  // namespace etak
