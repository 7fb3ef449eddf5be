// SPDX-License-Identifier: Apache-2.0
#include "core/study/ambient_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/color/gloss.h"
#include "core/math/functions.h"
#include "core/render/camera.h"
#include "core/study/sphere_pictures.h"

namespace etak {
namespace {

using std::numbers::pi;

// Half vectors of GGX's distribution.
struct HalfVectors {
  double alpha;
  Vec3 light(const Vec3& v, double a, double b) const {
    const double tan2 = alpha * alpha * a / (1 - a), nh = 1 / std::sqrt(1 + tan2), s = std::sqrt(tan2) * nh;
    const Vec3 h{s * math::cos(2 * pi * b), s * math::sin(2 * pi * b), nh};
    const double twice = 2 * dot(h, v);
    return {twice * h[0] - v[0], twice * h[1] - v[1], twice * h[2] - v[2]};
  }
  double pdf(double nh, double vh) const {
    const double t = (1 - nh) * (1 + nh) + nh * nh * alpha * alpha;
    return alpha * alpha / (pi * t * t) * nh / (4 * vh);
  }
};

// The directions of one pixel in the frame of its point, in the form of Model::f32_batch(), and the radiance from
// them times nl over the density.
struct Samples {
  std::array<std::vector<float>, 6> directions;
  std::array<std::vector<float>, 3> light, rgb;

  explicit Samples(std::size_t count) {
    for (auto& each : directions) each.resize(count);
    for (auto& each : light) each.resize(count);
    for (auto& each : rgb) each.resize(count);
  }

  void draw(const Environment& environment, const Mat3& frame, const Vec3& v, double gloss,
            std::uint64_t pixel) {
    const std::array lobes{HalfVectors{alpha_of_gloss(gloss)},
                           HalfVectors{std::min(1.0, 4 * alpha_of_gloss(gloss))}};
    SplitMix random(SplitMix::mixed(pixel + 1));
    const double shift_a = random.uniform(), shift_b = random.uniform();
    const std::size_t count = light[0].size();
    for (std::size_t i = 0; i < count; ++i) {
      // Points of the plane that are spread evenly (Roberts's sequence), shifted anew for each pixel; neighbours in the
      // sequence go to different kinds of sampling.
      const double n = double(i / 4 + 1), a = std::fmod(shift_a + n * 0.7548776662466927, 1),
                   b = std::fmod(shift_b + n * 0.5698402909980532, 1);
      Vec3 l;
      if (i % 4 == 0) {
        const double radius = std::sqrt(a);
        l = {radius * math::cos(2 * pi * b), radius * math::sin(2 * pi * b), std::sqrt(1 - a)};
      } else if (i % 4 == 3) {
        l = frame * environment.sample(a, b);
      } else {
        l = lobes[i % 4 - 1].light(v, a, b);
      }
      Vec3 seen{};
      if (l[2] > 0) {
        const Vec3 bisector{l[0] + v[0], l[1] + v[1], l[2] + v[2]};
        const double length = std::sqrt(dot(bisector, bisector)), nh = bisector[2] / length;
        Vec3 outside{};
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t axis = 0; axis < 3; ++axis) outside[k] += frame[axis][k] * l[axis];
        const double pdf = (l[2] / pi + lobes[0].pdf(nh, length / 2) + lobes[1].pdf(nh, length / 2) +
                            environment.pdf(outside)) /
                           4;
        const Vec3 radiance = environment.radiance(outside);
        for (std::size_t k = 0; k < 3; ++k) seen[k] = radiance[k] * l[2] / pdf / double(count);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        directions[k][i] = static_cast<float>(l[k]);
        directions[3 + k][i] = static_cast<float>(v[k]);
        light[k][i] = static_cast<float>(seen[k]);
      }
    }
  }

