// SPDX-License-Identifier: Apache-2.0
// What the packer writes of a scene: its pictures, its document, and what each form of it would take.
#include <algorithm>
#include <map>

#include "core/atlas/pack/scene/scene_facts.h"
#include "core/atlas/pack/scene/scene_pictures.h"
#include "core/atlas/pack/scene/scene_state.h"
#include "core/atlas/pack/table.h"
#include "core/image/texture_bytes.h"
#include "core/scene/image_roles.h"

namespace etak {
namespace {

// The files of a scene's pages, each once, in the order in which they were first asked for.
struct ImageList {
  std::vector<std::string> names;
  std::vector<PictureHeader> headers;
  std::map<std::string, int> numbers;
  int number_of(const std::string& file, const PlannedPage& page, int channels) {
    const auto [found, fresh] = numbers.try_emplace(file, static_cast<int>(names.size()));
    if (fresh) {
      names.push_back(file);
      headers.push_back({page.width, page.height, channels});
    }
    return found->second;
  }
};

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
    if (smooth && has_form(forms, GltfForm::specular_ior)) to.roughness_image = picture("roughness", 3);
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
      const std::string what = occlusion_picture(forms, size.has[1]);
      to.occlusion_image = picture(what.c_str(), what == "occlusion" ? 1 : 3);
    }
  }
};

AtlasMaterial atlas_material(const ScenePack::State& s, const SceneMaps& scene_maps, std::size_t i,
                             const std::vector<GltfForm>& forms, const PackDecision& decision,
                             ImageList& images) {
  const ScenePack::State::Entry& entry = s.entries[i];
  const PackInput& in = s.inputs.materials[i];
  const GltfMaterial& m = s.scene.materials[static_cast<std::size_t>(entry.material)];
  const MaterialFate& fate = decision.left_out.fates[i];
  AtlasMaterial to;
  to.material = entry.material;
  const GltfTexture* const lead = leading_texture(m);
  if (lead != nullptr) to.uv_set = lead->uv_set;
  scene_constants(in.facts, m, s.gloss, to);
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
  if (on.own_page && lead != nullptr) to.sampler = lead->sampler;
  return to;
}

// The output of these forms, and the headers of its images.
struct SceneOutput {
  GltfOutput gltf;
  std::vector<PictureHeader> headers;
};
SceneOutput scene_output(const ScenePack::State& s, const SceneMaps& maps, const std::vector<GltfForm>& forms,
                         const PackDecision& decision) {
  SceneOutput out;
  out.gltf.forms = forms;
  ImageList images;
  for (std::size_t i = 0; i < s.entries.size(); ++i)
    if (s.scene.material_used[static_cast<std::size_t>(s.entries[i].material)])
      out.gltf.materials.push_back(atlas_material(s, maps, i, forms, decision, images));
  out.gltf.images = std::move(images.names);
  out.headers = std::move(images.headers);
  return out;
}

}  // namespace

bool ScenePack::State::writes_scene() const {
  const auto& formats = options.output.write.formats;
  return std::find(formats.begin(), formats.end(), "png") != formats.end();
}

std::uint64_t ScenePack::State::scene_bytes(GltfForm form, const SceneMaps& of_form,
                                            const PackDecision& decision) {
  const SceneOutput trial = scene_output(*this, of_form, {form}, decision);
  std::uint64_t bytes = 0;
  for (const PictureHeader& each : trial.headers) bytes += texture_bytes(each, true);
  const std::vector<bool> kept = images_kept(scene, trial.gltf);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const std::string& path = scene.images[i].path;
    if (kept[i] && (path.empty() || seen.insert(path).second))
      bytes += texture_bytes(header(static_cast<int>(i)), true);
  }
  return bytes;
}

// Whether what is written of the form is what was read, but for the rounding of the pair's codes.
bool ScenePack::State::is_exact(GltfForm form, const SceneMaps& of_form, const PackDecision& decision) const {
  if (form == GltfForm::specular_glossiness) return gloss != GlossForm::schueler;
  if (form == GltfForm::specular_ior) return true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const MaterialFate& fate = decision.left_out.fates[i];
    const auto material = static_cast<std::size_t>(entries[i].material);
    if (!scene.material_used[material]) continue;
    const auto found = of_form.find(fate.owner);
    if (fate.texels ? found == of_form.end() || !found->second.exact
                    : !is_plain_metal_rough(scene.materials[material]))
      return false;
  }
  return true;
}

void ScenePack::choose_pictures(const PackDecision& decision) {
  State& s = *state_;
  if (!s.writes_scene()) return;
  std::vector<int> materials;
  for (const State::Entry& entry : s.entries) materials.push_back(entry.material);
  const auto header = [&](int image) { return s.header(image); };
  const SceneMaps maps = scene_maps(s.scene, materials, s.inputs, decision, header);
  s.costs.clear();
  for (const GltfForm form : {GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough}) {
    const SceneMaps placed = worthwhile(maps, {form}, decision, header);
    s.costs.push_back({form, s.scene_bytes(form, placed, decision), s.is_exact(form, maps, decision), false});
  }
  if (s.options.output.smallest_form) {
    const FormCost* best = nullptr;
    for (const FormCost& each : s.costs)
      if (each.exact && (best == nullptr || each.gpu < best->gpu)) best = &each;
    s.forms = {best->form};
  }
  for (FormCost& each : s.costs) each.written = has_form(s.forms, each.form);
  s.maps = worthwhile(maps, s.forms, decision, header);
  s.output = scene_output(s, s.maps, s.forms, decision).gltf;
}

const std::vector<FormCost>& ScenePack::form_costs() const {
  return state_->costs;
}

void ScenePack::write_page(OutputFolder& folder, int page, const PagePixels& pixels,
                           const PackDecision& decision, const WriteOptions& options) {
  State& s = *state_;
  if (!s.writes_scene()) return;
  const MapPixels maps = map_pixels(page, s.maps, s.inputs, decision, options.threads,
                                    [&](int image) { return s.decoded(image); });
  const ScenePictureInput in{page, pixels, maps, s.maps, decision, s.output.images, s.gloss};
  for (std::string& name : write_scene_pictures(folder, in, {options.png_level, options.threads}))
    s.written.insert(std::move(name));
}

std::vector<std::string> ScenePack::write_scene(OutputFolder& folder, const AtlasLayout& layout) {
  State& s = *state_;
  if (!s.writes_scene()) return {};
  GltfOutput& out = s.output;
  out.taken.emplace(s.written.begin(), s.written.end());
  for (const AtlasPage& page : layout.pages)
    for (const auto& files : page.files) out.taken->insert(files.begin(), files.end());
  out.taken->insert({out.buffer_name, "scene.gltf", layout_file_name});
  const WrittenGltf written = write_gltf(s.scene, out);
  std::vector<std::string> names(s.written.begin(), s.written.end());
  for (const CopiedFile& copy : written.files) {
    FileBytes file;
    file.load(copy.from);
    folder.write(copy.name, file.view());
    names.push_back(copy.name);
  }
  folder.write("scene.gltf", written.json);
  names.push_back("scene.gltf");
  if (!written.buffer.empty()) {
    folder.write(out.buffer_name, written.buffer);
    names.push_back(out.buffer_name);
  }
  return names;
}

}  // namespace etak
