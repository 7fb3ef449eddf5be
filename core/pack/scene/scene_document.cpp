// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/scene_document.h"

#include <algorithm>
#include <array>

#include "core/color/srgb.h"
#include "core/image/texture_bytes.h"
#include "core/pack/pack.h"
#include "core/pack/scene/scene_facts.h"
#include "core/pack/scene/scene_pictures.h"
#include "core/pack/table.h"

namespace etak {
namespace {

// Which pictures of its page a material reads.
//   maps   of the texels' owner; null: none
struct ImagesOfMaterial {
  const std::vector<GltfForm>& forms;
  const PackDecision& decision;
  ImageList& images;

  void set(const GltfMaterial& m, const MaterialFate& fate, const MaterialMaps* maps, int page,
           AtlasMaterial& to) {
    const PlannedPage& size = decision.plan.pages[static_cast<std::size_t>(page)];
    const auto picture = [&](const char* what, int channels) {
      return images.number_of(scene_picture(page, what), size, channels);
    };
    const auto texture = [&](Texture which) {
      return images.number_of(page_file(page, which, "png"), size, 4);
    };
    const auto varies = [&](std::size_t first, std::size_t count) {
      for (std::size_t c = first; c < first + count; ++c)
        if (!fate.constant[c]) return true;
      return false;
    };
    const bool plain = has_form(forms, GltfForm::metal_rough);
    const bool gloss = has_form(forms, GltfForm::specular_glossiness);
    const bool exact = plain && maps != nullptr && maps->exact;
    const bool f0 = varies(4, 3) && size.has[1], smooth = varies(7, 1) && size.has[1];
    // Plain glTF alone reads no texel of the pair.
    if (!plain || gloss) {
      if (varies(0, 4) && size.has[0]) to.diffuse_alpha_image = texture(Texture::diffuse_alpha);
      if (gloss ? f0 || smooth : f0) to.specular_gloss_image = texture(Texture::specular_gloss);
    }
    if (smooth && has_form(forms, GltfForm::specular_ior)) to.roughness_image = picture("roughness", 1);
    if (plain && (!exact || (maps->base_color && m.base_color_texture)))
      to.base_color_image = picture("base_color", 4);
    if (plain && (!exact || (maps->metal_rough && m.metallic_roughness_texture)))
      to.metallic_roughness_image = picture("metal_rough", 3);
    if (exact) {
      to.own_factors = true;
      to.base_color = m.base_color;
      to.metallic = m.metallic;
      to.roughness = m.roughness;
    }
    if (maps == nullptr) return;
    if (maps->normal && m.normal_texture) to.normal_image = picture("normal", 3);
    if (maps->emissive && m.emissive_texture) to.emissive_image = picture("emissive", 3);
    if (maps->occlusion && m.occlusion_texture) {
      const std::string what = occlusion_picture(forms);
      to.occlusion_image = picture(what.c_str(), what == "occlusion" ? 1 : 3);
      images.occluded.insert(scene_picture(page, what));
    }
  }
};

// A material that keeps all of its textures keeps its UVs too.
bool reads_pages(const AtlasMaterial& m) {
  const std::array images{
      m.diffuse_alpha_image,      m.specular_gloss_image, m.roughness_image, m.base_color_image,
      m.metallic_roughness_image, m.normal_image,         m.occlusion_image, m.emissive_image};
  return std::any_of(images.begin(), images.end(), [](const auto& image) { return image.has_value(); });
}

// Puts the one colour of textures that stay beside the pages into the material's own factors.
void fold_textures(const SceneRead& s, const GltfMaterial& m, AtlasMaterial& to) {
  if (!to.own_factors) return;
  const auto texel_of = [&](const std::optional<GltfTexture>& texture) -> const OneTexel* {
    if (!texture) return nullptr;
    const auto found = s.light.find(s.stands_for[static_cast<std::size_t>(texture->image)]);
    return found != s.light.end() && found->second.texel ? &*found->second.texel : nullptr;
  };
  if (const OneTexel* one = to.base_color_image ? nullptr : texel_of(m.base_color_texture)) {
    for (std::size_t c = 0; c < 3; ++c) to.base_color[c] *= srgb_decode(one->rgba[c] / 255.0);
    to.base_color[3] *= one->rgba[3] / 255.0;
    to.base_color_in_factors = true;
  }
  if (const OneTexel* one = to.metallic_roughness_image ? nullptr : texel_of(m.metallic_roughness_texture)) {
    to.roughness *= one->rgba[1] / 255.0;
    to.metallic *= one->rgba[2] / 255.0;
    to.metal_rough_in_factors = true;
  }
}

AtlasMaterial atlas_material(const SceneRead& s, const SceneMaps& scene_maps, std::size_t i,
                             const std::vector<GltfForm>& forms, const PackDecision& decision,
                             ImageList& images) {
  const SceneRead::Entry& entry = s.entries[i];
  const PackInput& in = s.inputs.materials[i];
  const GltfMaterial& m = s.material(entry);
  const MaterialFate& fate = decision.left_out.fates[i];
  AtlasMaterial to;
  to.material = entry.material;
  const GltfTexture* const lead = leading_texture(m);
  if (lead != nullptr) to.uv_set = lead->uv_set;
  scene_constants(in.facts, m, s.gloss, entry.own, to);
  if (!fate.texels) return to;
  BoxesOnPage on = boxes_of(in, fate.owner, decision);
  to.islands = std::move(on.boxes);
  if (to.islands.size() == 1) {
    AtlasIsland only = to.islands.front();
    to.islands.clear();
    if (entry.use && !entry.tiles)
      if (const auto composition = composed(only.region, entry.use->fold)) only.region = *composition;
    to.region = only.region;
    // One box for triangles of several periods: their UVs must be folded one by one.
    if (entry.use && entry.use->tiles && !entry.tiles) to.islands.push_back(only);
  }
  to.texture_width = in.width;
  to.texture_height = in.height;
  const auto maps = scene_maps.find(fate.owner);
  ImagesOfMaterial{forms, decision, images}.set(m, fate, maps == scene_maps.end() ? nullptr : &maps->second,
                                                on.page, to);
  fold_textures(s, m, to);
  if (on.own_page && lead != nullptr) to.sampler = lead->sampler;
  if (!reads_pages(to)) to.islands.clear(), to.region = {};
  return to;
}

}  // namespace

int ImageList::number_of(const std::string& file, const PlannedPage& page, int channels) {
  const auto [found, fresh] = numbers.try_emplace(file, static_cast<int>(names.size()));
  if (fresh) {
    names.push_back(file);
    headers.push_back({page.width, page.height, channels});
  }
  return found->second;
}

TextureTotals SceneOutput::totals(const PackDecision& decision) const {
  TextureTotals out;
  for (std::size_t i = 0; i < images.names.size(); ++i) out.add(file(i, decision));
  return out;
}

// Where files are not weighed, with as many channels as the picture may have: pictures that turn out to be
// grey take less.
TextureTotals SceneOutput::file(std::size_t image, const PackDecision& decision) const {
  const std::string& name = images.names[image];
  if (decision.sizes) {
    const auto& [files, bare] = (*decision.sizes)[static_cast<std::size_t>(others)];
    const auto& sizes = bare.contains(name) && !images.occluded.contains(name) ? bare : files;
    if (const auto found = sizes.find(name); found != sizes.end()) return found->second;
  }
  return {1, 0, texture_bytes(images.headers[image], true)};
}

bool is_written(const SceneRead& read, const SceneRead::Entry& entry, Others others) {
  return read.is_used(entry) && (others == Others::written || is_plain_metal_rough(read.material(entry)));
}

bool stays_for_its_extensions(const GltfMaterial& m, const std::vector<GltfForm>& forms) {
  return has_form(forms, GltfForm::specular_glossiness) && m.further_extensions && !m.unlit;
}

Others others_in(const SceneRead& read, const std::vector<GltfForm>& forms) {
  const bool plain_alone = forms == std::vector{GltfForm::metal_rough};
  return read.options.output.smallest_form && plain_alone ? Others::stay : Others::written;
}

SceneOutput scene_output(const SceneRead& s, const SceneMaps& maps, const std::vector<GltfForm>& forms,
                         const PackDecision& decision) {
  SceneOutput out;
  out.gltf.forms = forms;
  out.others = others_in(s, forms);
  out.gltf.stands_for = s.stands_for;
  for (const auto& [image, picture] : s.light)
    if (picture.texel) out.gltf.rewritten.emplace(image, picture.texel->name);
  for (std::size_t i = 0; i < s.entries.size(); ++i)
    if (is_written(s, s.entries[i], out.others) && !stays_for_its_extensions(s.material(s.entries[i]), forms))
      out.gltf.materials.push_back(atlas_material(s, maps, i, forms, decision, out.images));
  out.gltf.images = out.images.names;
  return out;
}

}  // namespace etak
