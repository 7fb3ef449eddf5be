// SPDX-License-Identifier: Apache-2.0
// Draws the picture of a scene. There is no include guard: include this behind shade_chunk.h and the
// functions respond() and respond_far(), which evaluate a model.

// The values that all chunks of a picture share.
struct Shading {
  const Scene& scene;
  const Environment* environment;
  const LightSamples* samples = nullptr;  // what a refined picture sees of the environment
  Camera camera;
  SceneBackdrop backdrop;
  EnvironmentTurn turn;
  // The models; null where a model gives no light.
  const Model* specular;
  const Model* diffuse;
  std::vector<double> specular_values;
  std::vector<ChunkLight> lights;
  std::vector<ChunkArea> areas;
  AreaTable area_lobes;
  bool textured;      // whether models take values from textures
  bool with_diffuse;  // whether there is diffuse light, from `diffuse` or from a specular model of kind both
  bool needs_positions = false, needs_viewers;
  bool far = false;  // the viewer is at infinity, and the models have loops for directional lights
  double f0_luminance;
  bool in_zone = false;
  bool clear_ball;
  std::shared_ptr<const AmbientTable> ambient;  // null where no light comes from all around

  Shading(const Scene& s, const Environment* e)
      : scene(s),
        environment(e),
        camera(s),
        backdrop(s, e, camera),
        turn(s.environment_turn_deg),
        specular(s.specular),
        diffuse(s.diffuse),
        specular_values(seen_specular_values(s)),
        textured(s.textured().values()) {
    if (diffuse != nullptr && body_is_black(*diffuse, s.diffuse_values)) diffuse = nullptr;
    const bool combined = specular != nullptr && specular->kind == ModelKind::combined;
    with_diffuse = diffuse != nullptr || (combined && !body_is_black(*specular, s.specular_values));
    if (textured) {
      diffuse = s.diffuse;
      with_diffuse = diffuse != nullptr || combined;
    }
    needs_positions = s.textures != nullptr;
    f0_luminance = etak::luminance_of(s.surface.f0);
    if (s.lights.hemispheres || e != nullptr) ambient = ambient_table(s, held_by_textures(s));
    needs_viewers =
        s.lights.hemispheres.has_value() || e != nullptr || camera.turned() || s.textured().normal;
    const Vec3& viewer = camera.axes()[2];
    const double scale = s.lights.pi_scaled ? std::numbers::pi : 1;
    clear_ball = is_clear_ball(s) && e != nullptr;
    in_zone = zone_of(f0_luminance) == Zone::inside;
    far = !camera.perspective() && has_far_respond && !textured;
    for (const Model* model : {specular, diffuse}) far = far && (model == nullptr || model->has_far_loop());
    for (const Light& light : s.lights.lights) {
      if (is_area(light.kind)) {
        add_area(light);
        continue;
      }
      const bool directional = light.kind == LightKind::directional;
      needs_positions |= !directional;
      const double sign = directional ? -1 : 1;
      const double radian = std::numbers::pi / 180;
      const double power = light.intensity * scale;
      const double hx = sign * light.direction[0] + viewer[0], hy = sign * light.direction[1] + viewer[1],
                   hz = sign * light.direction[2] + viewer[2];
      // Light from straight behind the object has no half vector; the object is dark under it.
      const double length = std::max(std::sqrt(hx * hx + hy * hy + hz * hz), 1e-30);
      lights.push_back({directional, light.kind == LightKind::spot, real(light.position[0]),
                        real(light.position[1]), real(light.position[2]), real(sign * light.direction[0]),
                        real(sign * light.direction[1]), real(sign * light.direction[2]),
                        real(math::cos(light.inner_deg * radian)), real(math::cos(light.outer_deg * radian)),
                        narrowed({light.color[0] * power, light.color[1] * power, light.color[2] * power}),
                        real(hx / length), real(hy / length), real(hz / length), length / 2});
    }
    if (!areas.empty() && specular != nullptr)
      area_lobes = area_table(*specular, specular_values, textured && width_follows_texture(*specular));
  }

  void add_area(const Light& light) {
    ChunkArea area{{}, narrowed(scaled(light.color, light.intensity))};
    const AreaAxes axes = area_axes(light);
    for (const auto& [x, y] : area_cut(light)) {
      Vec3 corner = light.position;
      for (std::size_t i = 0; i < 3; ++i) corner[i] += axes.right[i] * x + axes.up[i] * y;
      area.corners.push_back(narrowed(corner));
    }
    areas.push_back(std::move(area));
    needs_positions = needs_viewers = true;
  }

