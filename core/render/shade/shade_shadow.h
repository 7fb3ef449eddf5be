// SPDX-License-Identifier: Apache-2.0
// The light that a mesh keeps from itself. There is no include guard: shade_picture.h includes this behind Shading.

void keep_visible(Chunk& c) {
  for (std::size_t i = 0; i < c.count; ++i) c.irradiance[i] *= c.visible[i];
}

// Takes away the light of a lamp without size. In a refined picture four rays from within the pixel soften the edge
// of the shadow; a moving picture has one.
void hide_light(const Shading& shading, const ChunkLight& light, Chunk& c) {
  const MeshShape& mesh = *shading.scene.mesh;
  const double step = shading.camera.pixel() / 4;
  const int rays = shading.scene.refined ? 4 : 1;
  for (std::size_t i = 0; i < c.count; ++i) {
    c.visible[i] = 1;
    if (!(c.irradiance[i] > 0)) continue;
    Vec3 way{double(light.dx), double(light.dy), double(light.dz)};
    double length = 1e9;
    const Vec3 at{double(c.position[0][i]), double(c.position[1][i]), double(c.position[2][i])};
    if (!light.directional) {
      for (std::size_t axis = 0; axis < 3; ++axis) way[axis] = double(c.to_light[axis][i]);
      const double x = double(light.px) - at[0], y = double(light.py) - at[1], z = double(light.pz) - at[2];
      length = std::sqrt(x * x + y * y + z * z);
    }
    int open = 0;
    for (int ray = 0; ray < rays; ++ray) {
      const double along = rays == 1      ? 0
                           : ray % 2 == 0 ? -step
                                          : step,
                   across = rays == 1 ? 0
                            : ray < 2 ? -step
                                      : step;
      const Vec3 from{at[0] + along * double(c.tangent_x[i]) + across * double(c.bitangent[0][i]),
                      at[1] + across * double(c.bitangent[1][i]),
                      at[2] + along * double(c.tangent_z[i]) + across * double(c.bitangent[2][i])};
      if (!mesh.hides(from, way, length)) ++open;
    }
    c.visible[i] = real(open) / real(rays);
  }
  keep_visible(c);
}

// Finds the share of a piece of an area light that the points see, by rays to a grid of its places.
void find_visible(const Shading& shading, const vec3* corners, Chunk& c) {
  const MeshShape& mesh = *shading.scene.mesh;
  const int side = shading.scene.refined ? 4 : 2;
  for (std::size_t i = 0; i < c.count; ++i) {
    const Vec3 at{double(c.position[0][i]), double(c.position[1][i]), double(c.position[2][i])};
    int open = 0;
    for (int place = 0; place < side * side; ++place) {
      const real u = (real(place % side) + real(0.5)) / real(side),
                 v = (real(place / side) + real(0.5)) / real(side);
      const vec3 there =
          (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
      const Vec3 to{double(there.x) - at[0], double(there.y) - at[1], double(there.z) - at[2]};
      const double length = std::sqrt(etak::dot(to, to));
      if (!mesh.hides(at, scaled(to, 1 / std::max(length, 1e-30)), length)) ++open;
    }
    c.visible[i] = real(open) / real(side * side);
  }
}
