// SPDX-License-Identifier: Apache-2.0
// Shades a chunk of some hundred surface points at once. Each quantity is an array of its own, so that the
// loops are vectorised. There is no include guard: include this in an unnamed namespace that has chunk_size
// and ETAK_RENDER_CLONES, behind core/math/real_f64.h or real_f32.h.
#include "core/fresnel/texts.h"

#include "core/light/texts.h"

// Loops run over whole blocks of points, also past the last point, where nothing reads what they write. A
// remainder that is computed point by point would cost as much as the rest of the row.
constexpr std::size_t block = 16;
static_assert(chunk_size % block == 0);

struct Lane {
  alignas(64) std::array<real, chunk_size> values;
  real& operator[](std::size_t i) { return values[i]; }
  real operator[](std::size_t i) const { return values[i]; }
  void fill(std::size_t count, real value) { std::fill_n(values.begin(), count, value); }
};
using Triple = std::array<Lane, 3>;

struct Chunk {
  std::size_t count = 0, whole_blocks = 0;  // how many points; the same, rounded up to whole blocks
  Triple position, normal, viewer;          // in the scene's space; filled by the caller
  std::array<Lane, 2> uv;                   // of a mesh; filled by the caller
  Triple along, up;                         // of a mesh: where u grows and where v falls in its textures
  Lane open;                                // of a mesh: share of light from all around that the mesh leaves
  Lane visible;                             // of a mesh: share of one light that the mesh leaves
  Lane tangent_x, tangent_z;                // the tangent's y is 0
  Triple bitangent;
  Triple local_viewer, local_light;  // in the frame of tangent, bitangent and normal
  Triple local_half;                 // the half vector in that frame; for far lights
  Triple to_light;                   // in the scene's space; for point and spot lights
  Lane irradiance;                   // E nl of one light, without its colour
  Triple response;                   // f_r of one model
  Triple specular, diffuse;          // radiance
  Lane through;                      // share of the background that is seen through the object
  Triple texel_body, texel_f0;       // from textures: diffuse colour times opacity, and F0
  Lane texel_opacity, texel_gloss;
  Triple emission;                // radiance that the points send out by themselves
  Lane occlusion;                 // share of the light of hemispheres and environment that reaches them
  std::array<Lane, 5> area_lobe;  // a, b, d, e and the plain cosine's share: core/light/area_lobes.h

  // Takes as many of the `most` next points as there is room for.
  void set_count(std::size_t most) {
    count = std::min(chunk_size, most);
    whole_blocks = (count + block - 1) / block * block;
  }
};

// One light, as the numbers that the loops need.
struct ChunkLight {
  bool directional, spot;
  real px, py, pz;  // position
  real dx, dy, dz;  // towards the light (directional), along the beam (spot)
  real cos_inner, cos_outer;
  vec3 color;  // times intensity, and times pi where the setup is scaled by pi
  // For directional lights in orthographic pictures: the half vector, and its cosine with the light.
  real hx, hy, hz;
  double lh;
};

ETAK_RENDER_CLONES void build_frames(Chunk& c, bool orthographic) {
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real nx = c.normal[0][i], ny = c.normal[1][i], nz = c.normal[2][i];
    const real length2 = nx * nx + nz * nz;
    // At the poles of y the cross product that gives the tangent vanishes, and the tangent is the x axis.
    const bool pole = length2 < real(1e-12);
    const real inverse = 1 / std::sqrt(length2 > real(1e-12) ? length2 : real(1e-12));
    const real tx = pole ? real(1) : nz * inverse, tz = pole ? real(0) : -nx * inverse;
    c.tangent_x[i] = tx;
    c.tangent_z[i] = tz;
    c.bitangent[0][i] = ny * tz;
    c.bitangent[1][i] = nz * tx - nx * tz;
    c.bitangent[2][i] = -ny * tx;
  }
  if (orthographic) {
    for (std::size_t i = 0; i < count; ++i) {
      c.local_viewer[0][i] = c.tangent_z[i];
      c.local_viewer[1][i] = c.bitangent[2][i];
      c.local_viewer[2][i] = c.normal[2][i];
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const real x = c.viewer[0][i], y = c.viewer[1][i], z = c.viewer[2][i];
    c.local_viewer[0][i] = c.tangent_x[i] * x + c.tangent_z[i] * z;
    c.local_viewer[1][i] = c.bitangent[0][i] * x + c.bitangent[1][i] * y + c.bitangent[2][i] * z;
    c.local_viewer[2][i] = c.normal[0][i] * x + c.normal[1][i] * y + c.normal[2][i] * z;
  }
}

ETAK_RENDER_CLONES void aim_directional(Chunk& c, real x, real y, real z) {
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real nl = c.normal[0][i] * x + c.normal[1][i] * y + c.normal[2][i] * z;
    c.local_light[0][i] = c.tangent_x[i] * x + c.tangent_z[i] * z;
    c.local_light[1][i] = c.bitangent[0][i] * x + c.bitangent[1][i] * y + c.bitangent[2][i] * z;
    c.local_light[2][i] = nl;
    c.irradiance[i] = nl > 0 ? nl : real(0);
  }
}

