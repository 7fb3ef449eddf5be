// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/ambient.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>

#include "core/color/gloss.h"
#include "core/math/functions.h"
#include "core/math/quadrature.h"
#include "core/render/ambient/engine_light.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/ambient/round_lobe.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr int gloss_rows = 5, views_of_rows = 12, gloss_rows_of_samples = 33, azimuth_rows = 64;
constexpr std::size_t azimuths = 16;
constexpr std::array<double, 3> fitted_f0{0.04, 0.5, 1};

// Half vectors with their solid angles, on rings around the normal: at even steps of the logarithm of the polar angle for
// narrow lobes, of the angle itself for wide ones.
struct HalfVector {
  Vec3 h;
  double solid_angle;
};
//   around   of the azimuth: pi for one half, whose mirror image is the other one, and is counted for it; 2 pi for all
std::vector<HalfVector> half_vectors(double around) {
  constexpr double first = 3e-5, log_step = 0.2, angle_step = 0.06;
  const auto step_at = [](double angle) { return 1 / (1 / (log_step * angle) + 1 / angle_step); };
  std::vector<HalfVector> out;
  for (double angle = first; angle < pi / 2; angle += step_at(angle + step_at(angle) / 2)) {
    // The first ring stands for the disc within it, too.
    const double step = angle == first ? first / 2 * (1 + log_step) : step_at(angle), s = math::sin(angle);
    for (std::size_t j = 0; j < azimuths; ++j) {
      const double phi = around * (double(j) + 0.5) / azimuths;
      out.push_back(
          {{s * math::cos(phi), s * math::sin(phi), math::cos(angle)}, s * step * 2 * pi / azimuths});
    }
  }
  return out;
}

// Pairs of directions in the form of Model::f32_batch(), with a weight each.
struct Pairs {
  std::array<std::vector<float>, 6> directions;
  std::vector<float> weights;
  std::array<std::vector<float>, 3> rgb;

  void clear() {
    for (auto& each : directions) each.clear();
    weights.clear();
  }
  void add(const Vec3& l, const Vec3& v, double weight) {
    for (std::size_t i = 0; i < 3; ++i) {
      directions[i].push_back(static_cast<float>(l[i]));
      directions[3 + i].push_back(static_cast<float>(v[i]));
    }
    weights.push_back(static_cast<float>(weight));
  }
  void evaluate(const Model& model, const double* values) {
    for (auto& each : rgb) each.resize(weights.size());
    const float* in[6];
    float* out[3];
    for (std::size_t i = 0; i < 6; ++i) in[i] = directions[i].data();
    for (std::size_t i = 0; i < 3; ++i) out[i] = rgb[i].data();
    model.f32_batch(weights.size(), in, values, out);
  }
  Vec3 sum() const {
    Vec3 out{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < weights.size(); ++i) out[c] += double(rgb[c][i]) * double(weights[i]);
    return out;
  }
};

Vec3 viewer_at(double nv) {
  return {std::sqrt(std::max(0.0, (1 - nv) * (1 + nv))), 0, nv};
}

Vec3 turned(const Vec3& d, double azimuth) {
  const double c = math::cos(azimuth), s = math::sin(azimuth);
  return {d[0] * c - d[1] * s, d[0] * s + d[1] * c, d[2]};
}

// The pairs of light and viewer that half vectors all around belong to; the weights are those of f_r in the albedo.
//   turns   in how many directions the surface is turned about its normal
void add_half_vectors(double nv, int turns, Pairs& pairs) {
  static const std::vector<HalfVector> half = half_vectors(pi), whole = half_vectors(2 * pi);
  const Vec3 v = viewer_at(nv);
  for (const auto& [h, solid_angle] : turns > 1 ? whole : half) {
    const double vh = v[0] * h[0] + v[2] * h[2];
    const Vec3 l{2 * vh * h[0] - v[0], 2 * vh * h[1], 2 * vh * h[2] - v[2]};
    if (!(vh > 0) || !(l[2] > 0)) continue;
    const double weight = l[2] * 4 * vh * solid_angle / turns;
    if (turns == 1) {
      pairs.add(l, v, weight);
      continue;
    }
    for (int turn = 0; turn < turns; ++turn) {
      const double azimuth = (turn + 0.5) * pi / turns;
      pairs.add(turned(l, azimuth), turned(v, azimuth), weight);
    }
  }
}

