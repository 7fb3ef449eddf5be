// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation": multiple importance sampling,
//   the balance heuristic
#include "core/render/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/color/colorspace.h"
#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/fresnel/fresnel.h"
#include "core/light/area_lobes.h"
#include "core/render/backdrop.h"
#include "core/render/optics_grid.h"
#include "core/spectrum/integration.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr std::size_t fresnel_steps = 4096;

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

// Random numbers in [0, 1) that depend on pixel and sample alone (by the mixer of Steele et al. 2014,
// SplitMix).
class Random {
 public:
  // Both numbers are mixed first, because streams that start one step apart would be the same stream,
  // shifted, and show as streaks in the picture.
  Random(std::uint64_t pixel, std::uint64_t sample)
      : numbers_(SplitMix::mixed(SplitMix::mixed(pixel + 1) ^ (sample + 1) * 0xD1B54A32D192ED03u)),
        shift_x_(number_of(pixel, sample, 0x8CB92BA72F3D8DD7u)),
        shift_y_(number_of(pixel, sample, 0xABCC77118461CEFDu)) {}
  double next() { return numbers_.uniform(); }
  // Two numbers that stay the same.
  double shift_x() const { return shift_x_; }
  double shift_y() const { return shift_y_; }

 private:
  static double number_of(std::uint64_t pixel, std::uint64_t sample, std::uint64_t salt) {
    return SplitMix(SplitMix::mixed(pixel + salt) ^ (sample + 1) * 0xD1B54A32D192ED03u).uniform();
  }

  SplitMix numbers_;
  double shift_x_, shift_y_;
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

// Converts spectra of reflectance to linear sRGB.
struct Eye {
  Quadrature quadrature = make_quadrature(Method::nm1, {});
  Mat3 to_srgb;
  Eye() {
    const Xyz white = to_xyz(quadrature.white());
    to_srgb = xyz_to_rgb(RgbSpace::srgb, white, white);
  }
  Vec3 see(const GridIndex& index, double c) const {
    std::array<double, grid_size> reflectance{};
    etak::f64::fresnel_exact(index.n, index.k, c, reflectance);
    return to_srgb * quadrature.integrate(reflectance);
  }
};

// Shades points of the object.
class Shader {
 public:
  Shader(const Scene& scene, const Environment* environment, const SpectralFresnel* fresnel)
      : scene_(scene),
        environment_(environment),
        turn_(scene.environment_turn_deg),
        fresnel_(fresnel),
        exponent_(exponent_of_gloss(double{scene.surface.gloss})),
        specular_values_(seen_specular_values(scene)) {
    if (scene.specular != nullptr && fresnel_ != nullptr)
      lobe_ = lobe_of(*scene.specular, scene.specular_values);
    if (scene.diffuse != nullptr && !body_is_black(*scene.diffuse, scene.diffuse_values))
      diffuse_ = scene.diffuse;
    for (const Light& light : scene.lights.lights)
      if (is_area(light.kind)) areas_.push_back(light);
  }

  bool has_ambient() const { return environment_ != nullptr || scene_.lights.hemispheres.has_value(); }
  bool has_areas() const { return !areas_.empty(); }

