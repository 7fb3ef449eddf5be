// SPDX-License-Identifier: Apache-2.0
// What each form of a scene would take, the choice among them, and the files that the packer writes.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "core/atlas/pack/scene/scene_document.h"
#include "core/atlas/pack/scene/scene_pictures.h"
#include "core/atlas/pack/table.h"
#include "core/base/files/steady_file.h"
#include "core/image/files/png_keep.h"
#include "core/image/texture_bytes.h"
#include "core/scene/image_roles.h"

namespace etak {
namespace {

constexpr std::array all_forms{GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough};

}  // namespace

bool ScenePack::State::writes_scene() const {
  // glTF's materials name no part of a texture for one channel: one page is for programs that read layout.json.
  if (options.output.goal == PackGoal::one_page) return false;
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
