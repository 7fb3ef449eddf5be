// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/row_runs.h"
#include "core/image/picture.h"
#include "core/image/wrap.h"
#include "core/math/mesh.h"
#include "core/math/mesh_door.h"
#include "core/scene/uv_transform.h"

namespace etak {

// glTF 2.0 scenes as an atlas needs them: which materials the scene reaches, their textures and factors, and
// where on their textures its triangles lie. Geometry is kept as UVs and areas, and as a mesh where one is asked for.
// Based on:
// Khronos glTF 2.0 specification; KHR_materials_ior, KHR_materials_specular,
// KHR_materials_pbrSpecularGlossiness (archived), KHR_texture_transform, KHR_materials_variants.

/// How a texture is looked up.
struct GltfSampler {
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool mipmaps = true;  // the minification filter reads mips
  bool nearest = false;
  friend bool operator==(const GltfSampler&, const GltfSampler&) = default;
};

/// One texture of a material: its image, its sampler, and the UVs that look it up.
struct GltfTexture {
  int image = -1;
  GltfSampler sampler;
  int uv_set = 0;
  UvTransform transform;
  friend bool operator==(const GltfTexture&, const GltfTexture&) = default;
};

enum class AlphaMode { opaque, mask, blend };

/// "opaque", "mask" or "blend", as manifests, projects and layouts write it.
constexpr const char* name(AlphaMode mode) {
  return mode == AlphaMode::opaque ? "opaque" : mode == AlphaMode::mask ? "mask" : "blend";
}

inline constexpr const char* alpha_mode_names = "opaque, mask or blend";

/// The mode of that name, if there is one.
constexpr std::optional<AlphaMode> alpha_mode_named(std::string_view text) {
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend})
    if (text == name(mode)) return mode;
  return {};
}

/// A material with the defaults of the specification filled in. Factors are linear.
struct GltfMaterial {
  std::string name;
  int index = -1;  // in the document
  // metallic-roughness
  std::array<double, 4> base_color{1, 1, 1, 1};
  std::optional<GltfTexture> base_color_texture;  // sRGB RGB, alpha
  double metallic = 1, roughness = 1;
  std::optional<GltfTexture> metallic_roughness_texture;  // G roughness, B metallic
  // KHR_materials_ior, KHR_materials_specular
  double ior = 1.5;
  double specular = 1;
  std::optional<GltfTexture> specular_texture;  // A
  std::array<double, 3> specular_color{1, 1, 1};
  std::optional<GltfTexture> specular_color_texture;  // sRGB RGB
  // KHR_materials_pbrSpecularGlossiness; replaces all of the above when present
  bool specular_glossiness = false;
  std::array<double, 4> diffuse{1, 1, 1, 1};
  std::optional<GltfTexture> diffuse_texture;  // sRGB RGB, alpha
  std::array<double, 3> specular_f0{1, 1, 1};
  double glossiness = 1;
  std::optional<GltfTexture> specular_glossiness_texture;  // sRGB F0, A glossiness

  std::optional<GltfTexture> normal_texture;
  double normal_scale = 1;
  std::optional<GltfTexture> occlusion_texture;  // R
  std::optional<GltfTexture> emissive_texture;   // sRGB RGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = false;
  // KHR_materials_unlit: base colour and alpha are all that is seen, and stand here as those of a dielectric
  // without further textures.
  bool unlit = false;
  // It has extensions that are not read here (KHR_materials_clearcoat, MSFT_lod, ...), beside which
  // KHR_materials_pbrSpecularGlossiness may not stand.
  bool further_extensions = false;
};

/// The textures an atlas replaces, none of them null: colour, then metal-rough or specular-gloss, then the
/// extensions'. Empty for a material of factors alone.
std::vector<const GltfTexture*> replaced_textures(const GltfMaterial& material);

/// The first of them, whose UV set, transform and sampler stand for all of them; null where there is none.
const GltfTexture* leading_texture(const GltfMaterial& material);

/// Whether all textures an atlas replaces are looked up at the same place: one set, transform, wrap and filter.
bool textures_agree(const GltfMaterial& material);

/// The least and the most by which COLOR_0 multiplies base colour, per channel.
struct VertexColors {
  std::array<double, 3> least{1, 1, 1}, most{1, 1, 1};

  void add(const VertexColors& other) {
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], other.least[c]);
      most[c] = std::max(most[c], other.most[c]);
    }
  }
};

/// Triangles of one primitive under one material, once for every node that draws it: UVs per set, and the
/// world area and texture area they stand for. A line is a triangle of two corners, the second of them twice, and a
/// point one whose corners are the same.
struct GltfUse {
  int material = -1;    // index into GltfScene::materials
  int same_uv_as = -1;  // an earlier use of the same primitive and material (another node draws it)
  std::vector<std::array<std::array<float, 2>, 3>> uv[2];  // per uv set; empty when the primitive lacks it
  std::vector<float> world_area;                           // per triangle, after the node's transform
  std::vector<std::array<float, 3>> world_center;          // per triangle
  std::vector<float> world_radius;  // per triangle: its farthest corner from the centre
  // Per triangle, of its edges a and b from the first corner: a a, a b, b b in the world.
  std::vector<std::array<float, 3>> world_edges;
  VertexColors colors;
  std::set<int> morphed_uv_sets;  // sets whose UVs morph targets move
};

