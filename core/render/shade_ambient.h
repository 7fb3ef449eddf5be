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
  // Of numbers that have one row for all glosses.
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

inline vec3 ambient_albedo(const AmbientTable& table, const AmbientNode& node, const vec3& f0_value) {
  const vec3 albedo = node.of(table.albedo);
  return table.of_f0 ? albedo_of_f0(albedo, f0_value) : albedo;
}

inline void add_to(Triple& sum, std::size_t i, const vec3& light) {
  sum[0][i] += light.x;
  sum[1][i] += light.y;
  sum[2][i] += light.z;
}

struct ChunkHemispheres {
  HemisphereForm form;  // not automatic
  vec3 axis, lower, upper;
};

// The light of hemispheres by the model's albedo and lobe.
inline vec3 hemispheres_of_model(const ChunkHemispheres& h, const AmbientTable& table,
                                 const AmbientNode& node, const vec3& n, const vec3& v, real nv,
                                 const vec3& f0_value) {
  real upper = 0;
  for (const auto& numbers : table.probes) {
    const vec3 probe = node.of(numbers), axis = probe_axis(n, v, nv, probe.x);
    upper += probe.z * probe_share(dot(axis, h.axis) / sqrt(dot(axis, axis)), probe.y);
  }
  return ambient_albedo(table, node, f0_value) * mix(h.lower, h.upper, upper);
}

template <class Surface>
void add_hemispheres(Chunk& c, const ChunkHemispheres& h, const AmbientTable& table, const Surface& surface,
                     bool with_specular, bool with_diffuse) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const auto& [f0_value, diffuse, gloss] = surface.at(i);
    const vec3 n(c.normal[0][i], c.normal[1][i], c.normal[2][i]),
        v(c.viewer[0][i], c.viewer[1][i], c.viewer[2][i]);
    const real nz = dot(n, h.axis), nv = dot(n, v), rz = 2 * nv * nz - dot(v, h.axis);
    const AmbientNode node(table, nv, gloss);
    if (with_specular)
      add_to(c.specular, i,
             h.form == HemisphereForm::model ? hemispheres_of_model(h, table, node, n, v, nv, f0_value)
             : h.form == HemisphereForm::corrected
                 ? hemisphere_specular(f0_value, gloss, nv, rz, h.lower, h.upper)
             : h.form == HemisphereForm::wide
                 ? hemisphere_specular_wide(f0_value, gloss, nv, rz, h.lower, h.upper)
                 : hemisphere_specular_printed(f0_value, gloss, nv, rz, h.lower, h.upper));
    if (!with_diffuse) continue;
    const vec3 light = hemisphere_diffuse(diffuse, h.lower, h.upper, nz);
    add_to(c.diffuse, i, table.plain_body ? light : light * node.of_view(table.body));
  }
}

// Adds the light of the environment. The prefiltered maps are looked up in double in both precisions, because
// trigonometry costs far more than the wider type.
template <class Surface>
void add_environment(Chunk& c, const Environment& environment, const EnvironmentTurn& turn,
                     const AmbientTable& table, const Surface& surface, bool with_specular,
                     bool with_diffuse) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const auto& [f0_value, diffuse, gloss] = surface.at(i);
    const vec3 n(c.normal[0][i], c.normal[1][i], c.normal[2][i]),
        v(c.viewer[0][i], c.viewer[1][i], c.viewer[2][i]);
    const real nv = dot(n, v);
    const AmbientNode node(table, nv, gloss);
    if (with_specular) {
      vec3 light(0);
      for (const auto& numbers : table.probes) {
        const vec3 probe = node.of(numbers), axis = probe_axis(n, v, nv, probe.x);
        const Vec3 seen = environment.at_level(turn.to_map({axis.x, axis.y, axis.z}), double(probe.y));
        light = light + probe.z * vec3(real(seen[0]), real(seen[1]), real(seen[2]));
      }
      add_to(c.specular, i, ambient_albedo(table, node, f0_value) * light);
    }
    if (with_diffuse) {
      const Vec3 seen = environment.irradiance(turn.to_map({n.x, n.y, n.z}));
      const vec3 light =
          diffuse * vec3(real(seen[0]), real(seen[1]), real(seen[2])) * real(1 / std::numbers::pi);
      add_to(c.diffuse, i, table.plain_body ? light : light * node.of_view(table.body));
    }
  }
}