  // Whether the background is seen through the object, and whether the object may get stripes.
  bool clear() const { return (textured || scene.surface.opacity < 1) && !clear_ball; }
  // The factor of the diffuse part: the diffuse colour of a texel holds its opacity already.
  real opacity() const { return textured ? real(1) : real(scene.surface.opacity); }
  bool marked() const { return scene.mark_zone || scene.mark_angles || !scene.mark_energy.empty(); }
};

// A piece of a row that becomes one chunk: the columns from `first` on. The object covers the columns
// [whole_first, whole_last) wholly.
struct Piece {
  int row, first;
  std::size_t whole_first, whole_last;  // counted from `first`
};

// Fills the positions, normals and viewers of the chunk.
void place_points(const Shading& shading, const Piece& piece, Chunk& c) {
  const Camera& camera = shading.camera;
  const double y = camera.y(piece.row + 0.5);
  const bool flat = camera.shape() == Shape::quad;
  const bool quick = !flat && !camera.perspective();
  if (quick) {
    sphere_points(c, camera.x(piece.first + 0.5), camera.pixel(), y);
    if (camera.turned()) turn_points(c, camera.axes());
    if (shading.needs_viewers)
      for (std::size_t axis = 0; axis < 3; ++axis)
        c.viewer[axis].fill(c.whole_blocks, real(camera.axes()[2][axis]));
  }
  for (std::size_t i = 0; i < c.count; ++i) {
    if (quick && i == piece.whole_first) i = piece.whole_last;
    if (i >= c.count) break;
    const Camera::Sight sight = camera.sight(camera.x(piece.first + static_cast<int>(i) + 0.5), y);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.position[axis][i] = real(sight.position[axis]);
      c.normal[axis][i] = real(sight.normal[axis]);
      c.viewer[axis][i] = real(sight.viewer[axis]);
    }
  }
  if (!quick || !shading.needs_positions) return;
  // The sphere has radius 1 and lies at the origin, so the position of a point is its normal.
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::copy_n(c.normal[axis].values.begin(), c.whole_blocks, c.position[axis].values.begin());
}

#include "core/render/shade/shade_textures.h"

// Adds the light of hemispheres and environment.
void reflect_ambient(const Shading& shading, Chunk& c) {
  const Scene& scene = shading.scene;
  const bool textured = shading.textured, with_specular = shading.specular != nullptr;
  const real gloss = real(scene.surface.gloss);
  const SameSurface same{{narrowed(scene.surface.f0), narrowed(scene.surface.diffuse), gloss}};
  const TexturedSurface of_texture{c};
  if (scene.lights.hemispheres) {
    const Hemispheres& h = *scene.lights.hemispheres;
    const ChunkHemispheres narrow{hemisphere_form(scene), narrowed(h.axis), narrowed(h.lower),
                                  narrowed(h.upper)};
    if (textured)
      add_hemispheres(c, narrow, *shading.ambient, of_texture, with_specular, shading.with_diffuse);
    else
      add_hemispheres(c, narrow, *shading.ambient, same, with_specular, shading.with_diffuse);
  }
  if (shading.environment != nullptr) {
    const TurnedEnvironment around{*shading.environment, shading.samples, shading.turn};
    if (textured)
      add_environment(c, around, *shading.ambient, of_texture, with_specular, shading.with_diffuse);
    else
      add_environment(c, around, *shading.ambient, same, with_specular, shading.with_diffuse);
  }
}

#include "core/render/shade/shade_shadow.h"