/// A camera of the scene, with its place in the world.
struct GltfCamera {
  std::string name;
  bool perspective = true;
  double yfov = 0.8, znear = 0.01;  // perspective
  double ymag = 1;                  // orthographic: half height
  std::array<double, 3> position{0, 0, 0};
  std::array<double, 3> direction{0, 0, -1};  // world
};

/// Which parts of a document are read.
struct GltfOptions {
  std::optional<int> scene;  // none: the document's, else the first
  bool all_scenes = false;
  bool variants = true;     // materials of KHR_materials_variants count as used
  bool mesh = false;        // GltfScene::mesh is filled
  MeshDoor mesh_door = {};  // for meshes that are compressed
};

/// The parts of a glTF document that packing and checking need.
struct GltfScene {
  std::string path;
  GltfOptions options;  // what it was read with
  // All of the document: files beside it, or bytes inside (buffer view or data URI) under "SCENE#/images/3".
  std::vector<PictureFile> images;
  std::vector<GltfMaterial> materials;  // all of the document; [i].index == i
  std::vector<bool> material_used;      // reached from the scene (and from variants, when those are kept)
  std::vector<bool> material_written;   // used, or reached from another scene: a written document keeps it
  std::vector<bool> image_used;         // by a material that a written document keeps
  std::vector<GltfUse> uses;
  std::vector<GltfCamera> cameras;  // reached
  // All triangles that are reached, moved by their nodes, of any material, with the UVs of the first set. Throws Error
  // for those without normals.
  Mesh mesh;
  std::size_t scenes = 0, variants = 0;
  std::vector<std::string> variant_names;
  std::string unpacked;  // which meshes were decompressed, for people; empty: none
  // The document's JSON text and the bytes of each buffer, for the writer. Meshes are not compressed any more.
  std::shared_ptr<const std::string> json;
  std::shared_ptr<const std::vector<std::string>> buffers;
};

/// The limits of what is read: triangles of all uses together, and elements of an accessor that has no bytes
/// of its own (so that a small file cannot ask for much memory).
inline constexpr std::size_t most_gltf_triangles = std::size_t{1} << 24;
inline constexpr std::size_t most_gltf_elements_without_bytes = std::size_t{1} << 20;
inline constexpr std::size_t most_gltf_buffer_bytes = std::size_t{1} << 31;

/// Reads .gltf or .glb with its buffers and inside images (pictures beside it are not opened). Throws Error
/// naming file and JSON pointer: broken JSON, indices and accessors out of range, wrong types, files outside
/// of the scene's folder ("..", absolute, with a scheme, behind a link: core/base/files/links.h), nodes that
/// are reached twice, required extensions that are not known.
///   Meshes that Draco or meshopt has compressed are decompressed by the door of the options; where uncompressed ones
///   lie beside them, these are read.
///   All modes of primitives are uses; skins and morph targets do not move them. Extensions that place copies
///   (EXT_mesh_gpu_instancing) are not looked at. Primitives without a material are no use. What MSFT_lod puts in the
///   place of a node or material is used too. Of scenes that `options` do not name the uses are read, because they
///   share textures with the others; their materials are not used, nor their cameras.
GltfScene read_gltf(const std::string& path, const GltfOptions& options);

/// Whether `path` is a glTF scene: a file by its ending, .gltf or .glb; a pipe by its first bytes.
bool is_gltf_file(const std::string& path);

/// The files that a document names, as paths beside it: pictures, and all of them (buffers too).
struct GltfFiles {
  std::vector<std::string> pictures, all;
};

/// The files of the scene at `path`, none of which is read. Empty when the document cannot be read, and
/// without names that read_gltf() refuses: read_gltf() then tells why.
GltfFiles files_of_gltf(const std::string& path);

/// A scene from bytes in memory; `path` names them and its folder holds the files they refer to.
GltfScene parse_gltf(std::string_view bytes, const std::string& path, const GltfOptions& options);

/// A box of a material's texture that was moved by itself.
struct AtlasIsland {
  std::array<int, 4> box{0, 0, 0, 0};  // x, y, width, height in texels of the texture
  UvTransform region;                  // as AtlasMaterial::region, for this box
  // Where boxes of other islands overlap this one: the texels of the texture that belong to it. A triangle lies in the
  // island that has the texel at its centre.
  RowRuns texels = {};
};

/// What the atlas puts in place of a material's textures.
struct AtlasMaterial {
  int material = -1;  // index in the document
  // From the UVs of the material's texture (after the material's own transform; [0,1]^2 is the whole texture,
  // so a crop is part of the offset) to those of the page: see region_transform() and TexelUse::fold. The
  // writer composes it with the material's own transform, and rewrites the UVs where the two make a shear.
  UvTransform region;
  int uv_set = 0;                  // which the material's textures read
  std::optional<UvTransform> own;  // none: that of leading_texture()
  // Boxes that share no transform: the UVs of the material's triangles are rewritten vertex by vertex, into a
  // set of their own where other textures still read the old one; vertices that two boxes share are doubled.
  // Boxes without texels of their own may not overlap, and each triangle must lie in one, up to half a texel. `region` is then not used.
  std::vector<AtlasIsland> islands;
  int texture_width = 0, texture_height = 0;  // the texels of the boxes; needed with islands

