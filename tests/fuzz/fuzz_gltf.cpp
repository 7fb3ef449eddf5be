// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the scene reader answers with an Error or with a scene that keeps its promises, whose
// texels in use can be found and which can be written and read again. The first byte picks the options.
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/image/mesh_codecs.h"
#include "core/scene/gltf.h"
#include "core/scene/gltf_surfaces.h"
#include "core/scene/uv_use.h"

using namespace etak;

namespace {

void check(const GltfScene& scene) {
  assert(scene.material_used.size() == scene.materials.size() &&
         scene.image_used.size() == scene.images.size());
  for (const auto& triangle : scene.mesh.triangles)
    for (const auto corner : triangle) assert(corner < scene.mesh.vertices.size());
  for (const GltfUse& use : scene.uses) {
    assert(use.material >= 0 && static_cast<std::size_t>(use.material) < scene.materials.size());
    assert(use.world_area.size() == use.world_center.size());
    for (const auto& uvs : use.uv) assert(uvs.empty() || uvs.size() == use.world_area.size());
  }
}

/// Every used material on islands of its own; the islands fit where the UVs do.
GltfOutput atlas_of(const GltfScene& scene) {
  GltfOutput output;
  output.images = {"a.png", "b.png"};
  for (const GltfMaterial& material : scene.materials) {
    if (!scene.material_used[static_cast<std::size_t>(material.index)]) continue;
    AtlasMaterial& m = output.materials.emplace_back();
    m.material = material.index;
    m.diffuse_alpha_image = 0;
    m.specular_gloss_image = 1;
    const GltfTexture* texture = leading_texture(material);
    if (!texture) continue;
    assert(texture->image >= 0 && static_cast<std::size_t>(texture->image) < scene.images.size());
    m.uv_set = texture->uv_set;
    const TexelUse use = texel_use(scene, material.index, *texture, 16, 9);
    assert(use.touched <= use.mask.size());
    if (!use.foldable || use.footprints.empty()) continue;
    for (const Island& i : islands(use, 1, 4))
      m.islands.push_back({{i.x, i.y, i.width, i.height}, {{0.5, 0}, {0.5, 1}, 0}});
    m.texture_width = use.width;
    m.texture_height = use.height;
  }
  return output;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  GltfOptions options;
  options.all_scenes = (data[0] & 1) != 0;
  options.variants = (data[0] & 2) == 0;
  if ((data[0] & 4) != 0) options.scene = 1;
  options.mesh = (data[0] & 8) != 0;
  if ((data[0] & 16) != 0) options.mesh_door = mesh_door();
  const std::vector<char> bytes(data + 1, data + size);
  GltfScene scene;
  GltfOutput output;
  std::string text;
  try {
    scene = parse_gltf({bytes.data(), bytes.size()}, "no such folder/scene.gltf", options);
    check(scene);
    assert(surfaces_of_gltf(scene).size() == scene.materials.size());
    output = atlas_of(scene);
    text = write_gltf(scene, output).json;
  } catch (const Error&) {
    return 0;
  }
  assert(!text.empty());
  return 0;
}
