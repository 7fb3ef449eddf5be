// SPDX-License-Identifier: Apache-2.0
// Light from all around, for the points of a chunk. There is no include guard: shade_chunk.h includes this.

// The values of the surface at a point that hemispheres and environment use.
struct PointSurface {
  vec3 f0_value, diffuse;
  real gloss;
};
struct SameSurface {
  PointSurface all;
  const PointSurface& at(std::size_t) const { return all; }
};
struct TexturedSurface {
  const Chunk& c;
  PointSurface at(std::size_t i) const {
    return {vec3(c.texel_f0[0][i], c.texel_f0[1][i], c.texel_f0[2][i]),
            vec3(c.texel_body[0][i], c.texel_body[1][i], c.texel_body[2][i]), c.texel_gloss[i]};
  }
};

// The numbers of an AmbientTable between its nodes, for one view and gloss.
class AmbientNode {
 public:
  AmbientNode(const AmbientTable& table, real nv, real gloss) {
    const real x = sqrt(clamp(nv, real(0), real(1))) * real(table.views - 1);
    const int column = std::min(int(x), table.views - 2);
    right_ = x - real(column);
    column_ = 3 * std::size_t(column);
    first_ = column_;
    row_ = 3 * std::size_t(table.views);
    if (table.glosses == 1) return;
    const real y = clamp(gloss, real(0), real(1)) * real(table.glosses - 1);
    const int row = std::min(int(y), table.glosses - 2);
    up_ = y - real(row);
    first_ += row_ * std::size_t(row);
    rows_ = 2;
  }
  vec3 of(const std::vector<float>& numbers) const {
    const vec3 low = in_row(numbers, first_);
    return rows_ == 1 ? low : mix(low, in_row(numbers, first_ + row_), up_);
  }
  // The value at the view of numbers that have one row for all glosses.
  vec3 of_view(const std::vector<float>& numbers) const { return in_row(numbers, column_); }

 private:
  vec3 in_row(const std::vector<float>& numbers, std::size_t at) const {
    const float* a = numbers.data() + at;
    return mix(vec3(real(a[0]), real(a[1]), real(a[2])), vec3(real(a[3]), real(a[4]), real(a[5])), right_);
  }
  std::size_t first_ = 0, column_ = 0, row_ = 0;
  real right_ = 0, up_ = 0;
  int rows_ = 1;
};

inline vec3 body_albedo(const AmbientTable& table, real nv) {
  return AmbientNode(table, nv, 0).of_view(table.body);
}

inline void add_to(Triple& sum, std::size_t i, const vec3& light) {
  sum[0][i] += light.x;
  sum[1][i] += light.y;
  sum[2][i] += light.z;
}

// Four numbers that lie beside each other, so that they are computed in one vector.
struct Four {
  real at[4];
  vec3 xyz() const { return vec3(at[0], at[1], at[2]); }
};
inline Four mixed(const float* a, const float* b, real low, real up) {
  Four out;
  for (int c = 0; c < 4; ++c) out.at[c] = real(a[c]) * low + real(b[c]) * up;
  return out;
}

// The radiance of an environment that a sample sees, in a direction of its map of any length but 0.
inline vec3 seen_by_sample(const LightSamples& light, const vec3& d, real level) {
  constexpr int tile = LightSamples::tile;
  const real place = clamp(level - real(sharpest_sample), real(0), real(dullest_sample - sharpest_sample));
  const int first = std::min(int(place), int(dullest_sample - sharpest_sample) - 1);
  const real share = place - real(first);
  const vec3 at = octahedral_place(d);
  const real x = at.x * real(tile - 2) + real(0.5), y = at.y * real(tile - 2) + real(0.5);
  const int x0 = int(x), y0 = int(y);
  const real fx = x - real(x0), fy = y - real(y0), gx = 1 - fx;
  const float* const sharp = &light.stack.values[std::size_t((first * tile + y0) * tile + x0) * 4];
  const float* const dull = sharp + std::size_t(tile) * tile * 4;
  const Four a = mixed(sharp, sharp + 4, gx, fx), b = mixed(sharp + 4 * tile, sharp + 4 * tile + 4, gx, fx),
             c = mixed(dull, dull + 4, gx, fx), e = mixed(dull + 4 * tile, dull + 4 * tile + 4, gx, fx);
  const real wa = (1 - share) * (1 - fy), wb = (1 - share) * fy, wc = share * (1 - fy), we = share * fy;
  Four out;
  for (int k = 0; k < 4; ++k) out.at[k] = a.at[k] * wa + b.at[k] * wb + c.at[k] * wc + e.at[k] * we;
  return out.xyz();
}

// The row of samples of the point `i` of a chunk.
inline int sample_row(const LobeSamples& samples, const Chunk& c, std::size_t i, real gloss) {
  if (!samples.by_azimuth) return int(clamp(gloss, real(0), real(1)) * real(samples.rows - 1) + real(0.5));
  const real half_turns = math::atan2(c.local_viewer[1][i], c.local_viewer[0][i]) / real(std::numbers::pi);
  return (int(std::floor(half_turns * real(samples.rows) + real(0.5))) + samples.rows) % samples.rows;
}