void shade(const Shading& shading, Chunk& c) {
  const Scene& scene = shading.scene;
  const std::size_t count = c.whole_blocks;
  const bool textured = shading.textured;
  if (textured) look_up_textures(shading, c);
  if (scene.textured().normal) bend_normals(shading, c);
  build_frames(c, !shading.camera.perspective() && !shading.camera.turned());
  const bool with_specular = shading.specular != nullptr;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    c.specular[channel].fill(count, 0);
    if (shading.with_diffuse) c.diffuse[channel].fill(count, 0);
  }
  const bool occluded = scene.mesh || scene.textured().occlusion || scene.surface.occlusion < 1,
             emits = scene.surface.emission != Vec3{};
  if (occluded || emits) look_up_emission(scene, c);
  if (occluded) {
    reflect_ambient(shading, c);
    for (Triple* sum : {&c.specular, &c.diffuse})
      for (Lane& lane : *sum)
        for (std::size_t i = 0; i < count; ++i) lane[i] *= c.occlusion[i];
  }
  const auto reflect = [&](const Model& model, const std::vector<double>& values, const ChunkLight* far,
                           const vec3& color, Triple& sum) {
    const Range reached = lit_blocks(c);
    if (reached.first == reached.last) return;
    if (textured)
      respond_textured(model, values, reached, c);
    else if (far != nullptr)
      respond_far(model, values.data(), far->lh, reached, c);
    else
      respond(model, values.data(), reached, c);
    add_light(c, reached, color, sum);
  };
  for (const ChunkLight& light : shading.lights) {
    const bool far = shading.far && light.directional;
    if (far)
      aim_far(c, light);
    else if (light.directional)
      aim_directional(c, light.dx, light.dy, light.dz);
    else
      aim_point(c, light);
    if (scene.mesh) hide_light(shading, light, c);
    if (with_specular)
      reflect(*shading.specular, shading.specular_values, far ? &light : nullptr, light.color, c.specular);
    if (shading.diffuse != nullptr)
      reflect(*shading.diffuse, scene.diffuse_values, far ? &light : nullptr, light.color, c.diffuse);
  }
  if (with_specular && !shading.areas.empty()) find_area_lobes(c, shading.area_lobes, textured);
  for (const ChunkArea& area : shading.areas)
    for (std::size_t at = 0; at < area.corners.size(); at += 4) {
      if (scene.mesh) find_visible(shading, &area.corners[at], c);
      if (with_specular) {
        aim_area(c, &area.corners[at], true);
        if (scene.mesh) keep_visible(c);
        reflect(*shading.specular, shading.specular_values, nullptr, area.radiance, c.specular);
      }
      if (shading.diffuse != nullptr) {
        aim_area(c, &area.corners[at], false);
        if (scene.mesh) keep_visible(c);
        reflect(*shading.diffuse, scene.diffuse_values, nullptr, area.radiance, c.diffuse);
      }
    }
  if (!occluded) reflect_ambient(shading, c);
  for (std::size_t channel = 0; emits && channel < 3; ++channel)
    for (std::size_t i = 0; i < count; ++i) c.specular[channel][i] += c.emission[channel][i];
  if (textured)
    see_through_texture(c);
  else if (shading.clear_ball)
    add_clear_ball(c, *shading.environment, shading.turn, scene.surface);
  else if (scene.surface.opacity < 1)
    see_through(c, real(scene.surface.opacity), real(unseen_luminance(scene.surface)));
}

// Whether a point gets stripes, because its F0 is in the forbidden zone, or because it reflects more light
// than it gets.
struct Marks {
  bool zone, energy;
};
Marks marks_at(const Shading& shading, const Chunk& c, std::size_t i) {
  const Scene& scene = shading.scene;
  Marks out{scene.mark_zone && shading.in_zone, false};
  if (shading.textured) {
    const vec3 f0_here(c.texel_f0[0][i], c.texel_f0[1][i], c.texel_f0[2][i]);
    out.zone = scene.mark_zone && in_forbidden_zone(f0_here);
    out.energy = !scene.mark_energy.empty() &&
                 sends_too_much(f0_here, vec3(c.texel_body[0][i], c.texel_body[1][i], c.texel_body[2][i]));
  } else if (!scene.mark_energy.empty()) {
    const double at =
        std::clamp(double(c.local_viewer[2][i]), 0.0, 1.0) * double(scene.mark_energy.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(at), scene.mark_energy.size() - 2);
    const double share = at - double(first);
    out.energy = too_much < (1 - share) * double{scene.mark_energy[first]} +
                                share * double{scene.mark_energy[first + 1]};
  }
  return out;
}

// What is seen of the object at a point of the chunk, in a column and a row of the picture.
//   behind   the light from behind it
vec3 seen_at(const Shading& shading, const Chunk& c, std::size_t i, int column, int row, const vec3& behind) {
  const Scene& scene = shading.scene;
  vec3 seen(c.specular[0][i], c.specular[1][i], c.specular[2][i]);
  seen = seen + shading.opacity() * vec3(c.diffuse[0][i], c.diffuse[1][i], c.diffuse[2][i]);
  if (shading.clear()) seen = seen + behind * c.through[i];
  if (!shading.marked()) return seen;
  const Marks marks = marks_at(shading, c, i);
  if (scene.mark_angles) seen = with_angle_zones(seen, real(c.local_viewer[2][i]), real(scene.exposure));
  return with_stripes(seen, marks.zone, marks.energy, real(column), real(row), real(scene.exposure));
}

