// SPDX-License-Identifier: Apache-2.0
// What textures say of the points of a chunk. There is no include guard: shade_picture.h includes this behind Shading.

// Evaluates a model at every lit point of a textured chunk, with the values of the texel there.
void respond_textured(const Model& model, const std::vector<double>& values, const Range& reached, Chunk& c) {
  TexturedValues textured(model, values);
  for (std::size_t i = reached.first; i < std::min(reached.last, c.count); ++i) {
    if (!(c.irradiance[i] > 0)) continue;
    // The colour of the body is already multiplied by its opacity.
    const std::array<double, 4> body{double(c.texel_body[0][i]), double(c.texel_body[1][i]),
                                     double(c.texel_body[2][i]), 1},
        gloss{double(c.texel_f0[0][i]), double(c.texel_f0[1][i]), double(c.texel_f0[2][i]),
              double(c.texel_gloss[i])};
    respond(model, textured.at(body, gloss), {i, i + 1}, c);
  }
}

// A UV of a mesh in the texture, which repeats.
double inside_texture(double at) {
  return at >= 0 && at <= 1 ? at : at - std::floor(at);
}

// Where a point of the chunk lies in the textures; points beyond the last one have some place too.
std::array<double, 2> place_of(const Scene& scene, const Chunk& c, std::size_t i) {
  if (i >= c.count) return {0.5, 0.5};
  if (scene.mesh)
    return {inside_texture(double(c.uv[0][i]) * scene.texture_scale[0]),
            inside_texture(double(c.uv[1][i]) * scene.texture_scale[1])};
  std::array<double, 2> out = texture_place(
      scene.shape, {double(c.position[0][i]), double(c.position[1][i]), double(c.position[2][i])});
  if (scene.texture_scale != std::array{1.0, 1.0})
    for (std::size_t axis = 0; axis < 2; ++axis) {
      out[axis] *= scene.texture_scale[axis];
      out[axis] -= std::floor(out[axis]);
    }
  return out;
}

void look_up_textures(const Shading& shading, Chunk& c) {
  const SurfaceTextures& textures = *shading.scene.textures;
  const SurfaceTextures::Quantities& has = textures.has;
  const SurfaceValues& surface = shading.scene.surface;
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    const auto [u, v] = place_of(shading.scene, c, i);
    std::array<double, 4> body{}, gloss{};
    if (has.diffuse || has.opacity) body = texel(textures.body, u, v);
    if (has.f0 || has.gloss) gloss = texel(textures.gloss, u, v);
    if (!has.diffuse) std::copy_n(surface.diffuse.begin(), 3, body.begin());
    if (!has.opacity) body[3] = surface.opacity;
    if (!has.f0) std::copy_n(surface.f0.begin(), 3, gloss.begin());
    if (!has.gloss) gloss[3] = surface.gloss;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      c.texel_body[channel][i] = real(body[channel] * body[3]);
      c.texel_f0[channel][i] = real(gloss[channel]);
    }
    c.texel_opacity[i] = real(body[3]);
    c.texel_gloss[i] = real(gloss[3]);
  }
}

// The tangent and the bitangent of a mesh's point beside its normal.
std::pair<Vec3, Vec3> mesh_tangents(const Chunk& c, std::size_t i, const Vec3& n) {
  const auto beside_normal = [&](const Triple& way) {
    Vec3 out{double(way[0][i]), double(way[1][i]), double(way[2][i])};
    const double along = etak::dot(out, n);
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis] -= along * n[axis];
    return scaled(out, 1 / std::max(std::sqrt(etak::dot(out, out)), 1e-30));
  };
  const Vec3 t = beside_normal(c.along), b = cross(n, t);
  return {t, etak::dot(b, beside_normal(c.up)) < 0 ? scaled(b, -1) : b};
}

// Turns the normals by the texels of a normal map. GLSL: bent_normal() of picture.glsl.
void bend_normals(const Shading& shading, Chunk& c) {
  const Image& map = shading.scene.textures->normal;
  constexpr double least_facing = 0.02;
  const auto unit = [](const Vec3& d) { return scaled(d, 1 / std::sqrt(etak::dot(d, d))); };
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    const auto [u, v] = place_of(shading.scene, c, i);
    const std::array<double, 4> m = texel(map, u, v);
    const Vec3 n{double(c.normal[0][i]), double(c.normal[1][i]), double(c.normal[2][i])},
        viewer{double(c.viewer[0][i]), double(c.viewer[1][i]), double(c.viewer[2][i])};
    const double length = math::hypot(n[0], n[2]);
    Vec3 t = length < 1e-6 ? Vec3{1, 0, 0} : Vec3{n[2] / length, 0, -n[0] / length}, b = cross(n, t);
    if (shading.scene.mesh) std::tie(t, b) = mesh_tangents(c, i, n);
    Vec3 bent{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      bent[axis] = m[0] * t[axis] + m[1] * b[axis] + m[2] * n[axis];
    bent = unit(bent);
    if (const double facing = etak::dot(bent, viewer); facing < least_facing) {
      for (std::size_t axis = 0; axis < 3; ++axis) bent[axis] += (least_facing - facing) * viewer[axis];
      bent = unit(bent);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) c.normal[axis][i] = real(bent[axis]);
  }
}

// Finds what the points send out by themselves and how much of the light from all around reaches them.
void look_up_emission(const Scene& scene, Chunk& c) {
  const SurfaceTextures::Quantities has = scene.textured();
  const bool same = !has.emission && !has.occlusion;
  const std::array<double, 4> everywhere = same ? emission_at(scene, {0.5, 0.5}) : std::array<double, 4>{};
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    const std::array<double, 4> here = same ? everywhere : emission_at(scene, place_of(scene, c, i));
    for (std::size_t channel = 0; channel < 3; ++channel) c.emission[channel][i] = real(here[channel]);
    c.occlusion[i] = scene.mesh ? real(here[3]) * c.open[i] : real(here[3]);
  }
}