  // f_r of the specular part plus opacity times that of the diffuse part, for directions in the frame of the
  // point.
  Vec3 reflectance(const Vec3& l, const Vec3& v) const {
    const Directions d{l[0], l[1], l[2], v[0], v[1], v[2]};
    Vec3 out{};
    if (lobe_) {
      const Vec3 bisector = l + v;
      const double lh = std::min(1.0, std::sqrt(dot(bisector, bisector)) / 2);
      double lobe[3];
      lobe_->model->f64(d, lobe_->values.data(), lobe);
      out = fresnel_->at(lh) * Vec3{lobe[0], lobe[1], lobe[2]};
    } else if (scene_.specular != nullptr) {
      double rgb[3];
      scene_.specular->f64(d, specular_values_.data(), rgb);
      out = {rgb[0], rgb[1], rgb[2]};
    }
    if (diffuse_ != nullptr) {
      double rgb[3];
      diffuse_->f64(d, scene_.diffuse_values.data(), rgb);
      out = out + Vec3{rgb[0], rgb[1], rgb[2]} * scene_.surface.opacity;
    }
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
          e *= f64::spot_share(-dot(to_light, light.direction), std::cos(light.inner_deg * pi / 180),
                               std::cos(light.outer_deg * pi / 180));
      }
      const Vec3 l = frame * to_light;
      if (l[2] <= 0 || e <= 0) continue;
      sum = sum + reflectance(l, v) * light.color * (e * l[2]);
    }
    return sum;
  }

  // One unbiased sample of the reflected light of the areas: one place on each, and one direction of the lobe.
  //   sample   of the ray: places of successive ones are spread by the golden ratio of two dimensions (Roberts 2018)
  Vec3 area_sample(const Vec3& position, const Mat3& frame, const Vec3& v, int sample,
                   const Random& random) const {
    Vec3 sum{};
    const double across = random.shift_x() + sample * 0.7548776662466927,
                 along = random.shift_y() + sample * 0.5698402909980532;
    const double x = across - std::floor(across), y = along - std::floor(along);
    for (const Light& light : areas_) {
      const Vec3 way = area_place(light, x, y) + position * -1;
      sum = sum + from_area(light, position, frame, v, frame * (way * (1 / std::sqrt(dot(way, way)))));
      sum = sum + from_area(light, position, frame, v, lobe_direction(v, x, y));
    }
    return sum;
  }

  // One unbiased sample of the reflected light from hemispheres and environment.
  Vec3 ambient_sample(const Mat3& frame, const Vec3& v, Random& random) const {
    const double pick = random.next(), a = random.next(), b = random.next();
    const bool by_light = environment_ != nullptr;
    const double share = by_light ? 1.0 / 3 : 0.5;
    Vec3 l;
    if (by_light && pick < share) {
      l = frame * turn_.from_map(environment_->sample(a, b));
    } else if (pick < 2 * share && (by_light || pick < share)) {
      const double radius = std::sqrt(a), phi = 2 * pi * b;
      l = {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1 - a)};
    } else {
      l = lobe_direction(v, a, b);
    }
    if (l[2] <= 0) return {};
    const Vec3 outside = out_of(frame, l);
    double pdf = share * (l[2] / pi + lobe_pdf(l, v));
    if (by_light) pdf += share * environment_->pdf(turn_.to_map(outside));
    if (!(pdf > 0)) return {};
    Vec3 radiance{};
    if (environment_ != nullptr) radiance = environment_->radiance(turn_.to_map(outside));
    if (scene_.lights.hemispheres) {
      const Hemispheres& h = *scene_.lights.hemispheres;
      radiance = radiance + (dot(outside, h.axis) > 0 ? h.upper : h.lower);
    }
    return reflectance(l, v) * radiance * (l[2] / pdf);
  }

  // The light that is seen through the object.
  //   behind   radiance of the background at the pixel
  Vec3 through(const Camera::Sight& sight, double nv, const Vec3& behind) const {
    if (scene_.surface.opacity >= 1) return {};
    if (environment_ != nullptr && is_clear_ball(scene_)) {
      const auto &n = sight.normal, &v = sight.viewer, &passing = *scene_.surface.passing;
      const double eta = scene_.surface.n[1];
      const f64::vec3 d = f64::beyond_ball({n[0], n[1], n[2]}, {v[0], v[1], v[2]}, eta),
                      share = f64::through_ball(std::clamp(nv, 0.0, 1.0), eta,
                                                {passing[0], passing[1], passing[2]});
      const Vec3 light = environment_->specular(turn_.to_map({d.x, d.y, d.z}), double{scene_.surface.gloss});
      return light * Vec3{share.x, share.y, share.z} * (1 - scene_.surface.opacity);
    }
    double f = 0;
    if (fresnel_ != nullptr)
      f = luminance_of(fresnel_->at(nv));
    else
      for (std::size_t c = 0; c < 3; ++c)
        f += luminance_weights<double>[c] *
             etak::f64::fresnel_exact(scene_.surface.n[c], scene_.surface.k[c], nv);
    return behind * ((1 - scene_.surface.opacity) * (1 - f));
  }

 private:
  // The half vector has the density nh^e over the hemisphere; the viewer is mirrored at it.
  Vec3 lobe_direction(const Vec3& v, double a, double b) const {
    const double nh = std::pow(a, 1 / (exponent_ + 1)), sine = std::sqrt(std::max(0.0, (1 - nh) * (1 + nh)));
    const double phi = 2 * pi * b;
    const Vec3 h{sine * std::cos(phi), sine * std::sin(phi), nh};
    return h * (2 * dot(h, v)) + v * -1;
  }
  double lobe_pdf(const Vec3& l, const Vec3& v) const {
    const Vec3 bisector = l + v;
    const double length = std::sqrt(dot(bisector, bisector));
    const double nh = bisector[2] / length, vh = length / 2;
    return (exponent_ + 1) / (2 * pi) * std::pow(nh, exponent_) / (4 * vh);
  }

  // What an area gives from direction `l`, over the sum of both densities of area_sample() there.
  Vec3 from_area(const Light& light, const Vec3& position, const Mat3& frame, const Vec3& v,
                 const Vec3& l) const {
    const double density = area_density(light, position, out_of(frame, l));
    if (l[2] <= 0 || density <= 0) return {};
    return reflectance(l, v) * light.color * (light.intensity * l[2] / (density + lobe_pdf(l, v)));
  }

  const Scene& scene_;
  std::vector<Light> areas_;
  const Environment* environment_;
  EnvironmentTurn turn_;
  const SpectralFresnel* fresnel_;
  const Model* diffuse_ = nullptr;
  double exponent_;
  std::vector<double> specular_values_;
  std::optional<Lobe> lobe_;
};

