// SPDX-License-Identifier: Apache-2.0
// Draws the rows of a mesh. There is no include guard: shade_picture.h includes this behind shade() and seen_at().

// The memory of one thread that draws a mesh: its samples, and a row of pixels.
struct MeshRow {
  MeshView::Samples samples;
  std::vector<float> pixels;
};

// Draws a row of a mesh: the light from behind it first, in place of which the fragments then come.
template <class Target>
void draw_mesh_row(const Shading& shading, const MeshView& view, int row, MeshRow& own, Chunk& c,
                   const Target& target) {
  const int width = shading.scene.width;
  const auto behind_at = [&](int column) {
    return shading.backdrop.at(shading.camera.x(column + 0.5), shading.camera.y(row + 0.5));
  };
  own.pixels.resize(4 * static_cast<std::size_t>(width));
  for (int column = 0; column < width; ++column) {
    float* const out = &own.pixels[4 * static_cast<std::size_t>(column)];
    std::ranges::copy(behind_at(column), out);
    out[3] = 0;
  }
  view.see(row, own.samples);
  const std::vector<MeshView::Fragment>& seen = own.samples.fragments;
  for (std::size_t first = 0; first < seen.size(); first += c.count) {
    c.set_count(seen.size() - first);
    for (std::size_t i = 0; i < c.whole_blocks; ++i) {
      const MeshView::Fragment& at = seen[first + std::min(i, c.count - 1)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        c.position[axis][i] = real(at.position[axis]);
        c.normal[axis][i] = real(at.normal[axis]);
        c.viewer[axis][i] = real(at.viewer[axis]);
        c.along[axis][i] = real(at.tangent[axis]);
        c.up[axis][i] = real(at.bitangent[axis]);
      }
      for (std::size_t axis = 0; axis < 2; ++axis) c.uv[axis][i] = real(at.uv[axis]);
      c.open[i] = real(at.open);
    }
    shade(shading, c);
    for (std::size_t i = 0; i < c.count; ++i) {
      const MeshView::Fragment& at = seen[first + i];
      const vec3 behind = narrowed(behind_at(at.column)),
                 more = real(at.share) * (seen_at(shading, c, i, at.column, row, behind) - behind);
      float* const out = &own.pixels[4 * static_cast<std::size_t>(at.column)];
      out[0] += float(more.x);
      out[1] += float(more.y);
      out[2] += float(more.z);
      out[3] += float(at.share);
    }
  }
  for (int x = 0; x < width; x += static_cast<int>(chunk_size)) {
    const std::size_t count = std::min(chunk_size, static_cast<std::size_t>(width - x));
    target.put(x, row, count, [&](float* pixels) {
      std::copy_n(&own.pixels[4 * static_cast<std::size_t>(x)], 4 * count, pixels);
    });
  }
}