// Aims as aim_directional() does, but with the half vector in place of the light's direction; see
// Model::f32_batch_far().
ETAK_RENDER_CLONES void aim_far(Chunk& c, const ChunkLight& light) {
  const real x = light.dx, y = light.dy, z = light.dz, hx = light.hx, hy = light.hy, hz = light.hz;
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real nl = c.normal[0][i] * x + c.normal[1][i] * y + c.normal[2][i] * z;
    c.local_half[0][i] = c.tangent_x[i] * hx + c.tangent_z[i] * hz;
    c.local_half[1][i] = c.bitangent[0][i] * hx + c.bitangent[1][i] * hy + c.bitangent[2][i] * hz;
    c.local_half[2][i] = c.normal[0][i] * hx + c.normal[1][i] * hy + c.normal[2][i] * hz;
    c.local_light[2][i] = nl;
    c.irradiance[i] = nl > 0 ? nl : real(0);
  }
}

ETAK_RENDER_CLONES void aim_point(Chunk& c, const ChunkLight& light) {
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real x = light.px - c.position[0][i], y = light.py - c.position[1][i],
               z = light.pz - c.position[2][i];
    const real length = std::sqrt(x * x + y * y + z * z);
    const real r = length > real(point_light_min_r) ? length : real(point_light_min_r);
    const real lx = x / r, ly = y / r, lz = z / r;
    const real nl = c.normal[0][i] * lx + c.normal[1][i] * ly + c.normal[2][i] * lz;
    c.local_light[0][i] = c.tangent_x[i] * lx + c.tangent_z[i] * lz;
    c.local_light[1][i] = c.bitangent[0][i] * lx + c.bitangent[1][i] * ly + c.bitangent[2][i] * lz;
    c.local_light[2][i] = nl;
    c.irradiance[i] = (nl > 0 ? nl : real(0)) * point_irradiance(vec3(1), r).x;
    c.to_light[0][i] = lx;
    c.to_light[1][i] = ly;
    c.to_light[2][i] = lz;
  }
  if (!light.spot) return;
  for (std::size_t i = 0; i < count; ++i) {
    const real along =
        -(c.to_light[0][i] * light.dx + c.to_light[1][i] * light.dy + c.to_light[2][i] * light.dz);
    c.irradiance[i] *= spot_share(along, light.cos_inner, light.cos_outer);
  }
}

// The numbers of an area light: its pieces' corners, four to each, in the scene's space.
struct ChunkArea {
  std::vector<vec3> corners;
  vec3 radiance;
};

void find_area_lobes(Chunk& c, const AreaTable& table, bool textured) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const AreaLobe lobe = table.at(double(c.local_viewer[2][i]), textured ? double(c.texel_gloss[i]) : 0.0);
    const double numbers[] = {lobe.a, lobe.b, lobe.d, lobe.e, lobe.cosine};
    for (std::size_t k = 0; k < 5; ++k) c.area_lobe[k][i] = real(numbers[k]);
  }
}

// Aims at a piece of an area light, for a specular model or for a diffuse one: the direction at which the model is
// taken, and the irradiance per unit of radiance.
void aim_area(Chunk& c, const vec3* corners, bool specular) {
  for (std::size_t i = 0; i < c.whole_blocks; ++i) {
    c.irradiance[i] = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) c.local_light[axis][i] = axis == 2 ? real(1) : real(0);
    if (i >= c.count) continue;
    // From the surface's tangent to the plane of the viewer.
    const real vx = c.local_viewer[0][i], vy = c.local_viewer[1][i], across = std::sqrt(vx * vx + vy * vy);
    const real cx = across > real(1e-6) ? vx / across : real(1),
               cy = across > real(1e-6) ? vy / across : real(0);
    vec3 p[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const real x = corners[k].x - c.position[0][i], y = corners[k].y - c.position[1][i],
                 z = corners[k].z - c.position[2][i];
      const real along = c.tangent_x[i] * x + c.tangent_z[i] * z,
                 up = c.bitangent[0][i] * x + c.bitangent[1][i] * y + c.bitangent[2][i] * z;
      p[k] = vec3(cx * along + cy * up, cx * up - cy * along,
                  c.normal[0][i] * x + c.normal[1][i] * y + c.normal[2][i] * z);
    }
    const AreaMatrix m{c.area_lobe[0][i], c.area_lobe[1][i], c.area_lobe[2][i], c.area_lobe[3][i]};
    const AreaLit by = specular ? area_specular(m, c.area_lobe[4][i], p[0], p[1], p[2], p[3])
                                : area_diffuse(p[0], p[1], p[2], p[3]);
    if (!(by.irradiance > 0)) continue;
    c.irradiance[i] = by.irradiance;
    c.local_light[0][i] = cx * by.towards.x - cy * by.towards.y;
    c.local_light[1][i] = cy * by.towards.x + cx * by.towards.y;
    c.local_light[2][i] = by.towards.z;
  }
}

