// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/color/colorspace.h"
#include "core/material/seen_stack.h"
#include "core/render/reference.h"
#include "core/spectrum/integration.h"

namespace etak {
namespace {

constexpr std::size_t fresnel_steps = 4096;

}  // namespace

SpectralFresnel::SpectralFresnel(const Optics& optics) : table_(fresnel_steps + 1) {
  const SeenStack seen(optics);
  for (std::size_t i = 0; i <= fresnel_steps; ++i) table_[i] = seen(double(i) / fresnel_steps);
}

Vec3 SpectralFresnel::at(double c) const {
  const double at = std::clamp(c, 0.0, 1.0) * fresnel_steps;
  const auto i = std::min(static_cast<std::size_t>(at), fresnel_steps - 1);
  const double share = at - static_cast<double>(i);
  Vec3 out{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    out[channel] = table_[i][channel] * (1 - share) + table_[i + 1][channel] * share;
  return out;
}

std::optional<Lobe> lobe_of(const Model& model, const std::vector<double>& values) {
  Lobe out{&model, values};
  bool has_fresnel = false;
  // Schueler's Optimized has a hidden Fresnel term K / lh. Its lobe is taken from the bounded form, where
  // K = 1 gives F = 1.
  if (model.id == "schueler-optimized")
    if (const Model* bounded = find_model("schueler-optimized-bounded");
        bounded && bounded->value_count() == values.size())
      out.model = bounded;
  if (model.compensated())
    out.model = find_model("microfacet:" + std::string(model.distribution->id) + ',' +
                           std::string(model.fresnel->id) + ",smith-height");
  std::size_t at = 0;
  for (const Parameter& parameter : out.model->parameters) {
    for (std::size_t c = 0; c < (parameter.color ? 3u : 1u); ++c, ++at) {
      switch (parameter.role) {
        case Role::f0:
        case Role::f82:
        case Role::curve:
          out.values[at] = 1;
          has_fresnel = true;
          break;
        case Role::n:
          out.values[at] = 1;
          break;
        case Role::k:
          out.values[at] = 1e6;
          has_fresnel = true;
          break;  // F = 1 - 4e-12
        case Role::diffuse:
          if (values[at] != 0) return std::nullopt;
          break;
        default:
          break;
      }
    }
  }
  if (!has_fresnel) return std::nullopt;
  return out;
}

}  // namespace etak