// Writes the pixels of a piece to `row`.
void store(const Shading& shading, const Piece& piece, const Chunk& c, float* row) {
  const Scene& scene = shading.scene;
  const Camera& camera = shading.camera;
  vec3 behind = narrowed(scene.background);
  const bool plain = shading.backdrop.is_plain();
  std::size_t whole_first = c.count, whole_last = c.count;
  if (!shading.clear() && !shading.marked()) {
    whole_first = std::min(piece.whole_first, c.count);
    whole_last = std::min(piece.whole_last, c.count);
    store_whole(c, whole_first, whole_last, shading.opacity(), row);
  }
  for (std::size_t i = 0; i < c.count; ++i) {
    if (i == whole_first) i = whole_last;
    if (i >= c.count) break;
    const int column = piece.first + static_cast<int>(i);
    const double x = camera.x(column + 0.5), y = camera.y(piece.row + 0.5);
    if (!plain) behind = narrowed(shading.backdrop.at(x, y));
    const real cover = real(camera.coverage(x, y));
    const vec3 shown = mix(behind, seen_at(shading, c, i, column, piece.row, behind), cover);
    float* const out = row + 4 * i;
    out[0] = float(shown.x);
    out[1] = float(shown.y);
    out[2] = float(shown.z);
    out[3] = float(cover);
  }
}

#include "core/render/shade/shade_mesh.h"

// Draws the columns [first, last) of a row, which the object does not cover.
template <class Target>
void draw_beside(const Shading& shading, int first, int last, int row, const Target& target) {
  if (shading.backdrop.is_plain()) return target.clear(first, last, row);
  const double y = shading.camera.y(row + 0.5);
  for (int x = first; x < last; x += static_cast<int>(chunk_size)) {
    const std::size_t count = std::min(chunk_size, static_cast<std::size_t>(last - x));
    target.put(x, row, count, [&](float* pixels) {
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 seen = shading.backdrop.at(shading.camera.x(x + static_cast<int>(i) + 0.5), y);
        for (std::size_t channel = 0; channel < 3; ++channel)
          pixels[4 * i + channel] = static_cast<float>(seen[channel]);
        pixels[4 * i + 3] = 0;
      }
    });
  }
}

// Draws a scene into `target`: PicturePixels or PictureCodes of cpu_renderer.cpp.
template <class Target>
void draw(const Scene& scene, const Environment* environment, unsigned threads, const Target& target,
          const RowsDone& rows_done) {
  const Scene lit = with_bright_lights(scene, environment, threads);
  Shading shading(lit, environment);
  if (lit.refined && environment != nullptr)
    shading.samples = &environment->samples(lit.bright_apart, threads);
  std::optional<MeshView> mesh;
  if (lit.mesh) mesh.emplace(*lit.mesh, shading.camera, lit.width, lit.height);
  std::vector<MeshRow> mesh_rows(lit.mesh ? threads : 0);
  const auto draw_row = [&](int row, Chunk& c) {
    const Camera::Span span = shading.camera.covered(row), whole = shading.camera.whole(row);
    draw_beside(shading, 0, span.first, row, target);
    for (int x = span.first; x < span.last; x += static_cast<int>(c.count)) {
      c.set_count(static_cast<std::size_t>(span.last - x));
      const Piece piece{row, x, static_cast<std::size_t>(std::max(0, whole.first - x)),
                        static_cast<std::size_t>(std::max(0, whole.last - x))};
      place_points(shading, piece, c);
      shade(shading, c);
      target.put(x, row, c.count, [&](float* pixels) { store(shading, piece, c, pixels); });
    }
    draw_beside(shading, span.last, scene.width, row, target);
  };
  std::vector<std::unique_ptr<Chunk>> chunks(threads);
  parallel_chunks(static_cast<std::size_t>(scene.height), threads, tile_rows,
                  [&](std::size_t begin, std::size_t end, unsigned worker) {
                    if (!chunks[worker]) chunks[worker] = std::make_unique<Chunk>();
                    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
                      if (mesh)
                        draw_mesh_row(shading, *mesh, row, mesh_rows[worker], *chunks[worker], target);
                      else
                        draw_row(row, *chunks[worker]);
                    if (rows_done) rows_done(end - begin, worker);
                  });
}
