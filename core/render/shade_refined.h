// SPDX-License-Identifier: Apache-2.0
// Ambient light of a refined picture, on the CPU. There is no include guard: shade_picture.h includes this.

// What the samples of a picture need.
struct Refined {
  AmbientPlan plan;
  const RefinedLight* light = nullptr;  // null: no environment
  const Hemispheres* sky = nullptr;
  EnvironmentTurn turn;
};

// The mean radiance over a solid angle around the direction d of the scene.
//   map   of the environment; null: none
vec3 light_around(const Refined& refined, const LightMap* map, vec3 d, real solid_angle) {
  vec3 out(0);
  solid_angle = solid_angle * refined_filter;
  if (refined.sky != nullptr) {
    const real share = refined_hemisphere_share(dot(d, narrowed(refined.sky->axis)), solid_angle);
    out = mix(narrowed(refined.sky->lower), narrowed(refined.sky->upper), share);
  }
  if (map == nullptr) return out;
  const real turn_cos = real(refined.turn.cosine()), turn_sin = real(refined.turn.sine());
  const vec3 in_map(d.x * turn_cos - d.z * turn_sin, d.y, d.x * turn_sin + d.z * turn_cos);
  const vec3 place = octahedral_place(in_map);
  const real side = real(map->side()), last = real(map->last_level());
  const real level = min(light_map_level(solid_angle, place.z, side), last);
  const real sharp = std::floor(level), share = level - sharp;
  const Image& picture = map->picture();
  for (int i = 0; i < (share > 0 ? 2 : 1); ++i) {
    const vec3 at = light_map_texel(place, sharp + real(i), side);
    const real x = at.x - real(0.5), y = at.y - real(0.5);
    const int column = int(x), row = int(y);
    const real fx = x - real(column), fy = y - real(row), weight = i == 0 ? 1 - share : share;
    const float* const above =
        picture.values.data() + (std::size_t(row) * std::size_t(picture.width) + std::size_t(column)) * 3;
    const float* const below = above + std::size_t(picture.width) * 3;
    const real w[4] = {weight * (1 - fx) * (1 - fy), weight * fx * (1 - fy), weight * (1 - fx) * fy,
                       weight * fx * fy};
    const auto channel = [&](int c) {
      return w[0] * real(above[c]) + w[1] * real(above[3 + c]) + w[2] * real(below[c]) +
             w[3] * real(below[3 + c]);
    };
    out = out + vec3(channel(0), channel(1), channel(2));
  }
  return out;
}

// The turn of the samples at each point of a chunk, and the row of the samples that its gloss takes.
struct ChunkTurns {
  std::array<real, chunk_size> cosine, sine;
  std::array<int, chunk_size> row;
};

// Aims at the light of sample `index`: its direction, nl times its solid angle, and that solid angle.
void aim_sample(Chunk& c, const Refined& refined, const ChunkTurns& turns, int index, bool half_vectors) {
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    const float* const s = refined.plan.samples.at(index, half_vectors ? turns.row[i] : 0).data();
    const real x = real(s[0]), y = real(s[1]), cosine = turns.cosine[i], sine = turns.sine[i];
    vec3 l(x * cosine - y * sine, x * sine + y * cosine, real(s[2]));
    real solid_angle = real(s[3]);
    if (half_vectors) {
      const vec3 v(c.local_viewer[0][i], c.local_viewer[1][i], c.local_viewer[2][i]);
      const real vh = dot(l, v);
      l = l * (2 * vh) - v;
      solid_angle = solid_angle * max(vh, real(0));
    }
    c.local_light[0][i] = l.x;
    c.local_light[1][i] = l.y;
    c.local_light[2][i] = l.z;
    c.to_light[0][i] = c.tangent_x[i] * l.x + c.bitangent[0][i] * l.y + c.normal[0][i] * l.z;
    c.to_light[1][i] = c.bitangent[1][i] * l.y + c.normal[1][i] * l.z;
    c.to_light[2][i] = c.tangent_z[i] * l.x + c.bitangent[2][i] * l.y + c.normal[2][i] * l.z;
    c.irradiance[i] = max(l.z, real(0)) * solid_angle;
    c.solid_angle[i] = solid_angle;
  }
}