struct Range {
  std::size_t first, last;
};

// The points that the light reaches, in whole blocks: blocks at both ends where all points are dark are left
// out.
ETAK_RENDER_CLONES Range lit_blocks(const Chunk& c) {
  const auto dark = [&](std::size_t first) {
    int reached = 0;
    for (std::size_t i = first; i < first + block; ++i) reached |= c.irradiance[i] > 0;
    return reached == 0;
  };
  Range out{0, c.whole_blocks};
  while (out.first < out.last && dark(out.first)) out.first += block;
  while (out.first < out.last && dark(out.last - block)) out.last -= block;
  return out;
}

ETAK_RENDER_CLONES void add_light(const Chunk& c, const Range& range, const vec3& color, Triple& sum) {
  const real r = color.x, g = color.y, b = color.z;
  for (std::size_t i = range.first; i < range.last; ++i) {
    sum[0][i] += c.response[0][i] * (c.irradiance[i] * r);
    sum[1][i] += c.response[1][i] * (c.irradiance[i] * g);
    sum[2][i] += c.response[2][i] * (c.irradiance[i] * b);
  }
}

#include "core/render/shade/shade_ambient.h"

vec3 narrowed(const Vec3& v) {
  return vec3(real(v[0]), real(v[1]), real(v[2]));
}

// Adds the light of the environment that comes through a clear ball, with or without layers.
void add_clear_ball(Chunk& c, const Environment& environment, const EnvironmentTurn& turn,
                    const SurfaceValues& ball) {
  const real opacity = real(ball.opacity), eta = real(ball.layers ? ball.layers->n : ball.n[1]);
  const vec3 passing = narrowed(*ball.passing);
  for (std::size_t i = 0; i < c.count; ++i) {
    const vec3 n(c.normal[0][i], c.normal[1][i], c.normal[2][i]);
    const vec3 d = beyond_ball(n, vec3(c.viewer[0][i], c.viewer[1][i], c.viewer[2][i]), eta);
    const Vec3 light = environment.specular(turn.to_map({d.x, d.y, d.z}), double{ball.gloss});
    const real nv = clamp(c.local_viewer[2][i], real(0), real(1));
    const vec3 share =
        (1 - opacity) * (ball.layers
                             ? through_layers(nv, eta, passing, narrowed(ball.layers->twice.at(double(nv))))
                             : through_ball(nv, eta, passing));
    c.specular[0][i] += share.x * real(light[0]);
    c.specular[1][i] += share.y * real(light[1]);
    c.specular[2][i] += share.z * real(light[2]);
    c.through[i] = 0;
  }
}

void see_through(Chunk& c, real opacity, real luminance) {
  for (std::size_t i = 0; i < c.count; ++i)
    c.through[i] = 1 - fresnel_opacity(opacity, luminance, c.local_viewer[2][i]);
}

void see_through_texture(Chunk& c) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const real luminance = luminance_of(vec3(c.texel_f0[0][i], c.texel_f0[1][i], c.texel_f0[2][i]));
    c.through[i] = 1 - fresnel_opacity(c.texel_opacity[i], luminance, c.local_viewer[2][i]);
  }
}

ETAK_RENDER_CLONES void sphere_points(Chunk& c, double first_x, double step, double y) {
  const real normal_y = real(y), reach2 = real(1 - y * y), reach = std::sqrt(reach2 > 0 ? reach2 : real(0));
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real x = real(first_x + step * double(int(i)));
    const real depth2 = (reach - x) * (reach + x);
    c.normal[0][i] = x;
    c.normal[1][i] = normal_y;
    c.normal[2][i] = std::sqrt(depth2 > 0 ? depth2 : real(0));
  }
}

// Converts normals from the camera's axes to those of the scene.
ETAK_RENDER_CLONES void turn_points(Chunk& c, const Mat3& axes) {
  real m[9];
  for (std::size_t i = 0; i < 9; ++i) m[i] = real(axes[i / 3][i % 3]);
  const std::size_t count = c.whole_blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const real x = c.normal[0][i], y = c.normal[1][i], z = c.normal[2][i];
    c.normal[0][i] = x * m[0] + y * m[3] + z * m[6];
    c.normal[1][i] = x * m[1] + y * m[4] + z * m[7];
    c.normal[2][i] = x * m[2] + y * m[5] + z * m[8];
  }
}

// Writes the points [first, last) of the chunk, which the object covers wholly, as pixels of four channels.
ETAK_RENDER_CLONES void store_whole(const Chunk& c, std::size_t first, std::size_t last, real opacity,
                                    float* out) {
  for (std::size_t i = first; i < last; ++i) {
    out[4 * i] = float(c.specular[0][i] + opacity * c.diffuse[0][i]);
    out[4 * i + 1] = float(c.specular[1][i] + opacity * c.diffuse[1][i]);
    out[4 * i + 2] = float(c.specular[2][i] + opacity * c.diffuse[2][i]);
    out[4 * i + 3] = 1;
  }
}
