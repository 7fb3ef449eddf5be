// SPDX-License-Identifier: Apache-2.0
#include "core/report/choose_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/material/f0.h"
#include "core/render/reference.h"

namespace etak {
namespace {

constexpr int plain_side = 128, textured_side = 48;
constexpr double first_level = -1, level_step = 0.5, last_level = 8;

Vec3 unit(const Vec3& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Light and viewer in the frame of the surface; the lobes are isotropic, so any tangent will do.
Directions directions_of(double nl, double nv, double lv) {
  const double sl = std::sqrt(std::max(0.0, 1 - nl * nl)), sv = std::sqrt(std::max(0.0, 1 - nv * nv));
  const double across = sl * sv;
  const double cos_turn = across > 0 ? std::clamp((lv - nl * nv) / across, -1.0, 1.0) : 1;
  return {sl, 0, nl, sv * cos_turn, sv * std::sqrt(std::max(0.0, 1 - cos_turn * cos_turn)), nv};
}

double value_of(const Term& term, const Directions& d, double alpha) {
  double rgb[3] = {0, 0, 0};
  term.f64(d, &alpha, rgb);
  return rgb[0];
}

}  // namespace

Vec3 f_of_colour(const Vec3& f0, double cosine) {
  static const FresnelForm& form = *fresnel_form("by_f0");
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = form.value(&f0[c], cosine);
  return out;
}

ChoosePictures::ChoosePictures(const ChooseSubject& subject)
    : subject_(subject), f0_varies_(!subject.dataset && subject.textured()) {
  const auto light = [&](const Vec3& travels, double irradiance) {
    const Vec3 t = unit(travels), towards{-t[0], -t[1], -t[2]};
    Light out{towards, irradiance, std::sqrt((1 + towards[2]) / 2), {}};
    if (subject.dataset)
      out.spectral_f = SpectralFresnel::exact(std::get<OpticalConstants>(subject.dataset->optics), out.lh);
    lights_.push_back(out);
  };
  // The viewer looks along -z.
  light({-0.5, -0.6, -0.6}, 2.0);
  light({0.8, -0.2, -0.5}, 0.7);
  light({-0.1, 0.7, 0.5}, 1.5);
}

void ChoosePictures::shade(const Look& look, const Vec3& normal, const SurfaceTexel& texel, Vec3& out) const {
  static const Term& lobe = *find_term(TermKind::distribution, "ggx");
  const Term& masking = *find_term(TermKind::visibility, look.visibility);
  const double alpha = lobe_alpha(texel), nv = normal[2];
  out = {0, 0, 0};
  for (const Light& light : lights_) {
    const double nl = dot(normal, light.direction);
    if (nl <= 0 || nv <= 0) continue;
    const Directions d = directions_of(nl, nv, light.direction[2]);
    const double specular = value_of(lobe, d, alpha) * value_of(masking, d, alpha);
    Vec3 f = light.spectral_f;
    if (look.form != nullptr)
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, 4> p = look.values[c];
        if (f0_varies_) p[0] = texel.f0[c];
        f[c] = look.form->value(p.data(), light.lh);
      }
    else if (!subject_.dataset)
      f = f_of_colour(texel.f0, light.lh);
    for (std::size_t c = 0; c < 3; ++c)
      out[c] += light.irradiance * nl * (specular * f[c] + texel.diffuse[c] / std::numbers::pi);
  }
}

std::vector<Vec3> ChoosePictures::draw(const Look& look) const {
  std::vector<Vec3> out;
  const bool textured = subject_.textured();
  const int side = textured ? textured_side : plain_side;
  const SurfaceTexel one =
      subject_.texture ? subject_.texture->read(TextureFilter::constant, 0, 0, 0) : subject_.texel;
  const double last = textured ? std::min<double>(last_level, subject_.texture->levels() - 1) : first_level;
  for (double level = first_level; level <= last; level += level_step) {
    // The sphere lies over the texture's middle, one pixel so many texels wide; what is beyond the edges
    // begins anew.
    const double texels = std::exp2(level);
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = 2 * (i + 0.5) / side - 1, y = 1 - 2 * (j + 0.5) / side, r2 = x * x + y * y;
        if (r2 >= 1) continue;
        SurfaceTexel texel = one;
        if (textured) {
          const TexelChain& texture = *subject_.texture;
          const auto place = [&](double at, int size) {
            const double t = size / 2.0 + texels * (at - side / 2.0);
            return t - size * std::floor(t / size);
          };
          texel = texture.read(look.filter, place(i + 0.5, texture.width()), place(j + 0.5, texture.height()),
                               level);
        }
        shade(look, {x, y, std::sqrt(1 - r2)}, texel, out.emplace_back());
      }
  }
  return out;
}

PictureDifference picture_difference(ErrorUnit unit, const std::vector<Vec3>& everything,
                                     const std::vector<Vec3>& chosen) {
  double most = 0;
  for (const Vec3& pixel : everything) most = std::max({most, pixel[0], pixel[1], pixel[2]});
  const double exposure = most > 0 ? 1 / most : 1;
  PictureDifference out;
  for (std::size_t i = 0; i < everything.size(); ++i) {
    Vec3 a{}, b{};
    for (std::size_t c = 0; c < 3; ++c)
      a[c] = std::max(0.0, exposure * everything[i][c]), b[c] = std::max(0.0, exposure * chosen[i][c]);
    const double miss = difference(unit, a, b);
    out.worst = std::max(out.worst, miss);
    out.mean += miss / static_cast<double>(everything.size());
  }
  return out;
}

}  // namespace etak
