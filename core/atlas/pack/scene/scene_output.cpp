// SPDX-License-Identifier: Apache-2.0
// What the packer writes of a scene: its pictures, its document, and what each form of it would take.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "core/atlas/pack/scene/scene_facts.h"
#include "core/atlas/pack/scene/scene_pictures.h"
#include "core/atlas/pack/scene/scene_state.h"
#include "core/atlas/pack/table.h"
#include "core/base/files/steady_file.h"
#include "core/color/srgb.h"
#include "core/image/files/png_keep.h"
#include "core/image/texture_bytes.h"
#include "core/scene/image_roles.h"

namespace etak {
namespace {

constexpr std::array all_forms{GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough};

// The files of a scene's pages, each once, in the order in which they were first asked for.
struct ImageList {
  std::vector<std::string> names;
  std::vector<PictureHeader> headers;
  std::map<std::string, int> numbers;
  std::set<std::string> occluded;  // those whose red channel holds occlusion
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
void fold_textures(const ScenePack::State& s, const GltfMaterial& m, AtlasMaterial& to) {
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
  fold_textures(s, m, to);
  if (on.own_page && lead != nullptr) to.sampler = lead->sampler;
  if (!reads_pages(to)) to.islands.clear(), to.region = {};
  return to;
}

// The output of these forms, and the images that it names.
struct SceneOutput {
  GltfOutput gltf;
  ImageList images;
  Others others;

  // What the images that it names take.
  TextureTotals totals(const PackDecision& decision) const {
    TextureTotals out;
    for (std::size_t i = 0; i < images.names.size(); ++i) out.add(file(i, decision));
    return out;
  }

 private:
  // Where files are not weighed, with as many channels as the picture may have: pictures that turn out to be
  // grey take less.
  TextureTotals file(std::size_t image, const PackDecision& decision) const {
    const std::string& name = images.names[image];
    if (decision.sizes) {
      const auto& [files, bare] = (*decision.sizes)[static_cast<std::size_t>(others)];
      const auto& sizes = bare.contains(name) && !images.occluded.contains(name) ? bare : files;
      if (const auto found = sizes.find(name); found != sizes.end()) return found->second;
    }
    return {1, 0, texture_bytes(images.headers[image], true)};
  }
};

bool is_written(const ScenePack::State& s, int material, Others others) {
  const auto index = static_cast<std::size_t>(material);
  return s.scene.material_used[index] &&
         (others == Others::written || is_plain_metal_rough(s.scene.materials[index]));
}

SceneOutput scene_output(const ScenePack::State& s, const SceneMaps& maps, const std::vector<GltfForm>& forms,
                         const PackDecision& decision) {
  SceneOutput out;
  out.gltf.forms = forms;
  out.others = s.others_in(forms);
  out.gltf.stands_for = s.stands_for;
  for (const auto& [image, picture] : s.light)
    if (picture.texel) out.gltf.rewritten.emplace(image, picture.texel->name);
  for (std::size_t i = 0; i < s.entries.size(); ++i)
    if (is_written(s, s.entries[i].material, out.others))
      out.gltf.materials.push_back(atlas_material(s, maps, i, forms, decision, out.images));
  out.gltf.images = out.images.names;
  return out;
}

}  // namespace

bool ScenePack::State::writes_scene() const {
  const auto& formats = options.output.write.formats;
  return std::find(formats.begin(), formats.end(), "png") != formats.end();
}

TextureTotals ScenePack::State::image_totals(int index) {
  const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
  const std::uint64_t gpu = texture_bytes(header(index), true);
  return {1, image.path.empty() ? image.bytes.size() : std::filesystem::file_size(image.path), gpu};
}

TextureTotals ScenePack::State::kept_totals(int image) {
  const auto found = light.find(image);
  return found == light.end() ? image_totals(image) : found->second.totals;
}

TextureTotals ScenePack::State::input_totals(const std::vector<bool>& images) {
  TextureTotals out;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string& path = scene.images[i].path;
    if (images[i] && (path.empty() || seen.insert(path).second)) out.add(image_totals(static_cast<int>(i)));
  }
  return out;
}

TextureTotals ScenePack::State::kept_totals(const std::vector<bool>& images) {
  TextureTotals out;
  std::vector<bool> as_they_are = images;
  std::set<std::string> files;
  for (const auto& [image, picture] : light) {
    const auto i = static_cast<std::size_t>(image);
    as_they_are[i] = false;
    if (images[i] && files.insert(picture.texel ? picture.texel->name : scene.images[i].path).second)
      out.add(picture.totals);
  }
  out.add(input_totals(as_they_are));
  return out;
}

std::vector<int> ScenePack::State::kept_light() const {
  if (light.empty() || costs.empty()) return {};  // nothing is decided yet
  const std::vector<bool> kept = images_kept(scene, output);
  std::vector<int> out;
  for (const auto& [image, picture] : light)
    if (kept[static_cast<std::size_t>(image)]) out.push_back(image);
  return out;
}

void ScenePack::State::tell_light_pictures(std::vector<std::string>& remarks_) {
  std::uint64_t bytes = 0;
  for (const int image : kept_light()) {
    const LightPicture& picture = light.at(image);
    if (picture.texel)
      remarks_.push_back(
          std::filesystem::path(scene.images[static_cast<std::size_t>(image)].label).filename().string() +
          ": is of one colour, and scene.gltf reads one texel of it");
    else
      bytes += image_totals(image).disk - picture.totals.disk;
  }
  if (bytes > 0)
    remarks_.push_back(
        std::to_string(bytes) +
        " bytes of kept PNG files that say nothing of their texels are left out: texts, profiles "
        "and the like, of which glTF takes no notice");
}

TextureTotals ScenePack::State::scene_totals(const std::vector<GltfForm>& of_forms, const SceneMaps& placed,
                                             const PackDecision& decision) {
  const SceneOutput of_scene = scene_output(*this, placed, of_forms, decision);
  TextureTotals out = of_scene.totals(decision);
  out.add(kept_totals(images_kept(scene, of_scene.gltf)));
  return out;
}

Others ScenePack::State::others_in(const std::vector<GltfForm>& of_forms) const {
  const bool plain_alone = of_forms == std::vector{GltfForm::metal_rough};
  return options.output.smallest_form && plain_alone ? Others::stay : Others::written;
}

// Whether what is written of the form is what was read, but for the rounding of the pair's codes.
bool ScenePack::State::is_exact(GltfForm form, const MapsOfOthers& maps_,
                                const PackDecision& decision) const {
  if (form != GltfForm::metal_rough)
    return (form == GltfForm::specular_ior || gloss != GlossForm::schueler) &&
           std::all_of(entries.begin(), entries.end(), [&](const Entry& entry) {
             return entry.exact || !scene.material_used[static_cast<std::size_t>(entry.material)];
           });
  const Others others = others_in({form});
  const SceneMaps& of_form = maps_[static_cast<std::size_t>(others)];
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const MaterialFate& fate = decision.left_out.fates[i];
    const int material = entries[i].material;
    if (!is_written(*this, material, others)) continue;
    const auto found = of_form.find(fate.owner);
    if (fate.texels ? found == of_form.end() || !found->second.exact
                    : !is_plain_metal_rough(scene.materials[static_cast<std::size_t>(material)]))
      return false;
  }
  return true;
}