  // Indices into GltfOutput::images; none: the scalars below hold. With an image its scalar is not used.
  std::optional<int> diffuse_alpha_image;
  std::optional<int> specular_gloss_image;    // A: 1 - roughness, read by form specular_glossiness alone
  std::optional<int> roughness_image;         // G roughness, B = 0 (no metal)
  std::array<double, 4> diffuse{1, 1, 1, 1};  // factors (linear) where no texture
  std::array<double, 3> specular{0.04, 0.04, 0.04};  // F0
  double roughness = 1;
  // Images and factors of the form metal_rough alone, solved by metal_rough_of() of core/scene/material_texels.h.
  std::optional<int> base_color_image;          // sRGB RGB, alpha
  std::optional<int> metallic_roughness_image;  // G roughness, B metallic
  std::array<double, 4> base_color{1, 1, 1, 1};
  double metallic = 0;
  // The two hold the texels of the material's own textures, under its own factors: lossless. Where one is absent
  // the material keeps that texture as it is.
  bool own_factors = false;
  // Whether own factors hold the one colour of the texture of base colour, or of metal and roughness, which is not written then.
  bool base_color_in_factors = false, metal_rough_in_factors = false;

  // The material's other textures, where they lie on the pages as the pair does; none: they stay as they are.
  std::optional<int> normal_image, occlusion_image, emissive_image;

  // How the page is sampled; none: clamped, filtered as leading_texture() is.
  std::optional<GltfSampler> sampler;
};

/// How a material is written.
///   specular_ior          metallic 0, F0 in specularColorTexture of KHR_materials_specular, and
///                         KHR_materials_ior 0, which makes that F0's scale 1: lossless. Where light passes
///                         through (transmission, volume) the index stays and the scale is divided out.
///   specular_glossiness   KHR_materials_pbrSpecularGlossiness
///   metal_rough           plain core glTF: lossless where the material was of that form and its textures are
///                         placed as they are, else solved from F0 and diffuse: lossy
enum class GltfForm { specular_ior, specular_glossiness, metal_rough };

inline bool has_form(const std::vector<GltfForm>& forms, GltfForm form) {
  return std::find(forms.begin(), forms.end(), form) != forms.end();
}

/// How the materials of a scene are written, with the pages of an atlas as textures.
struct GltfOutput {
  std::vector<std::string> images;  // file names beside the glTF
  std::vector<AtlasMaterial> materials;
  // One, or metal_rough and specular_glossiness together (core and extension of one material).
  // KHR_materials_specular may not stand beside the other two in one material: that takes two files.
  std::vector<GltfForm> forms{GltfForm::specular_ior};
  std::string buffer_name = "scene.bin";
  // For each image of the document the one that stands for it: first_of_same_images() of image_roles.h. Empty:
  // each stands for itself.
  std::vector<int> stands_for;
  // Images of the document that are written as another file, which reads the same: its name beside the scene.
  std::map<int, std::string> rewritten;
  // The names that are taken in the folder of the written document. The files to which that still refers are
  // copied there; a number is put before a name that is taken, so that a picture of the scene does not
  // replace a page of the atlas of the same name. None: the files keep their URIs, and no name in `images`
  // may be one of theirs.
  std::optional<std::set<std::string>> taken;
};

/// A file to which a written scene refers, and its name beside the scene.
struct CopiedFile {
  std::string from, name;
};

/// A written scene: its two files, and those that it refers to.
struct WrittenGltf {
  std::string json;               // the document's text
  std::string buffer;             // the bytes of its only buffer, without images that were replaced
  std::vector<CopiedFile> files;  // where GltfOutput::taken is given
};

/// The document with the materials' textures replaced by the atlas: everything else (meshes, nodes, cameras,
/// animations, other textures such as normal maps) stays; materials not named in `output` stay as they are.
/// Materials that no scene reaches, and images, textures and samplers without a reader are left out, and primitives
/// that no scene draws lose their material. KHR_texture_transform becomes required where it is used. Throws Error for what
/// cannot be kept: animated materials, EXT_lights_image_based, morphed UVs that would have to be rewritten;
/// and for `output` that contradicts itself. Pictures whose name ends in ".webp" are read by EXT_texture_webp, which is
/// then required.
WrittenGltf write_gltf(const GltfScene& scene, const GltfOutput& output);

/// The written scene as one file, .glb.
///   pictures   by their names beside the document: the files that go into it; others stay beside it
///   file       for messages
/// Throws Error for more than 4 GiB.
std::string one_file(const WrittenGltf& written, const std::map<std::string, std::string>& pictures,
                     const std::string& file);

}  // namespace etak
