// SPDX-License-Identifier: Apache-2.0
#include "core/scene/texel_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double widest_aspect = 16.0 / 9;

// Squared texels per unit of the world, along the directions of the fewest and the most: the eigenvalues of
// the texels' first fundamental form in the world's.
struct Densities {
  double least = 0, most = 0;
  bool drawn = true;  // it has an area in the world
};

Densities densities(const std::array<Uv, 3>& uv, int width, int height, const std::array<float, 3>& edges) {
  const double x1 = (uv[1][0] - uv[0][0]) * width, y1 = (uv[1][1] - uv[0][1]) * height;
  const double x2 = (uv[2][0] - uv[0][0]) * width, y2 = (uv[2][1] - uv[0][1]) * height;
  const double ta = x1 * x1 + y1 * y1, tb = x1 * x2 + y1 * y2, tc = x2 * x2 + y2 * y2;
  const double ga = double{edges[0]}, gb = double{edges[1]}, gc = double{edges[2]};
  const double g = ga * gc - gb * gb, t = (x1 * y2 - x2 * y1) * (x1 * y2 - x2 * y1);
  // The numbers come from floats: a smaller area is a rounding error, and the true one is 0.
  if (!(g > 1e-12 * ga * gc)) return {0, 0, false};
  const double half = 0.5 * (ta * gc + tc * ga - 2 * tb * gb);
  const double root = std::sqrt(std::max(0.0, half * half - g * t));
  const double most = (half + root) / g;
  return {most > 0 ? t / g / most : 0, most, true};
}

// Pixels per unit of the world.
struct ScreenPixels {
  double fewest = infinite, most = 0;
};

ScreenPixels pixels(const GltfCamera& camera, const std::array<float, 3>& center, double radius,
                    int view_height) {
  if (!camera.perspective) {
    const double all = view_height / (2 * camera.ymag);
    return {all, all};
  }
  double depth = 0;
  for (std::size_t c = 0; c < 3; ++c) depth += (double{center[c]} - camera.position[c]) * camera.direction[c];
  if (depth + radius < camera.znear) return {};
  const double tangent = math::tan(camera.yfov / 2), scale = view_height / (2 * tangent);
  const double corner = std::sqrt(1 + tangent * tangent * (1 + widest_aspect * widest_aspect));
  return {scale / std::max(camera.znear, depth + radius),
          scale / std::max(camera.znear, depth - radius) * corner};
}

}  // namespace

TexelScale texel_scale(const MaterialUses& uses, int material, const GltfTexture& texture, int width,
                       int height, int view_height) {
  TexelScale out;
  double least = infinite, least_level = infinite, most_level = -infinite;
  for (const GltfUse* each : uses.of(material)) {
    const GltfUse& use = *each;
    const auto& uvs = use.uv[texture.uv_set == 1 ? 1 : 0];
    if (texture.uv_set > 1 || uvs.size() != use.world_edges.size()) {
      if (!use.world_edges.empty()) return {};  // the texels that the triangles read are not known
      continue;
    }
    for (std::size_t t = 0; t < uvs.size(); ++t) {
      std::array<Uv, 3> uv;
      for (std::size_t i = 0; i < 3; ++i)
        uv[i] = transformed(texture.transform, {double{uvs[t][i][0]}, double{uvs[t][i][1]}});
      const Densities density = densities(uv, width, height, use.world_edges[t]);
      if (!density.drawn) continue;
      least = std::min(least, std::sqrt(density.least));
      if (view_height == 0) continue;
      for (const GltfCamera& camera : uses.scene().cameras) {
        const ScreenPixels there =
            pixels(camera, use.world_center[t], double{use.world_radius[t]}, view_height);
        if (there.most == 0) continue;
        out.seen = true;
        least_level = std::min(least_level, 0.5 * math::log2(density.least) - math::log2(there.most));
        most_level = std::max(most_level, 0.5 * math::log2(density.most) - math::log2(there.fewest));
      }
    }
  }
  if (least < infinite) out.least_density = least;
  if (out.seen) out.least_level = least_level, out.most_level = most_level;
  return out;
}

}  // namespace etak