SceneMaps ScenePack::State::placeable(const PackDecision& decision, Others others) {
  std::vector<int> materials;
  for (const Entry& entry : entries) materials.push_back(entry.material);
  SceneMaps out =
      scene_maps(scene, materials, inputs, decision, others, [&](int image) { return header(image); });
  for (auto& [owner, maps_] : out)
    for (std::optional<int>* image :
         {&maps_.base_color, &maps_.metal_rough, &maps_.occlusion, &maps_.normal, &maps_.emissive})
      if (*image) *image = stands_for[static_cast<std::size_t>(**image)];
  return out;
}

ScenePack::State::MapsOfOthers ScenePack::State::placeable(const PackDecision& decision) {
  return {placeable(decision, Others::written), placeable(decision, Others::stay)};
}

std::vector<GltfForm> ScenePack::State::forms_to_weigh(const MapsOfOthers& maps_,
                                                       const PackDecision& decision) const {
  if (!options.output.smallest_form) return options.output.forms;
  std::vector<GltfForm> out;
  for (const GltfForm form : all_forms)
    if (is_exact(form, maps_, decision)) out.push_back(form);
  // None is exact where a texture is stored with fewer texels: of these the pair is meant.
  if (out.empty()) out.push_back(GltfForm::specular_ior);
  return out;
}

SceneMaps ScenePack::State::placed(const MapsOfOthers& maps_, const std::vector<GltfForm>& of_forms,
                                   const PackDecision& decision, const TextureWeight& weight) {
  const Others others = others_in(of_forms);
  SceneMaps out = worthwhile(maps_[static_cast<std::size_t>(others)], of_forms, decision,
                             {others, weight, [&](int image) { return kept_totals(image); }});
  // Pages were judged one by one; a texture that stays for one of them stays for all.
  SceneMaps none = none_placed(out);
  const auto weighed = [&](const SceneMaps& of) { return weight(scene_totals(of_forms, of, decision)); };
  return weighed(none) < weighed(out) ? none : out;
}

