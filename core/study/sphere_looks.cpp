// SPDX-License-Identifier: Apache-2.0
#include "core/study/sphere_looks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {
namespace {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not all functions of the texts are used
namespace f64 {
#include "core/math/real_f64.h"

#include "core/fresnel/dielectric.glsl"

#include "core/light/clear_ball.glsl"

#include "core/light/transfer.glsl"

#include "core/light/tone.glsl"
}  // namespace f64
#pragma GCC diagnostic pop

constexpr int rays_per_side = 3;  // of a pixel

// F at the angles of a truth, which are equally far apart from 0 to 90 degrees.
using AngleTable = std::vector<Vec3>;

AngleTable reflectances_of(const FresnelTruth& truth, const FresnelForm& form) {
  const FresnelValues values = form.fit(truth);
  AngleTable out(truth.cosine.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out[i][c] = form.value(values[c].data(), truth.cosine[i]);
  return out;
}

// Linear between the angles.
Vec3 at_cosine(const AngleTable& table, double cosine) {
  const double steps = static_cast<double>(table.size() - 1);
  const double place = math::acos(std::clamp(cosine, 0.0, 1.0)) / (std::numbers::pi / 2) * steps;
  const auto first = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const double share = place - static_cast<double>(first);
  Vec3 out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = std::lerp(table[first][c], table[first + 1][c], share);
  return out;
}

// A point of the sphere that a sample of a pixel sees.
struct SeenPoint {
  double cosine = 1;  // between viewer and normal
  Vec3 light;         // from the mirror direction
  Vec3 through{};     // what a clear ball would show if its surface reflected nothing
};

// The light that a clear ball bends into view at the point with that normal.
//   eta   index of refraction
Vec3 seen_through(const Vec3& normal, double eta, const Vec3& passing, const Environment& around,
                  double gloss) {
  const f64::vec3 from = f64::beyond_ball({normal[0], normal[1], normal[2]}, {0, 0, 1}, eta);
  Vec3 out = around.specular({from.x, from.y, from.z}, gloss);
  const double way = f64::cosine_in_ball(normal[2], eta);  // inside of the ball, in diameters
  for (std::size_t c = 0; c < 3; ++c) out[c] *= math::pow(passing[c], way);
  return out;
}

// The samples of the pixel in column x of row y that meet the sphere.
//   eta   index of refraction of a clear ball
std::vector<SeenPoint> samples_of(int x, int y, const Environment& around, double eta,
                                  const SphereOptions& options) {
  std::vector<SeenPoint> out;
  for (int j = 0; j < rays_per_side; ++j)
    for (int i = 0; i < rays_per_side; ++i) {
      const double u = 2 * (x + (i + 0.5) / rays_per_side) / options.side - 1;
      const double v = 1 - 2 * (y + (j + 0.5) / rays_per_side) / options.side;
      const double square = u * u + v * v;
      if (square >= 1) continue;
      const double w = std::sqrt(1 - square);
      out.push_back({w, around.specular({2 * w * u, 2 * w * v, 2 * w * w - 1}, options.gloss)});
      if (options.passing)
        out.back().through = seen_through({u, v, w}, eta, *options.passing, around, options.gloss);
    }
  return out;
}

Vec3 displayed(const std::vector<SeenPoint>& samples, const AngleTable& table, double exposure) {
  Vec3 sum{};
  for (const SeenPoint& each : samples) {
    const Vec3 f = at_cosine(table, each.cosine);
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += f[c] * each.light[c] + (1 - f[c]) * (1 - f[c]) * each.through[c];
  }
  const double scale = exposure / static_cast<double>(samples.size());
  const f64::vec3 shown = f64::tone_neutral({scale * sum[0], scale * sum[1], scale * sum[2]});
  return {std::clamp(shown.x, 0.0, 1.0), std::clamp(shown.y, 0.0, 1.0), std::clamp(shown.z, 0.0, 1.0)};
}

}  // namespace

std::vector<SphereLook> sphere_looks(const FresnelTruth& truth, std::span<const FresnelForm* const> forms,
                                     const Environment& around, const SphereOptions& options) {
  constexpr std::size_t all_samples = rays_per_side * rays_per_side;
  const double eta = truth.three_wavelengths[0][1];  // of green, as the renderer takes it
  std::vector<AngleTable> tables{truth.rgb};
  for (const FresnelForm* form : forms) tables.push_back(reflectances_of(truth, *form));
  std::vector<SphereLook> out(tables.size());
  for (SphereLook& look : out) look.picture = Image8(options.side, options.side, 4);
  std::size_t judged = 0;
  for (int y = 0; y < options.side; ++y)
    for (int x = 0; x < options.side; ++x) {
      const std::vector<SeenPoint> samples = samples_of(x, y, around, eta, options);
      if (samples.empty()) continue;
      const bool whole = samples.size() == all_samples;
      judged += whole;
      std::optional<Lab> exact;
      for (std::size_t i = 0; i < tables.size(); ++i) {
        const Vec3 linear = displayed(samples, tables[i], options.exposure);
        const auto pixel = out[i].picture.at(x, y);
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = srgb_u8(linear[c]);
        pixel[3] = plain_u8(static_cast<double>(samples.size()) / all_samples);
        if (!whole) continue;
        const Lab lab = to_lab(to_rgb(linear));
        if (!exact) exact = lab;
        const double de = delta_e2000(*exact, lab);
        out[i].mean_de += de;
        out[i].worst_de = std::max(out[i].worst_de, de);
      }
    }
  for (SphereLook& look : out) look.mean_de /= static_cast<double>(std::max<std::size_t>(judged, 1));
  return out;
}

}  // namespace etak