// The albedo of the body by directions that are spread as the cosine.
Vec3 body_albedo(const Model& model, const std::vector<double>& values, double nv, Pairs& pairs) {
  constexpr std::size_t heights = 16;
  static const GaussLegendre<heights> rule;
  pairs.clear();
  const Vec3 v = viewer_at(nv);
  for (std::size_t i = 0; i < heights; ++i)
    for (std::size_t j = 0; j < azimuths; ++j) {
      const double up = (1 + rule.node[i]) / 2, s = std::sqrt((1 - up) * (1 + up)),
                   phi = pi * (double(j) + 0.5) / azimuths;
      pairs.add({s * math::cos(phi), s * math::sin(phi), up}, v, up * rule.weight[i] / 2 * 2 * pi / azimuths);
    }
  pairs.evaluate(model, values.data());
  return pairs.sum();
}

void set_role(const Model& model, Role role, double value, std::vector<double>& values) {
  std::size_t at = 0;
  for (const Parameter& each : model.parameters)
    for (std::size_t c = 0; c < (each.color ? 3u : 1u); ++c, ++at)
      if (each.role == role) values[at] = value;
}

bool any_follows(const Model& model, bool f0) {
  return std::ranges::any_of(model.parameters, [&](const Parameter& each) {
    return follows_texture(model, each) && each.role != Role::diffuse && (each.role == Role::f0) == f0;
  });
}

bool is_anisotropic(const Model& model, const std::vector<double>& values) {
  for (const double angle : {0.05, 0.3, 0.8})
    for (const double azimuth : {0.3, 1.2}) {
      const Vec3 v = viewer_at(0.8), l = turned(viewer_at(math::cos(angle)), azimuth);
      double here[3], there[3];
      const auto at = [&](double turn, double rgb[3]) {
        const Vec3 a = turned(l, turn), b = turned(v, turn);
        model.f64({a[0], a[1], a[2], b[0], b[1], b[2]}, values.data(), rgb);
      };
      at(0, here);
      at(pi / 2, there);
      if (std::abs(here[1] - there[1]) > 1e-6 * std::max(here[1], there[1])) return true;
    }
  return false;
}

// The view of a node.
double view_of(int i, int views) {
  const double x = double(i) / (views - 1);
  return std::max(x * x, 1e-3);
}

// In straighter views than this the plane of normal and viewer is lost, and with it the tilt of a lobe.
constexpr double straightest_fit = 0.98;

// The tilt of a direction in the plane of normal n and viewer: the one along (1 - tilt) n + tilt r with the mirrored
// viewer r.
double tilt_of(double angle, double nv) {
  const double s = std::sqrt((1 - nv) * (1 + nv));
  return math::sin(angle) / (s * math::cos(angle) + math::sin(angle) * (1 - nv));
}

Vec3 quadratic(const Vec3& at, const Vec3& values) {
  const double slope = (values[1] - values[0]) / (at[1] - at[0]);
  const double bend = ((values[2] - values[1]) / (at[2] - at[1]) - slope) / (at[2] - at[0]);
  return {values[0] - slope * at[0] + bend * at[0] * at[1], slope - bend * (at[0] + at[1]), bend};
}

void append(std::vector<float>& out, const Vec3& v) {
  for (const double each : v) out.push_back(static_cast<float>(each));
}