struct PixelSum {
  Vec3 color{};
  double hits = 0;
  double square_error = 0;
};

PixelSum draw_pixel(const Scene& scene, const Camera& camera, const SceneBackdrop& backdrop,
                    const Shader& shader, const ReferenceOptions& options, int column, int row) {
  PixelSum out;
  const int side = options.samples_per_side;
  const auto pixel = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(scene.width) +
                     static_cast<std::uint64_t>(column);
  // The variance of the ambient light is estimated for each pixel, over all its samples.
  double sum = 0, squares = 0, count = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = camera.x(column + (i % side + 0.5) / side), y = camera.y(row + (i / side + 0.5) / side);
    if (!camera.meets(x, y)) {
      out.color = out.color + backdrop.at(x, y);
      continue;
    }
    ++out.hits;
    const Camera::Sight sight = camera.sight(x, y);
    const Mat3 frame = frame_of(sight.normal);
    const Vec3 v = frame * sight.viewer;
    Vec3 light = shader.from_lights(sight.position, frame, v);
    if ((shader.has_ambient() || shader.has_areas()) && options.light_samples > 0) {
      Random random(pixel, static_cast<std::uint64_t>(i));
      Vec3 ambient{};
      for (int s = 0; s < options.light_samples; ++s) {
        Vec3 one{};
        if (shader.has_ambient()) one = shader.ambient_sample(frame, v, random) * scene.surface.occlusion;
        if (shader.has_areas()) one = one + shader.area_sample(sight.position, frame, v, s, random);
        ambient = ambient + one;
        const double y_one = luminance_of(one);
        sum += y_one;
        squares += y_one * y_one;
        ++count;
      }
      light = light + ambient * (1.0 / options.light_samples);
    }
    out.color = out.color + scene.surface.emission + light + shader.through(sight, v[2], backdrop.at(x, y));
  }
  const double rays = double(side) * side;
  out.color = out.color * (1 / rays);
  out.hits /= rays;
  if (count > 1) {
    const double variance = std::max(0.0, squares / count - (sum / count) * (sum / count));
    // The pixel's ambient light is out.hits times the mean of `count` samples.
    out.square_error = variance / count * out.hits * out.hits;
  }
  return out;
}

}  // namespace

SpectralFresnel::SpectralFresnel(const OpticalConstants& optics) : table_(fresnel_steps + 1) {
  const GridIndex index = grid_index(optics, "spectral Fresnel");
  const Eye eye;
  for (std::size_t i = 0; i <= fresnel_steps; ++i) table_[i] = eye.see(index, double(i) / fresnel_steps);
}

Vec3 SpectralFresnel::at(double c) const {
  const double at = std::clamp(c, 0.0, 1.0) * fresnel_steps;
  const auto i = std::min(static_cast<std::size_t>(at), fresnel_steps - 1);
  const double share = at - static_cast<double>(i);
  return table_[i] * (1 - share) + table_[i + 1] * share;
}

Vec3 SpectralFresnel::exact(const OpticalConstants& optics, double c) {
  return Eye().see(grid_index(optics, "spectral Fresnel"), c);
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
  std::size_t at = 0;
  for (const Parameter& parameter : out.model->parameters) {
    for (std::size_t c = 0; c < (parameter.color ? 3u : 1u); ++c, ++at) {
      switch (parameter.role) {
        case Role::f0:
        case Role::f82:
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
  struct RowError {
    double squares = 0, worst = 0, pixels = 0;
  };
  std::vector<RowError> errors(static_cast<std::size_t>(scene.height));
  parallel_chunks(errors.size(), options.threads, 1, [&](std::size_t index, std::size_t, unsigned worker) {
    const int row = static_cast<int>(index);
    for (int column = 0; column < scene.width; ++column) {
      const PixelSum pixel = draw_pixel(scene, camera, backdrop, shader, options, column, row);
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

AmbientError ambient_error(Scene scene, const Environment* environment, const ReferenceOptions& options) {
  scene.lights.lights.clear();
  const Reference reference = render_reference(scene, environment, options);
  Image quick;
  render_cpu(scene, environment, options.threads, Precision::f64, quick);
  AmbientError out;
  double level = 0, count = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const auto truth = reference.picture.at(x, y);
      const auto shown = quick.at(x, y);
      if (truth[3] < 1 || shown[3] < 1) continue;
      const double right = luminance_of({truth[0], truth[1], truth[2]});
      const double off = luminance_of({shown[0], shown[1], shown[2]}) - right;
      level += right;
      out.bias += off;
      out.mean += std::abs(off);
      out.worst = std::max(out.worst, std::abs(off));
      ++count;
    }
  if (count == 0 || level <= 0) return out;
  const double mean_level = level / count;
  out.mean /= level;
  out.bias /= level;
  out.worst /= mean_level;
  out.standard_error = reference.standard_error / mean_level;
  return out;
}

}  // namespace etak
