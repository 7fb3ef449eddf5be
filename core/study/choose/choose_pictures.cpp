// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0.h"
#include "core/material/seen_stack.h"
#include "core/math/functions.h"
#include "core/render/reference.h"
#include "core/study/choose/choose_models.h"

namespace etak {
namespace {

constexpr int plain_side = 128, textured_side = 48;
constexpr double first_level = -1, level_step = 0.5, last_level = 8;

Vec3 unit(const Vec3& v) {
  const double length = math::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// The directions of light and viewer in the frame of the surface, by their cosines with the normal and with
// each other. The lobes are isotropic, so that any tangent can be taken.
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

FresnelTruth colour_truth(const Vec3& f0) {
  FresnelTruth truth = fresnel_truth([&](double cosine) { return f_of_colour(f0, cosine); }, 0.25);
  truth.f0 = f0;
  return truth;
}

ChoosePictures::ChoosePictures(const ChooseSubject& subject)
    : subject_(subject), f0_varies_(!subject.dataset && subject.textured()) {
  const auto light = [&](const Vec3& travels, double irradiance) {
    const Vec3 t = unit(travels), towards{-t[0], -t[1], -t[2]};
    Light out{towards, irradiance, std::sqrt((1 + towards[2]) / 2), {}};
    if (subject.dataset) out.spectral_f = SeenStack(subject.dataset->optics)(out.lh);
    lights_.push_back(out);
  };
  // The viewer looks along -z.
  light({-0.5, -0.6, -0.6}, 2.0);
  light({0.8, -0.2, -0.5}, 0.7);
  light({-0.1, 0.7, 0.5}, 1.5);
}

// The texels, and the lobe under each light, which are the same for every look with this filter.
const ChoosePictures::Pixels& ChoosePictures::pixels_of(TextureFilter filter) const {
  auto& kept = pixels_[static_cast<std::size_t>(filter)];
  if (!kept.pixels.empty()) return kept;
  static const Term& lobe = *find_term(TermKind::distribution, "ggx");
  const bool textured = subject_.textured();
  const int side = textured ? textured_side : plain_side;
  const SurfaceTexel one =
      subject_.texture ? subject_.texture->read(TextureFilter::constant, 0, 0, 0) : subject_.texel;
  const double last = textured ? std::min<double>(last_level, subject_.texture->levels() - 1) : first_level;
  for (double level = first_level; level <= last; level += level_step) {
    // The sphere lies over the middle of the texture, `texels` texels to a pixel. Beyond its edges the
    // texture repeats.
    const double texels = math::exp2(level);
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = 2 * (i + 0.5) / side - 1, y = 1 - 2 * (j + 0.5) / side, r2 = x * x + y * y;
        if (r2 >= 1) continue;
        const Vec3 normal{x, y, std::sqrt(1 - r2)};
        Pixel pixel{one, 0, kept.samples.size(), 0};
        if (textured) {
          const TexelChain& texture = *subject_.texture;
          const auto place = [&](double at, int size) {
            const double t = size / 2.0 + texels * (at - side / 2.0);
            return t - size * std::floor(t / size);
          };
          pixel.texel =
              texture.read(filter, place(i + 0.5, texture.width()), place(j + 0.5, texture.height()), level);
        }
        pixel.alpha = lobe_alpha(pixel.texel);
        for (std::size_t l = 0; l < lights_.size(); ++l) {
          const double nl = dot(normal, lights_[l].direction), nv = normal[2];
          if (nl <= 0 || nv <= 0) continue;
          const Directions d = directions_of(nl, nv, lights_[l].direction[2]);
          kept.samples.push_back({l, nl, d, value_of(lobe, d, pixel.alpha)});
          ++pixel.sample_count;
        }
        kept.pixels.push_back(pixel);
      }
  }
  return kept;
}

// F by the form of the look, for each sample of the pixels.
const std::vector<Vec3>& ChoosePictures::fresnel_of(const Look& look) const {
  for (const Reflectances& each : fresnel_)
    if (each.form == look.form && each.filter == look.filter && each.values == look.values) return each.f;
  const Pixels& all = pixels_of(look.filter);
  Reflectances out{look.form, look.filter, look.values, {}};
  out.f.reserve(all.samples.size());
  for (const Pixel& pixel : all.pixels)
    for (std::size_t i = pixel.first_sample; i < pixel.first_sample + pixel.sample_count; ++i) {
      const Light& light = lights_[all.samples[i].light];
      Vec3 f = light.spectral_f;
      if (look.form != nullptr)
        for (std::size_t c = 0; c < 3; ++c) {
          ChannelValues p = look.values[c];
          if (f0_varies_) p[0] = pixel.texel.f0[c];
          f[c] = look.form->value(p.data(), light.lh);
        }
      else if (!subject_.dataset)
        f = f_of_colour(pixel.texel.f0, light.lh);
      out.f.push_back(f);
    }
  // Two are kept. The first is the exact F, which is needed with every masking; the latest is needed with
  // every masking or filter that is tried with its form.
  if (fresnel_.size() > 1) fresnel_.erase(fresnel_.begin() + 1, fresnel_.end());
  return fresnel_.emplace_back(std::move(out)).f;
}

std::vector<Vec3> ChoosePictures::draw(const Look& look) const {
  const Pixels& all = pixels_of(look.filter);
  if (look.model != nullptr) return draw_model(all, look);
  const std::vector<Vec3>& fresnel = fresnel_of(look);
  const Term& masking = *find_term(TermKind::visibility, look.visibility);
  std::vector<Vec3> out;
  out.reserve(all.pixels.size());
  for (const Pixel& pixel : all.pixels) {
    Vec3& sum = out.emplace_back(Vec3{0, 0, 0});
    for (std::size_t i = pixel.first_sample; i < pixel.first_sample + pixel.sample_count; ++i) {
      const LightSample& sample = all.samples[i];
      const double specular = sample.lobe * value_of(masking, sample.directions, pixel.alpha);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += lights_[sample.light].irradiance * sample.nl *
                  (specular * fresnel[i][c] + pixel.texel.diffuse[c] / std::numbers::pi);
    }
  }
  return out;
}

std::vector<Vec3> ChoosePictures::draw_model(const Pixels& all, const Look& look) const {
  std::vector<Vec3> out;
  out.reserve(all.pixels.size());
  for (const Pixel& pixel : all.pixels) {
    Vec3& sum = out.emplace_back(Vec3{0, 0, 0});
    const std::vector<double> numbers =
        whole_model_numbers(*look.model, f0_varies_ ? pixel.texel.f0 : look.f0, look.index, pixel.texel);
    for (std::size_t i = pixel.first_sample; i < pixel.first_sample + pixel.sample_count; ++i) {
      const LightSample& sample = all.samples[i];
      double specular[3];
      look.model->f64(sample.directions, numbers.data(), specular);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += lights_[sample.light].irradiance * sample.nl *
                  (specular[c] + pixel.texel.diffuse[c] / std::numbers::pi);
    }
  }
  return out;
}

PictureJudge::PictureJudge(ErrorUnit unit, const std::vector<Vec3>& everything) : unit_(unit) {
  double most = 0;
  for (const Vec3& pixel : everything) most = std::max({most, pixel[0], pixel[1], pixel[2]});
  if (most > 0) exposure_ = 1 / most;
  everything_.reserve(everything.size());
  for (const Vec3& pixel : everything) everything_.push_back(exposed(pixel));
  if (unit != ErrorUnit::delta_e) return;
  labs_.reserve(everything_.size());
  for (const Vec3& pixel : everything_) labs_.push_back(to_lab(to_rgb(pixel)));
}

Vec3 PictureJudge::exposed(const Vec3& pixel) const {
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = std::max(0.0, exposure_ * pixel[c]);
  return out;
}

PictureDifference PictureJudge::difference_of(const std::vector<Vec3>& chosen) const {
  PictureDifference out;
  for (std::size_t i = 0; i < everything_.size(); ++i) {
    const Vec3 pixel = exposed(chosen[i]);
    if (pixel == everything_[i]) continue;  // equal colours have no difference
    const double miss = unit_ == ErrorUnit::delta_e ? delta_e2000(labs_[i], to_lab(to_rgb(pixel)))
                                                    : difference(unit_, everything_[i], pixel);
    out.worst = std::max(out.worst, miss);
    out.mean += miss / static_cast<double>(everything_.size());
  }
  return out;
}

}  // namespace etak