// The light of pairs, with directions along the tangent of each pair's own viewer.
void take_samples(const Pairs& pairs, std::vector<LobeSample>& samples) {
  const auto& d = pairs.directions;
  samples.resize(pairs.weights.size());
  for (std::size_t j = 0; j < samples.size(); ++j) {
    const float inverse = 1 / std::sqrt(d[3][j] * d[3][j] + d[4][j] * d[4][j]);
    samples[j] = {-(d[0][j] * d[3][j] + d[1][j] * d[4][j]) * inverse,
                  (d[1][j] * d[3][j] - d[0][j] * d[4][j]) * inverse, d[2][j],
                  (pairs.rgb[0][j] + pairs.rgb[1][j] + pairs.rgb[2][j]) * pairs.weights[j]};
  }
}

// The directional albedo, or its coefficients where `of_f0`; `pairs` keep what it is made of.
Vec3 albedo_at(const Model& model, const std::vector<double>& values, double nv, int turns, bool of_f0,
               Pairs& pairs) {
  pairs.clear();
  add_half_vectors(nv, turns, pairs);
  pairs.evaluate(model, values.data());
  return of_f0 ? quadratic(fitted_f0, pairs.sum()) : pairs.sum();
}

// One row of nodes, for one gloss.
void add_row(const Model& model, const std::vector<double>& values, AmbientTable& out) {
  Pairs pairs;
  std::vector<LobeSample> samples;
  const int turns = out.anisotropic ? 4 : 1;
  Probes last;
  double sharpest = 0;
  const std::size_t before = out.albedo.size() / 3;
  out.albedo.resize(3 * (before + static_cast<std::size_t>(out.views)));
  for (auto& each : out.probes) each.resize(out.albedo.size());
  // From straight views to grazing ones, so that each fit begins at that of the view before.
  for (int i = out.views - 1; i >= 0; --i) {
    const double nv = view_of(i, out.views);
    const Vec3 albedo = albedo_at(model, values, nv, turns, out.of_f0, pairs);
    const std::size_t at = 3 * (before + static_cast<std::size_t>(i));
    for (std::size_t c = 0; c < 3; ++c) out.albedo[at + c] = static_cast<float>(albedo[c]);
    // The lobe changes slowly with the view: every second node has a fit of its own.
    const bool first = i + 1 == out.views;
    if (i > 0 && (out.views - 1 - i) % 2 == 1) continue;
    const double seen = std::min(nv, straightest_fit);
    if (seen < nv) (void)albedo_at(model, values, seen, turns, out.of_f0, pairs);
    take_samples(pairs, samples);
    // Half vectors around the normal are stretched by 1 / nv along the plane of normal and viewer, or narrowed across
    // it; a level is a factor of 2^0.75 in width. F narrows a lobe as much again.
    last = fitted_probes(samples, first ? nullptr : &last, math::acos(seen),
                         std::max(0.0, sharpest + 2 * math::log2(seen) / 0.75));
    if (first) sharpest = std::ranges::min(last, {}, &Probe::level).level;
    for (std::size_t k = 0; k < probe_count; ++k) {
      const Vec3 probe{tilt_of(last[k].angle, seen), last[k].level, last[k].share};
      for (std::size_t c = 0; c < 3; ++c) out.probes[k][at + c] = static_cast<float>(probe[c]);
    }
  }
  for (auto& numbers : out.probes)
    for (int i = out.views - 2; i > 0; i -= 2)
      for (std::size_t at = 3 * (before + static_cast<std::size_t>(i)), end = at + 3; at < end; ++at)
        numbers[at] = (numbers[at - 3] + numbers[at + 3]) / 2;
}

// The values of a scene's surface that a table depends on.
struct Surface {
  const Model *specular, *diffuse;
  std::vector<double> specular_values, diffuse_values;
  Textured textured;
  bool refined;
  friend bool operator==(const Surface&, const Surface&) = default;
};

// The ambient term of an engine at a view, where the model has one; its first values are diffuse colour, F0 and alpha.
std::optional<EngineLight> light_of_engine(const Model& model, const std::vector<double>& values, double nv) {
  if (model.kind != ModelKind::combined || values.size() < 7) return std::nullopt;
  return engine_light(model.id, nv, values[6], {values[3], values[4], values[5]});
}

