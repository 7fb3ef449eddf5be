// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/pages/f0/page_parts.h"
#include "core/study/fresnel_forms.h"

namespace etak {
namespace {

constexpr double ball_step_deg = 5;  // between the angles of a ball's rings

}  // namespace

std::string ball_paint(const Material& material, const Dataset& dataset, const F0Result& result,
                       const F0Options& options) {
  const std::string flat = hex(result.srgb8);
  const auto* optics = std::get_if<OpticalConstants>(&dataset.optics);
  if (optics == nullptr || result.refused()) return flat;
  FresnelTruth truth;
  try {
    truth = fresnel_truth(*optics, material.id, ball_step_deg, options);
  } catch (const Error&) {
    return flat;  // F0 is shown all the same; the page tells of the data beside it
  }
  std::string out = "radial-gradient(closest-side";
  for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
    const double radius = std::sqrt(1 - truth.cosine[i] * truth.cosine[i]);
    append(out, ',', hex(srgb_u8(to_rgb(truth.rgb[i]))), ' ', fixed(100 * radius, 1), '%');
  }
  return out += ')';
}

}  // namespace etak
