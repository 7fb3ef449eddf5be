// SPDX-License-Identifier: Apache-2.0
// What the gltf_write_*json.cpp files share: no public header, because it names nlohmann-json.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/gltf_json.h"

namespace etak {

/// A document that is being changed. Buffers with new data are appended, each with one view.
struct GltfRewrite {
  const GltfScene& scene;
  const GltfOutput& output;
  Json root;
  std::vector<std::string_view> buffers;     // of `root`, in its order
  std::deque<std::string> added;             // bytes of the new ones; a deque, because buffers points into it
  std::map<std::vector<int>, int> textures;  // made so far: image of the output and sampler to texture

  ~GltfRewrite() { take_apart(root); }
  GltfDocument document() const { return {root, scene.path, buffers}; }
  /// The index of a new element of an array of the document, which is made where it is absent.
  int append(const char* array, Json element);
};

/// Names of extensions that the writer takes away and puts in.
inline constexpr std::array atlas_extensions{"KHR_materials_ior", "KHR_materials_specular",
                                             "KHR_materials_pbrSpecularGlossiness"};

/// Throws Error for an output that contradicts itself or the scene.
void check_output(const GltfRewrite& rewrite);

/// Puts the atlas into the document's material. Its UVs are then set `uv_set` under `transform`.
void write_material(GltfRewrite& rewrite, const AtlasMaterial& material, int uv_set,
                    const UvTransform& transform);

/// Whether the UVs of a material have to be rewritten, and where not, its transform.
std::optional<UvTransform> transform_of(const GltfScene& scene, const AtlasMaterial& material);

/// The UV set that the rewritten UVs of a material go to: the one they come from when no other texture and no
/// other material needs it, else a new one.
int uv_set_for(const GltfRewrite& rewrite, const AtlasMaterial& material);

/// Rewrites the UVs of every primitive of the material into `uv_set`.
void rewrite_uvs(GltfRewrite& rewrite, const AtlasMaterial& material, int uv_set);

/// The last steps: drop_unused() drops elements that nothing refers to any more, compact_buffers() makes one
/// buffer of the rest and returns its bytes, name_extensions() lists the extensions in use.
void drop_unused(GltfRewrite& rewrite, const Json& before);
std::string compact_buffers(GltfRewrite& rewrite);
void name_extensions(GltfRewrite& rewrite, const Json& before);

}  // namespace etak