// One row of nodes for one gloss of an engine: a round lobe of its roughness along the mirrored viewer.
void add_engine_row(const Model& model, const std::vector<double>& values, AmbientTable& out) {
  const double gloss = std::clamp(gloss_of_exponent(exponent_of_alpha(values[6])), 0.0, 1.0);
  for (int i = 0; i < out.views; ++i) {
    const Vec3 albedo = light_of_engine(model, values, view_of(i, out.views))->specular;
    append(out.albedo, out.of_f0 ? quadratic(fitted_f0, albedo) : albedo);
    append(out.probes[0], {1, level_of_gloss(gloss), 1});
    append(out.probes[1], {1, level_of_gloss(gloss), 0});
  }
}

void add_specular(const Surface& surface, AmbientTable& out) {
  const Model& model = *surface.specular;
  std::vector<double> values = surface.specular_values;
  set_role(model, Role::diffuse, 0, values);
  out.anisotropic = is_anisotropic(model, values);
  out.of_f0 = surface.textured.f0 && any_follows(model, true);
  if (surface.textured.gloss && any_follows(model, false)) {
    out.glosses = gloss_rows;
    out.views = views_of_rows;
  }
  // The textures' values in place of the surface's.
  TexturedValues at_texel(model, values);
  const auto values_at = [&](double gloss) {
    const double* here = at_texel.at({0, 0, 0, 1}, {fitted_f0[0], fitted_f0[1], fitted_f0[2], gloss});
    std::size_t at = 0;
    for (const Parameter& each : model.parameters)
      for (std::size_t c = 0; c < (each.color ? 3u : 1u); ++c, ++at) {
        const double* own = surface.specular_values.data() + at - c;
        // One F82 for the three F0 of a node: its mean.
        if (out.of_f0 && each.role == Role::f82)
          values[at] = (own[0] + own[1] + own[2]) / 3;
        else if (each.role == Role::f0 ? out.of_f0 : out.glosses > 1)
          values[at] = here[at];
      }
  };
  const bool varies = out.of_f0 || out.glosses > 1;
  const auto each_gloss = [&](int rows, const auto& add) {
    for (int row = 0; row < rows; ++row) {
      if (varies) values_at(rows > 1 ? double(row) / (rows - 1) : 0);
      add(row);
    }
  };
  const bool of_engine = light_of_engine(model, values, 1).has_value();
  each_gloss(out.glosses, [&](int) { (of_engine ? add_engine_row : add_row)(model, values, out); });
  // An anisotropic lobe that changes with the texel would need rows of both.
  if (!surface.refined || of_engine || (out.anisotropic && out.glosses > 1)) return;
  out.samples.by_azimuth = out.anisotropic;
  if (out.glosses > 1 || out.anisotropic) {
    out.samples.rows = out.anisotropic ? azimuth_rows : gloss_rows_of_samples;
    out.samples.views = 24;
  }
  each_gloss(out.samples.rows, [&](int row) {
    const double azimuth = out.anisotropic ? pi * row / azimuth_rows : 0;
    set_lobe_samples(model, values, out.of_f0, azimuth, row, out.samples);
    for (int view = 0; out.of_f0 && view < out.samples.views; ++view) {
      const auto to = out.samples.picture.at(2 * out.samples.count, row * out.samples.views + view);
      const Vec3 albedo = quadratic(fitted_f0, {to[0], to[1], to[2]});
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(albedo[c]);
    }
  });
}