  // Adds the light that a model reflects: of all samples, and of the first half.
  void add(const Model& model, const double* values, double factor, Vec3& all, Vec3& half) {
    const float* in[6];
    float* out[3];
    for (std::size_t i = 0; i < 6; ++i) in[i] = directions[i].data();
    for (std::size_t i = 0; i < 3; ++i) out[i] = rgb[i].data();
    const std::size_t count = light[0].size();
    model.f32_batch(count, in, values, out);
    for (std::size_t c = 0; c < 3; ++c) {
      double sums[2] = {0, 0};
      for (std::size_t i = 0; i < count; ++i)
        sums[i < count / 2 ? 0 : 1] += double(rgb[c][i]) * double(light[c][i]);
      half[c] += 2 * factor * sums[0];
      all[c] += factor * (sums[0] + sums[1]);
    }
  }
};

Mat3 frame_of(const Vec3& n) {
  const double length2 = n[0] * n[0] + n[2] * n[2], inverse = 1 / std::sqrt(std::max(length2, 1e-12));
  const Vec3 t = length2 < 1e-12 ? Vec3{1, 0, 0} : Vec3{n[2] * inverse, 0, -n[0] * inverse};
  return {{t, {n[1] * t[2], n[2] * t[0] - n[0] * t[2], -n[1] * t[0]}, n}};
}

}  // namespace

std::vector<AmbientTruth> ambient_truths(std::span<const Scene> scenes, const Environment& environment,
                                         std::size_t samples, unsigned threads) {
  std::vector<AmbientTruth> out;
  if (scenes.empty()) return out;
  const int side = scenes.front().width;
  for (std::size_t i = 0; i < scenes.size(); ++i) out.push_back({Image(side, side, 3), Image(side, side, 3)});
  const std::vector<bool> judged = sphere_pixels(side);
  const Camera camera(scenes.front());
  parallel_chunks(static_cast<std::size_t>(side), threads, 1, [&](std::size_t row, std::size_t, unsigned) {
    Samples drawn(samples);
    for (int x = 0; x < side; ++x) {
      const auto pixel = row * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
      if (!judged[pixel]) continue;
      const Camera::Sight sight = camera.sight(camera.x(x + 0.5), camera.y(static_cast<int>(row) + 0.5));
      const Mat3 frame = frame_of(sight.normal);
      drawn.draw(environment, frame, frame * sight.viewer, scenes.front().surface.gloss, pixel);
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Scene& scene = scenes[i];
        Vec3 all{}, half{};
        if (scene.specular != nullptr)
          drawn.add(*scene.specular, seen_specular_values(scene).data(), 1, all, half);
        if (scene.diffuse != nullptr)
          drawn.add(*scene.diffuse, scene.diffuse_values.data(), scene.surface.opacity, all, half);
        for (std::size_t c = 0; c < 3; ++c) {
          out[i].picture.values[3 * pixel + c] = static_cast<float>(all[c]);
          out[i].halves.values[3 * pixel + c] = static_cast<float>(half[c]);
        }
      }
    }
  });
  return out;
}

AmbientDifference ambient_difference(const AmbientTruth& truth, const Image& shown) {
  const std::vector<bool> judged = sphere_pixels(shown.width);
  const double exposure = 1 / brightest(truth.picture, judged);
  const auto differences = [&](const Image& picture) {
    const SeenPicture right = seen(truth.picture, exposure, judged), other = seen(picture, exposure, judged);
    std::vector<double> out;
    for (std::size_t i = 0; i < judged.size(); ++i)
      if (judged[i]) out.push_back(delta_e2000(right.lab[i], other.lab[i]));
    std::sort(out.begin(), out.end());
    return out;
  };
  const auto mean = [](const std::vector<double>& all) {
    double sum = 0;
    for (const double each : all) sum += each;
    return sum / double(all.size());
  };
  const std::vector<double> off = differences(shown);
  return {mean(off), off[off.size() * 99 / 100], off.back(), mean(differences(truth.halves))};
}

}  // namespace etak
