// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation": multiple importance sampling,
//   the balance heuristic
//   Sloan and Joe 1994, "Lattice Methods for Multiple Integration": rank-1 lattices; Cranley and Patterson 1976:
//   their random shift, whose spread over independent shifts is the error that is stated
#include "core/render/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/color/luminance.h"
#include "core/fresnel/fresnel.h"
#include "core/light/area_lobes.h"
#include "core/math/functions.h"
#include "core/render/backdrop.h"
#include "core/render/lobe_density.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

using std::numbers::pi;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // of dielectric.glsl only the form for one index is used
namespace f64 {
#include "core/math/real_f64.h"

#include "core/fresnel/dielectric.glsl"

#include "core/light/lights.glsl"

#include "core/light/clear_ball.glsl"
}  // namespace f64
#pragma GCC diagnostic pop

using etak::operator*;
Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec3 operator*(const Vec3& a, const Vec3& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
Vec3 operator*(const Vec3& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}

// The places of `count` samples in the unit square: those of a rank-1 lattice by the golden ratio, shifted by two
// random numbers that depend on the pixel and on the stream alone.
class Lattice {
 public:
  Lattice(std::uint64_t pixel, std::uint64_t stream, std::size_t count)
      : count_(static_cast<double>(std::max<std::size_t>(count, 1))) {
    // Both numbers are mixed first, because streams that start one step apart would be the same stream,
    // shifted, and show as streaks in the picture.
    SplitMix numbers(SplitMix::mixed(SplitMix::mixed(pixel + 1) ^ (stream + 1) * 0xD1B54A32D192ED03u));
    shift_ = {numbers.uniform(), numbers.uniform()};
  }
  std::array<double, 2> at(std::size_t i) const {
    const double k = static_cast<double>(i), a = k / count_ + shift_[0],
                 b = k / std::numbers::phi + shift_[1];
    return {a - std::floor(a), b - std::floor(b)};
  }

 private:
  double count_;
  std::array<double, 2> shift_{};
};

// The frame of a surface point: tangent, bitangent and normal as rows.
Mat3 frame_of(const Vec3& n) {
  const double length2 = n[0] * n[0] + n[2] * n[2];
  const double inverse = 1 / std::sqrt(std::max(length2, 1e-12));
  const Vec3 t = length2 < 1e-12 ? Vec3{1, 0, 0} : Vec3{n[2] * inverse, 0, -n[0] * inverse};
  return {{t, {n[1] * t[2], n[2] * t[0] - n[0] * t[2], -n[1] * t[0]}, n}};
}

Vec3 out_of(const Mat3& frame, const Vec3& local) {
  return frame[0] * local[0] + frame[1] * local[1] + frame[2] * local[2];
}

// Shades points of the object.
class Shader {
 public:
  Shader(const Scene& scene, const Environment* environment, const SpectralFresnel* fresnel)
      : scene_(scene),
        environment_(environment),
        turn_(scene.environment_turn_deg),
        fresnel_(fresnel),
        specular_values_(seen_specular_values(scene)) {
    if (scene.diffuse != nullptr && !body_is_black(*scene.diffuse, scene.diffuse_values))
      diffuse_ = scene.diffuse;
    for (const Light& light : scene.lights.lights)
      if (is_area(light.kind)) areas_.push_back(light);
    if (scene.specular == nullptr) return;
    if (fresnel_ != nullptr) lobe_ = lobe_of(*scene.specular, scene.specular_values);
    bodiless_values_ = without_body(*scene.specular, specular_values_);
    density_.emplace(*scene.specular, bodiless_values_);
  }

  bool has_ambient() const { return environment_ != nullptr || scene_.lights.hemispheres.has_value(); }
  bool has_areas() const { return !areas_.empty(); }

  // f_r of the specular part plus opacity times that of the diffuse part, for directions in the frame of the
  // point.
  Vec3 reflectance(const Vec3& l, const Vec3& v) const { return specular(l, v) + body(l, v); }

  Vec3 specular(const Vec3& l, const Vec3& v) const {
    if (!lobe_) return scene_.specular == nullptr ? Vec3{} : f_r(*scene_.specular, bodiless_values_, l, v);
    const Vec3 bisector = l + v;
    const double lh = std::min(1.0, std::sqrt(dot(bisector, bisector)) / 2);
    const Vec3 once = fresnel_->at(lh) * f_r(*lobe_->model, lobe_->values, l, v);
    if (!scene_.specular->compensated()) return once;
    // Light between facets has the colours of the model itself.
    return once + f_r(*scene_.specular, bodiless_values_, l, v) +
           f_r(*lobe_->model, bodiless_values_, l, v) * -1;
  }

  // What the whole model of kind both has beside its specular part, or the diffuse model.
  Vec3 body(const Vec3& l, const Vec3& v) const {
    Vec3 out{};
    if (scene_.specular != nullptr && bodiless_values_ != specular_values_)
      out =
          f_r(*scene_.specular, specular_values_, l, v) + f_r(*scene_.specular, bodiless_values_, l, v) * -1;
    if (diffuse_ != nullptr) out = out + f_r(*diffuse_, scene_.diffuse_values, l, v) * scene_.surface.opacity;
    return out;
  }

  Vec3 from_lights(const Vec3& position, const Mat3& frame, const Vec3& v) const {
    Vec3 sum{};
    for (const Light& light : scene_.lights.lights) {
      if (is_area(light.kind)) continue;
      Vec3 to_light = light.direction * -1;
      double e = light.intensity * (scene_.lights.pi_scaled ? pi : 1);
      if (light.kind != LightKind::directional) {
        const Vec3 way = light.position + position * -1;
        const double r = std::max(std::sqrt(dot(way, way)), point_light_min_r);
        to_light = way * (1 / r);
        e *= f64::point_irradiance(f64::vec3(1), r).x;
        if (light.kind == LightKind::spot)
          e *= f64::spot_share(-dot(to_light, light.direction), math::cos(light.inner_deg * pi / 180),
                               math::cos(light.outer_deg * pi / 180));
      }
      const Vec3 l = frame * to_light;
      if (l[2] <= 0 || e <= 0) continue;
      sum = sum + reflectance(l, v) * light.color * (e * l[2]);
    }
    return sum;
  }

  // A point whose light is sampled: its place and frame, and the viewer in that frame.
  struct Point {
    Vec3 position;
    Mat3 frame;
    Vec3 v;
    double occlusion;
  };

  // The sampled light that the points of a pixel reflect, as means that several independent sets of samples give,
  // and how many samples each of these sets has.
  static constexpr std::size_t set_count = 8;
  struct Estimates {
    std::array<Vec3, set_count> mean{};
    std::array<double, set_count> count{};
  };

  // Integrates the light of hemispheres and environment over both parts of the model, and that of areas.
  //   samples   of each part for each point
  Estimates sampled(const std::vector<Point>& points, int samples, std::uint64_t pixel) const {
    Estimates out;
    const bool by_light = environment_ != nullptr && environment_->contrast() > even_contrast;
    const std::size_t each = std::max<std::size_t>(1, static_cast<std::size_t>(samples) / (by_light ? 2 : 1));
    const std::size_t total = points.size() * each;
    // Adds the mean of sample(point, number of the set, number of the sample in it) to each set.
    const auto add = [&](double factor, const auto& sample) {
      for (std::size_t set = 0; set < set_count; ++set) {
        std::size_t taken = 0;
        Vec3 sum{};
        for (std::size_t t = 0; t < total; ++t)
          // Every set has samples of all points, where there are enough of them.
          if ((t / points.size() + t) % set_count == set)
            sum = sum + sample(points[t % points.size()], set, taken++);
        out.count[set] = static_cast<double>(taken);
        if (taken > 0) out.mean[set] = out.mean[set] + sum * (factor / out.count[set]);
      }
    };
    const auto lattice = [&](std::size_t set, std::size_t kind) {
      return Lattice(pixel, 5 * set + kind, total / set_count);
    };
    for (const bool lobe : {true, false}) {
      if (!has_ambient() || (lobe ? scene_.specular == nullptr : !has_body())) continue;
      add(1, [&](const Point& point, std::size_t set, std::size_t i) {
        Vec3 one =
            weighted(point, own_direction(lobe, point.v, lattice(set, lobe ? 0 : 1).at(i)), lobe, by_light);
        if (by_light) {
          const auto [a, b] = lattice(set, lobe ? 2 : 3).at(i);
          one =
              one + weighted(point, point.frame * turn_.from_map(environment_->sample(a, b)), lobe, by_light);
        }
        return one * point.occlusion;
      });
    }
    if (has_areas())
      add(1, [&](const Point& point, std::size_t set, std::size_t i) {
        return from_areas(point, lattice(set, 4).at(i));
      });
    return out;
  }

  // The light that is seen through the object.
  //   behind   radiance of the background at the pixel
  Vec3 through(const Camera::Sight& sight, double nv, const Vec3& behind) const {
    if (scene_.surface.opacity >= 1) return {};
    if (environment_ != nullptr && is_clear_ball(scene_)) {
      const auto &n = sight.normal, &v = sight.viewer, &passing = *scene_.surface.passing;
      const auto& layers = scene_.surface.layers;
      const double eta = layers ? layers->n : scene_.surface.n[1], cosine = std::clamp(nv, 0.0, 1.0);
      const f64::vec3 d = f64::beyond_ball({n[0], n[1], n[2]}, {v[0], v[1], v[2]}, eta),
                      body{passing[0], passing[1], passing[2]};
      const Vec3 twice = layers ? layers->twice.at(cosine) : Vec3{};
      const f64::vec3 share = layers ? f64::through_layers(cosine, eta, body, {twice[0], twice[1], twice[2]})
                                     : f64::through_ball(cosine, eta, body);
      const Vec3 light = environment_->specular(turn_.to_map({d.x, d.y, d.z}), double{scene_.surface.gloss});
      return light * Vec3{share.x, share.y, share.z} * (1 - scene_.surface.opacity);
    }
    double f = 0;
    if (scene_.surface.layers)
      f = 1 - std::sqrt(std::clamp(luminance_of(scene_.surface.layers->twice.at(nv)), 0.0, 1.0));
    else if (fresnel_ != nullptr)
      f = luminance_of(fresnel_->at(nv));
    else
      for (std::size_t c = 0; c < 3; ++c)
        f += luminance_weights<double>[c] *
             etak::f64::fresnel_exact(scene_.surface.n[c], scene_.surface.k[c], nv);
    return behind * ((1 - scene_.surface.opacity) * (1 - f));
  }

 private:
  // The light of the areas by one sample: a place on each, and a direction of the lobe.
  Vec3 from_areas(const Point& point, const std::array<double, 2>& at) const {
    Vec3 sum{};
    for (const Light& light : areas_) {
      const Vec3 way = area_place(light, at[0], at[1]) + point.position * -1;
      sum = sum + from_area(light, point, point.frame * (way * (1 / std::sqrt(dot(way, way)))));
      if (density_) sum = sum + from_area(light, point, own_direction(true, point.v, at));
    }
    return sum;
  }

  // What an area gives from direction `l`, over the sum of both densities of from_areas() there.
  Vec3 from_area(const Light& light, const Point& point, const Vec3& l) const {
    if (l[2] <= 0) return {};
    const double density = area_density(light, point.position, out_of(point.frame, l));
    if (density <= 0) return {};
    return reflectance(l, point.v) * light.color *
           (light.intensity * l[2] / (density + (density_ ? lobe_pdf(l, point.v) : 0)));
  }

  double lobe_pdf(const Vec3& l, const Vec3& v) const {
    const Vec3 bisector = l + v;
    const double length = std::sqrt(dot(bisector, bisector));
    return density_->pdf(math::atan2(math::hypot(bisector[0], bisector[1]), bisector[2])) / (2 * length);
  }

  const Scene& scene_;
  std::vector<Light> areas_;
  const Environment* environment_;
  EnvironmentTurn turn_;
  const SpectralFresnel* fresnel_;
  const Model* diffuse_ = nullptr;
  std::vector<double> specular_values_, bodiless_values_;
  std::optional<Lobe> lobe_;
  std::optional<LobeDensity> density_;

  // An environment whose brightest direction is not brighter than this, over the mean, needs no samples by its
  // light: those by cosine and lobe have less variance there, and none for Lambert under an even light.
  static constexpr double even_contrast = 4;

  static Vec3 f_r(const Model& model, const std::vector<double>& values, const Vec3& l, const Vec3& v) {
    double rgb[3];
    model.f64({l[0], l[1], l[2], v[0], v[1], v[2]}, values.data(), rgb);
    return {rgb[0], rgb[1], rgb[2]};
  }

  bool has_body() const {
    return diffuse_ != nullptr || (scene_.specular != nullptr && bodiless_values_ != specular_values_);
  }

  // A direction by the lobe of the specular part, or by the cosine for the diffuse part.
  Vec3 own_direction(bool lobe, const Vec3& v, const std::array<double, 2>& at) const {
    const double phi = 2 * pi * at[1];
    if (!lobe) {
      const double radius = std::sqrt(at[0]);
      return {radius * math::cos(phi), radius * math::sin(phi), std::sqrt(1 - at[0])};
    }
    const double theta = density_->polar(at[0]);
    const Vec3 h{math::sin(theta) * math::cos(phi), math::sin(theta) * math::sin(phi), math::cos(theta)};
    const double vh = dot(h, v);
    return vh > 0 ? h * (2 * vh) + v * -1 : Vec3{0, 0, -1};
  }

  // The reflected light from direction l over the density of the samples there, which both strategies give.
  Vec3 weighted(const Point& point, const Vec3& l, bool lobe, bool by_light) const {
    if (l[2] <= 0) return {};
    const Vec3 outside = out_of(point.frame, l);
    double pdf = lobe ? lobe_pdf(l, point.v) : l[2] / pi;
    if (by_light) pdf += environment_->pdf(turn_.to_map(outside));
    if (!(pdf > 0)) return {};
    Vec3 radiance{};
    if (environment_ != nullptr) radiance = environment_->radiance(turn_.to_map(outside));
    if (scene_.lights.hemispheres) {
      const Hemispheres& h = *scene_.lights.hemispheres;
      radiance = radiance + (dot(outside, h.axis) > 0 ? h.upper : h.lower);
    }
    return (lobe ? specular(l, point.v) : body(l, point.v)) * radiance * (l[2] / pdf);
  }
};

struct PixelSum {
  Vec3 color{};
  double hits = 0;
  double square_error = 0;
};

// Adds the mean of the estimates to the colour, and its squared standard error, which is that of means of sets.
void add_sampled(const Shader::Estimates& estimates, double hits, PixelSum& out) {
  double total = 0, sets = 0, squares = 0;
  for (const double count : estimates.count) {
    total += count;
    sets += count > 0;
  }
  Vec3 mean{};
  for (std::size_t i = 0; i < estimates.mean.size(); ++i)
    mean = mean + estimates.mean[i] * (estimates.count[i] / total);
  for (std::size_t i = 0; i < estimates.mean.size(); ++i) {
    const double off = luminance_of(estimates.mean[i]) - luminance_of(mean);
    squares += math::pow(estimates.count[i] / total * off, 2);
  }
  out.color = out.color + mean * hits;
  if (sets > 1) out.square_error = squares * sets / (sets - 1) * hits * hits;
}

// What all pixels of a picture share.
struct Drawing {
  const Scene& scene;
  const Camera& camera;
  const SceneBackdrop& backdrop;
  const Shader& shader;
  const ReferenceOptions& options;
};

PixelSum draw_pixel(const Drawing& drawing, int column, int row) {
  const auto& [scene, camera, backdrop, shader, options] = drawing;
  PixelSum out;
  const int side = options.samples_per_side;
  const auto pixel = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(scene.width) +
                     static_cast<std::uint64_t>(column);
  std::vector<Shader::Point> points;
  for (int i = 0; i < side * side; ++i) {
    const double x = camera.x(column + (i % side + 0.5) / side), y = camera.y(row + (i / side + 0.5) / side);
    if (!camera.meets(x, y)) {
      out.color = out.color + backdrop.at(x, y);
      continue;
    }
    const Camera::Sight sight = camera.sight(x, y);
    const Mat3 frame = frame_of(sight.normal);
    const auto [r, g, b, occlusion] = emission_at(scene, texture_place(scene.shape, sight.position));
    points.push_back({sight.position, frame, frame * sight.viewer, occlusion});
    const Vec3& v = points.back().v;
    out.color = out.color + Vec3{r, g, b} + shader.from_lights(sight.position, frame, v) +
                shader.through(sight, v[2], backdrop.at(x, y));
  }
  out.hits = static_cast<double>(points.size());
  if ((shader.has_ambient() || shader.has_areas()) && options.light_samples > 0 && !points.empty())
    add_sampled(shader.sampled(points, options.light_samples, pixel), out.hits, out);
  const double rays = double(side) * side;
  out.color = out.color * (1 / rays);
  out.hits /= rays;
  out.square_error /= rays * rays;
  return out;
}

}  // namespace