void add_body(const Surface& surface, AmbientTable& out) {
  const bool combined = surface.diffuse == nullptr;
  const Model* model = combined ? surface.specular : surface.diffuse;
  if (model == nullptr || (combined && model->kind != ModelKind::combined)) return;
  std::vector<double> white = combined ? surface.specular_values : surface.diffuse_values, black = white;
  set_role(*model, Role::diffuse, 1, white);
  set_role(*model, Role::diffuse, 0, black);
  Pairs pairs;
  for (int i = 0; i < out.views; ++i) {
    Vec3 albedo = body_albedo(*model, white, view_of(i, out.views), pairs);
    if (combined) {
      const Vec3 mirror = body_albedo(*model, black, view_of(i, out.views), pairs);
      for (std::size_t c = 0; c < 3; ++c) albedo[c] -= mirror[c];
      const auto light = light_of_engine(*model, white, view_of(i, out.views));
      if (light && light->body) albedo = *light->body;
    }
    append(out.body, albedo);
    for (const double each : albedo) out.plain_body = out.plain_body && std::abs(each - 1) < 1e-4;
  }
}

}  // namespace

Textured held_by_textures(const Scene& scene) {
  return {scene.textured().f0, scene.textured().gloss};
}

HemisphereForm hemisphere_form(const Scene& scene) {
  const HemisphereForm asked =
      scene.lights.hemispheres ? scene.lights.hemispheres->form : HemisphereForm::model;
  if (asked != HemisphereForm::automatic) return asked;
  const bool of_schueler = scene.specular != nullptr && scene.specular->source.starts_with("Schueler");
  return of_schueler && !scene.refined ? HemisphereForm::corrected : HemisphereForm::model;
}

std::shared_ptr<const AmbientTable> ambient_table(const Scene& scene, const Textured& textured) {
  constexpr std::size_t most = 16;
  static std::mutex guard;
  static std::deque<std::pair<Surface, std::shared_ptr<const AmbientTable>>> made;  // the newest first
  const Surface surface{scene.specular,       scene.diffuse, scene.specular_values,
                        scene.diffuse_values, textured,      scene.refined};
  {
    const std::lock_guard lock(guard);
    for (const auto& [of, table] : made)
      if (of == surface) return table;
  }
  auto out = std::make_shared<AmbientTable>();
  if (surface.specular != nullptr) add_specular(surface, *out);
  add_body(surface, *out);
  const std::lock_guard lock(guard);
  if (made.size() >= most) made.pop_back();
  made.emplace_front(surface, out);
  return out;
}

Scene with_bright_lights(const Scene& scene, const Environment* environment, unsigned threads) {
  Scene out = scene;
  // Under textures a model is evaluated texel by texel, which takes too long for so many lights; and lights are
  // not occluded texel by texel.
  const bool textured = scene.textured().values() || scene.textured().occlusion;
  if (!scene.refined || environment == nullptr || scene.specular == nullptr || textured) return out;
  out.bright_apart = ambient_table(scene, held_by_textures(scene))->samples.wide;
  if (!out.bright_apart) return out;
  const EnvironmentTurn turn(scene.environment_turn_deg);
  // As light of the environment, they are hidden by what occludes it, and not counted in Schueler's units.
  const double share = scene.surface.occlusion / (scene.lights.pi_scaled ? pi : 1);
  for (const LightSamples::Bright& bright : environment->samples(true, threads).bright) {
    Light light;
    light.direction = scaled(turn.from_map(bright.from), -1);
    light.color = scaled(bright.irradiance, share);
    out.lights.lights.push_back(light);
  }
  return out;
}

std::string ambient_remark(const Scene& scene, const Textured& textured) {
  if (scene.specular == nullptr || (!scene.lights.hemispheres && scene.lights.environment.empty())) return "";
  const std::string light = "; under hemispheres and environment ", id(scene.specular->id);
  const auto table = ambient_table(scene, textured);
  if (table->anisotropic && table->samples.empty())
    return "the lobe of " + id + " depends on how the surface is turned about its normal" + light +
           "round lobes stand for it";
  if (table->glosses > 1 || table->of_f0)
    return "F0 or gloss of " + id + " follow a texture" + light + "its albedo is a quadratic in F0" +
           (table->glosses > 1 ? ", and it is linear between five glosses" : "");
  return "";
}

}  // namespace etak