// What a lobe reflects: its albedo times the sum of its shares of seen(axis, level), over the round lobes that stand for it
// or, in a refined picture, over its samples.
template <class Seen>
vec3 reflected_by_lobe(const AmbientTable& table, int row, const vec3& n, const vec3& v,
                       const PointSurface& surface, const Seen& seen) {
  const real nv = dot(n, v);
  vec3 light(0), albedo(0);
  if (table.samples.empty()) {
    const AmbientNode node(table, nv, surface.gloss);
    for (const auto& numbers : table.probes) {
      const vec3 probe = node.of(numbers);
      light = light + probe.z * seen(probe_axis(n, v, nv, probe.x), probe.y);
    }
    albedo = node.of(table.albedo);
  } else {
    const LobeSamples& samples = table.samples;
    const real view = sqrt(clamp(nv, real(0), real(1))) * real(samples.views - 1);
    const int first = std::min(int(view), samples.views - 2);
    const real up = view - real(first), low = 1 - up;
    const int line = row * samples.views + first;
    const float *upper = samples.picture.at(0, line).data(), *lower = samples.picture.at(0, line + 1).data();
    const auto numbers = [&](int column) { return mixed(upper + 4 * column, lower + 4 * column, low, up); };
    const vec3 t = viewer_tangent(n, v, nv);
    const vec3 b(n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x);
    for (int i = 0; i < samples.count; ++i) {
      const vec3 share = numbers(samples.count + i).xyz();
      if (!(share.x + share.y + share.z > 0)) continue;
      const Four h = numbers(i);
      light = light + share * seen(sample_axis(h.xyz(), t, b, n, v), h.at[3]);
    }
    albedo = numbers(2 * samples.count).xyz();
  }
  return (table.of_f0 ? albedo_of_f0(albedo, surface.f0_value) : albedo) * light;
}

struct ChunkHemispheres {
  HemisphereForm form;  // not automatic
  vec3 axis, lower, upper;
};

template <class Surface>
void add_hemispheres(Chunk& c, const ChunkHemispheres& h, const AmbientTable& table, const Surface& surface,
                     bool with_specular, bool with_diffuse) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const PointSurface& here = surface.at(i);
    const auto& [f0_value, diffuse, gloss] = here;
    const vec3 n(c.normal[0][i], c.normal[1][i], c.normal[2][i]),
        v(c.viewer[0][i], c.viewer[1][i], c.viewer[2][i]);
    const real nz = dot(n, h.axis), nv = dot(n, v), rz = 2 * nv * nz - dot(v, h.axis);
    const auto share_of = [&](const vec3& axis, real level) {
      const real share = probe_share(dot(axis, h.axis) / sqrt(dot(axis, axis)), level);
      return mix(h.lower, h.upper, share);
    };
    if (with_specular)
      add_to(c.specular, i,
             h.form == HemisphereForm::model
                 ? reflected_by_lobe(table, sample_row(table.samples, c, i, here.gloss), n, v, here, share_of)
             : h.form == HemisphereForm::corrected
                 ? hemisphere_specular(f0_value, gloss, nv, rz, h.lower, h.upper)
             : h.form == HemisphereForm::wide
                 ? hemisphere_specular_wide(f0_value, gloss, nv, rz, h.lower, h.upper)
                 : hemisphere_specular_printed(f0_value, gloss, nv, rz, h.lower, h.upper));
    if (!with_diffuse) continue;
    const vec3 light = hemisphere_diffuse(diffuse, h.lower, h.upper, nz);
    add_to(c.diffuse, i, table.plain_body ? light : light * body_albedo(table, nv));
  }
}

// The environment as a picture has it.
//   samples   what a refined picture sees of it; null: the prefiltered maps are looked up
struct TurnedEnvironment {
  const Environment& environment;
  const LightSamples* samples;
  const EnvironmentTurn& turn;
};

// Adds the light of the environment. The prefiltered maps are looked up in double in both precisions, because
// trigonometry costs far more than the wider type.
template <class Surface>
void add_environment(Chunk& c, const TurnedEnvironment& around, const AmbientTable& table,
                     const Surface& surface, bool with_specular, bool with_diffuse) {
  const Environment& environment = around.environment;
  const LightSamples* const samples = around.samples;
  const EnvironmentTurn& turn = around.turn;
  const auto narrow = [](const Vec3& w) { return vec3(real(w[0]), real(w[1]), real(w[2])); };
  for (std::size_t i = 0; i < c.count; ++i) {
    const PointSurface& here = surface.at(i);
    // The axes as the map has them, which is turned.
    const Vec3 normal = turn.to_map({c.normal[0][i], c.normal[1][i], c.normal[2][i]});
    const vec3 n = narrow(normal), v = narrow(turn.to_map({c.viewer[0][i], c.viewer[1][i], c.viewer[2][i]}));
    if (with_specular)
      add_to(c.specular, i,
             reflected_by_lobe(table, sample_row(table.samples, c, i, here.gloss), n, v, here,
                               [&](const vec3& axis, real level) {
                                 if (samples != nullptr) return seen_by_sample(*samples, axis, level);
                                 return narrow(environment.at_level({axis.x, axis.y, axis.z}, double(level)));
                               }));
    if (with_diffuse) {
      const vec3 seen =
          narrow(samples != nullptr ? samples->irradiance_at(normal) : environment.irradiance(normal));
      const vec3 light = here.diffuse * seen * real(1 / std::numbers::pi);
      add_to(c.diffuse, i, table.plain_body ? light : light * body_albedo(table, dot(n, v)));
    }
  }
}