Reference render_reference(const Scene& scene, const Environment* environment,
                           const ReferenceOptions& options, const RowsDone& rows_done) {
  validate(scene);
  Reference out;
  out.picture = Image(scene.width, scene.height, 4);
  std::optional<SpectralFresnel> fresnel;
  if (scene.surface.optics && scene.specular != nullptr) fresnel.emplace(*scene.surface.optics);
  const Shader shader(scene, environment, fresnel ? &*fresnel : nullptr);
  const Camera camera(scene);
  const SceneBackdrop backdrop(scene, environment, camera);
  const Drawing drawing{scene, camera, backdrop, shader, options};
  struct RowError {
    double squares = 0, worst = 0, pixels = 0;
  };
  std::vector<RowError> errors(static_cast<std::size_t>(scene.height));
  parallel_chunks(errors.size(), options.threads, 1, [&](std::size_t index, std::size_t, unsigned worker) {
    const int row = static_cast<int>(index);
    for (int column = 0; column < scene.width; ++column) {
      const PixelSum pixel = draw_pixel(drawing, column, row);
      const auto values = out.picture.at(column, row);
      for (std::size_t c = 0; c < 3; ++c) values[c] = static_cast<float>(pixel.color[c]);
      values[3] = static_cast<float>(pixel.hits);
      if (pixel.hits == 0) continue;
      errors[index].squares += pixel.square_error;
      errors[index].worst = std::max(errors[index].worst, std::sqrt(pixel.square_error));
      ++errors[index].pixels;
    }
    if (rows_done) rows_done(1, worker);
  });
  RowError all;
  for (const RowError& row : errors) {
    all.squares += row.squares;
    all.pixels += row.pixels;
    all.worst = std::max(all.worst, row.worst);
  }
  out.standard_error = all.pixels > 0 ? std::sqrt(all.squares / all.pixels) : 0;
  out.worst_error = all.worst;
  return out;
}

}  // namespace etak