void ScenePack::weigh_page(int page, const PagePixels& pixels, PackDecision& decision,
                           const WriteOptions& options) {
  State& s = *state_;
  const State::MapsOfOthers all = s.placeable(decision);
  for (const Others others : {Others::written, Others::stay}) {
    const auto i = static_cast<std::size_t>(others);
    const SceneMaps& maps = all[i];
    std::vector<std::string> read;
    for (const GltfForm form : s.forms_to_weigh(all, decision))
      if (s.others_in({form}) == others)
        for (const std::string& name : scene_output(s, maps, {form}, decision).gltf.images)
          read.push_back(name);
    if (read.empty()) continue;
    const MapPixels on_page = map_pixels(page, maps, s.inputs, decision, options.threads,
                                         [&](int image) { return s.decoded(image); });
    add_scene_picture_sizes({page, pixels, on_page, maps, decision, read, s.gloss}, options,
                            (*decision.sizes)[i]);
  }
}

double ScenePack::choose_pictures(const PackDecision& decision) {
  State& s = *state_;
  if (!s.writes_scene()) return 0;
  const State::MapsOfOthers maps = s.placeable(decision);
  const PackGoal goal = s.options.output.goal;
  const TextureWeight weight(goal,
                             goal == PackGoal::both ? s.input_totals(s.scene.image_used) : TextureTotals{});
  const std::vector<GltfForm> weighed = s.forms_to_weigh(maps, decision);
  s.costs.clear();
  const FormCost* best = nullptr;
  double least = 0;
  s.costs.reserve(all_forms.size());
  for (const GltfForm form : all_forms) {
    const SceneMaps on_pages = s.placed(maps, {form}, decision, weight);
    const TextureTotals totals = s.scene_totals({form}, on_pages, decision);
    FormCost& cost = s.costs.emplace_back(
        FormCost{form, totals.gpu, std::nullopt, s.is_exact(form, maps, decision), false});
    if (!has_form(weighed, form)) continue;
    if (decision.sizes) cost.disk = totals.disk;
    if (best == nullptr || weight(totals) < least) best = &cost, least = weight(totals);
  }
  s.forms = s.options.output.smallest_form ? std::vector{best->form} : s.options.output.forms;
  for (FormCost& each : s.costs) each.written = has_form(s.forms, each.form);
  s.maps = s.placed(maps, s.forms, decision, weight);
  s.output = scene_output(s, s.maps, s.forms, decision).gltf;
  return weight(s.scene_totals(s.forms, s.maps, decision));
}

std::uint64_t ScenePack::replaced_gpu_bytes() const {
  const GltfScene& scene = state_->scene;
  const std::vector<ImageRole> roles = image_roles(*scene.json, scene.path);
  std::vector<bool> replaced(roles.size());
  for (std::size_t i = 0; i < roles.size(); ++i) replaced[i] = roles[i].material && scene.image_used[i];
  return state_->input_totals(replaced).gpu;
}

bool ScenePack::writes_scene() const {
  return state_->writes_scene();
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
  for (std::string& name : write_scene_pictures(folder, in, options)) s.written.insert(std::move(name));
}

std::vector<std::string> ScenePack::write_scene(OutputFolder& folder, const AtlasLayout& layout) {
  State& s = *state_;
  if (!s.writes_scene()) return {};
  GltfOutput& out = s.output;
  out.taken.emplace(s.written.begin(), s.written.end());
  for (const AtlasPage& page : layout.pages)
    for (const auto& files : page.files) out.taken->insert(files.begin(), files.end());
  out.taken->insert({out.buffer_name, "scene.gltf", layout_file_name});
  std::map<std::string, const std::string*> texels;
  for (const int image : s.kept_light())
    if (const auto& texel = s.light.at(image).texel) texels.emplace(texel->name, &texel->file);
  for (const auto& [name, bytes] : texels) out.taken->insert(name);
  const WrittenGltf written = write_gltf(s.scene, out);
  std::vector<std::string> names(s.written.begin(), s.written.end());
  for (const auto& [name, bytes] : texels) {
    folder.write(name, *bytes);
    names.push_back(name);
  }
  for (const CopiedFile& copy : written.files) {
    FileBytes file;
    file.load(copy.from);
    BytesInMemory bytes(file.view());
    const auto light = s.light.empty() ? std::nullopt : texels_alone(bytes);
    folder.write(copy.name, light ? std::string_view(*light) : file.view());
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