// Adds what the surface reflects of the sample, times `sign`.
void add_sample(Chunk& c, const Refined& refined, const LightMap* map, const Range& reached, real sign,
                Triple& sum) {
  for (std::size_t i = reached.first; i < std::min(reached.last, c.count); ++i) {
    if (!(c.irradiance[i] > 0)) continue;
    const vec3 light = light_around(refined, map, vec3(c.to_light[0][i], c.to_light[1][i], c.to_light[2][i]),
                                    c.solid_angle[i]) *
                       (sign * c.irradiance[i]);
    sum[0][i] += c.response[0][i] * light.x;
    sum[1][i] += c.response[1][i] * light.y;
    sum[2][i] += c.response[2][i] * light.z;
  }
}

// Adds what a flat body reflects.
void add_flat_body(const Shading& shading, const Refined& refined, Chunk& c, Triple& sum) {
  const bool textured = shading.scene.textures != nullptr;
  for (std::size_t i = 0; i < c.count; ++i) {
    const vec3 n(c.normal[0][i], c.normal[1][i], c.normal[2][i]);
    vec3 light(0);
    if (refined.sky != nullptr)
      light = hemisphere_diffuse(vec3(real(std::numbers::pi)), narrowed(refined.sky->lower),
                                 narrowed(refined.sky->upper), dot(n, narrowed(refined.sky->axis)));
    if (shading.environment != nullptr)
      light = light + narrowed(shading.environment->irradiance(shading.turn.to_map({n.x, n.y, n.z})));
    light = light * narrowed(refined.plan.flat);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const real here = channel == 0 ? light.x : channel == 1 ? light.y : light.z;
      sum[channel][i] += here * (textured ? c.texel_body[channel][i] : real(1));
    }
  }
}

// Adds the ambient light of a chunk by all samples.
void add_refined(const Shading& shading, const Refined& refined, const Piece& piece, Chunk& c) {
  const bool textured = shading.scene.textures != nullptr;
  const AmbientPlan& plan = refined.plan;
  ChunkTurns turns;
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    const real turn =
        real(2 * std::numbers::pi) * pixel_turn(unsigned(piece.first) + unsigned(i), unsigned(piece.row));
    turns.cosine[i] = std::cos(turn);
    turns.sine[i] = std::sin(turn);
    const int rows = plan.samples.height - 1;
    turns.row[i] =
        rows == 1 ? 1 : 1 + int(clamp(c.texel_gloss[i], real(0), real(1)) * real(rows - 1) + real(0.5));
  }
  const auto respond_to = [&](const Model& model, const std::vector<double>& values, bool with_body,
                              const Range& reached) {
    if (textured)
      respond_textured(model, values, reached, c, with_body);
    else
      respond(model, values.data(), reached, c);
  };
  // What a model reflects, times `sign`, of all samples of its lobe and of the bright lights.
  const auto add = [&](const Model& model, const std::vector<double>& values, bool lobe, bool with_body,
                       real sign, Triple& sum) {
    const bool apart = refined.light != nullptr && (!lobe || plan.wide);
    const LightMap* const map = refined.light == nullptr ? nullptr
                                : apart                  ? &refined.light->dim
                                                         : &refined.light->whole;
    for (int s = 0; s < plan.samples.width; ++s) {
      aim_sample(c, refined, turns, s, lobe);
      const Range reached = lit_blocks(c);
      respond_to(model, values, with_body, reached);
      add_sample(c, refined, map, reached, sign, sum);
    }
    for (int i = 0; apart && i < refined.light->bright.width; ++i) {
      const auto from = refined.light->bright.at(i, 0), rgb = refined.light->bright.at(i, 1);
      const Vec3 d = refined.turn.from_map({from[0], from[1], from[2]});
      aim_directional(c, real(d[0]), real(d[1]), real(d[2]));
      const Range reached = lit_blocks(c);
      respond_to(model, values, with_body, reached);
      add_light(c, reached, vec3(real(rgb[0]), real(rgb[1]), real(rgb[2])) * sign, sum);
    }
  };
  if (plan.specular != nullptr) add(*plan.specular, plan.specular_values, true, false, 1, c.specular);
  Triple& body = plan.combined ? c.specular : c.diffuse;
  if (plan.body == AmbientPlan::Body::flat) return add_flat_body(shading, refined, c, body);
  if (plan.body == AmbientPlan::Body::none) return;
  add(*plan.diffuse, plan.diffuse_values, false, true, 1, body);
  if (plan.combined) add(*plan.diffuse, plan.specular_values, false, false, -1, body);
}
