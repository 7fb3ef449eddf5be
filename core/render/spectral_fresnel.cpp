// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/color/colorspace.h"
#include "core/fresnel/fresnel.h"
#include "core/render/optics_grid.h"
#include "core/render/reference.h"
#include "core/spectrum/integration.h"

namespace etak {
namespace {

constexpr std::size_t fresnel_steps = 4096;

// n and k on the grid, relative to the outside medium.
GridIndex relative_index(const OpticalConstants& optics, const OutsideMedium& outside,
                         std::string_view what) {
  GridIndex index = grid_index(optics, what);
  GridIndex medium;
  if (const auto* constants = std::get_if<OpticalConstants>(&outside.index))
    medium = grid_index(*constants, outside.label);
  else
    medium.n.fill(std::get<double>(outside.index));
  for (std::size_t i = 0; i < grid_size; ++i) {
    index.n[i] /= medium.n[i];
    index.k[i] /= medium.n[i];
  }
  return index;
}

}  // namespace

SeenFresnel::SeenFresnel(const Optics& optics, std::string_view what, const F0Options& seen)
    : quadrature_(make_quadrature(Method::nm1, seen.viewing)) {
  const Quadrature d65 = make_quadrature(Method::nm1, {seen.viewing.observer, Illuminant::d65});
  to_srgb_ = xyz_to_rgb(RgbSpace::srgb, to_xyz(quadrature_.white()), to_xyz(d65.white()));
  if (const auto* stack = std::get_if<Stack>(&optics))
    stack_.emplace(*stack, seen);
  else
    index_ = relative_index(std::get<OpticalConstants>(optics), seen.outside, what);
}

Vec3 SeenFresnel::operator()(double cosine) const {
  if (stack_) return (*stack_)(cosine);
  std::array<double, grid_size> reflectance{};
  etak::f64::fresnel_exact(index_->n, index_->k, cosine, reflectance);
  return rgb(reflectance);
}

SpectralFresnel::SpectralFresnel(const Optics& optics) : table_(fresnel_steps + 1) {
  const SeenFresnel seen(optics);
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
