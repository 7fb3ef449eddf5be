// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/scene/gltf_pack.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/atlas/pack/scene/scene_facts.h"
#include "core/atlas/pack/scene/scene_state.h"
#include "core/atlas/sources/floats.h"
#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/image/files/png_keep.h"
#include "core/image/load.h"
#include "core/image/texture_bytes.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/image_roles.h"
#include "core/scene/texel_scale.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// One more box costs about so many texels, for its gutter and for the waste around it.
constexpr std::size_t island_cost = 256;
constexpr int island_margin = 0;  // footprints hold what bilinear filtering reads; gutters are for the mips
constexpr int sampled_gutter_levels = 4;
// Surfaces are seen at an angle, and isotropic filters choose the level by the longer side of a pixel's
// footprint. So many more levels are for angles up to 83 degrees (a cosine of 1/8).
constexpr int oblique_levels = 3;

PixelBox box_of(const std::array<int, 4>& box) {
  return {box[0], box[1], box[2], box[3]};
}
}  // namespace

ScenePack::State::State(const PackOptions& options_)
    : options(options_),
      gloss(options_.input.pictures.gloss.value_or(GlossForm::one_minus_roughness)),
      forms(options_.output.forms) {}

std::string_view ScenePack::State::bytes_of(const PictureFile& image, FileBytes& file) const {
  if (image.path.empty()) return image.bytes;
  file.load(image.path);
  return file.view();
}

Image8 ScenePack::State::decoded(int index) const {
  const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
  FileBytes file;
  return codes_of(load_picture(bytes_of(image, file), image.label, options.input.pictures.door), false);
}

const PictureHeader& ScenePack::State::header(int index) {
  const auto [found, fresh] = headers.try_emplace(index);
  const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
  const PictureDoor& door = options.input.pictures.door;
  if (fresh)
    found->second =
        image.path.empty() ? open_picture(image, door)->header() : picture_header(image.path, door);
  return found->second;
}

FloatPair ScenePack::State::floats_of(int material) const {
  std::map<int, Image> images;
  const SceneImages<float> floats = [&](int index) -> const Image& {
    const auto [found, fresh] = images.try_emplace(index);
    if (!fresh) return found->second;
    const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
    FileBytes file;
    return found->second =
               fractions(load_picture(bytes_of(image, file), image.label, options.input.pictures.door));
  };
  std::size_t outside = 0;
  return scene_material_pair(scene.materials[static_cast<std::size_t>(material)], floats, gloss,
                             options.leave_out.keep.contains("alpha"), outside);
}

const Image8& ScenePack::State::picture(int index) {
  const std::lock_guard lock(pictures_lock);
  auto [found, fresh] = pictures.try_emplace(index);
  if (!fresh) return found->second;
  try {
    return found->second = decoded(index);
  } catch (...) {
    pictures.erase(index);
    throw;
  }
}

void ScenePack::State::await_pictures(const GltfMaterial& m) {
  for (const GltfTexture* texture : replaced_textures(m)) ++pictures_awaited[texture->image];
}

// Frees the pictures that no other material asks for: all pictures of a scene at once would take most of
// the memory.
void ScenePack::State::give_back_pictures(const GltfMaterial& m) {
  const std::lock_guard lock(pictures_lock);
  for (const GltfTexture* texture : replaced_textures(m))
    if (--pictures_awaited[texture->image] == 0) pictures.erase(texture->image);
}

std::string ScenePack::State::name_of(const GltfMaterial& m, std::set<std::string>& names) const {
  std::string name = m.name.empty() ? "material" + std::to_string(m.index) : m.name;
  if (!names.insert(name).second) name += "#" + std::to_string(m.index);
  names.insert(name);
  return name;
}

void ScenePack::State::add_material(const GltfMaterial& m, std::set<std::string>& names) {
  const bool used = scene.material_used[static_cast<std::size_t>(m.index)];
  if (used && !textures_agree(m)) {
    remarks.push_back((m.name.empty() ? "material " + std::to_string(m.index) : m.name) +
                      ": its textures are looked up at different places; it stays as it is");
    return;
  }
  PackInput in;
  in.name = name_of(m, names);
  in.document_index = m.index;
  in.alpha_mode = m.alpha_mode;
  in.alpha_cutoff = m.alpha_cutoff;
  in.streamed = false;
  in.facts.name = in.name;
  in.facts.reached = used;
  in.facts.opaque = m.alpha_mode == AlphaMode::opaque && !options.leave_out.keep.contains("alpha");
  in.facts.source = std::to_string(m.index);
  await_pictures(m);
  inputs.materials.push_back(std::move(in));
  entries.emplace_back().material = m.index;
}

// Finds the size, the texels and the used texels of one material.
void ScenePack::State::learn(std::size_t i) {
  PackInput& in = inputs.materials[i];
  Entry& entry = entries[i];
  const GltfMaterial& m = scene.materials[static_cast<std::size_t>(entry.material)];
  const SceneImages<std::uint8_t> images = [this](int index) -> const Image8& { return picture(index); };
  std::size_t outside = 0;
  auto pair = std::make_shared<MaterialPair>(
      scene_material_pair(m, images, gloss, options.leave_out.keep.contains("alpha"), outside));
  if (options.check.scene)
    entry.metallic = scene_metallic(m, images, pair->diffuse_alpha.width, pair->diffuse_alpha.height);
  in.width = in.facts.width = pair->diffuse_alpha.width;
  in.height = in.facts.height = pair->diffuse_alpha.height;
  in.facts.crop = {0, 0, in.width, in.height};
  const GltfTexture* lead = leading_texture(m);
  if (in.facts.reached && lead != nullptr) {
    use_of(in, entry, *lead);
    scale_of(in, entry, *lead);
    normals_of(in, m, entry, *lead);
  }
  const bool masked =
      entry.use && entry.use->touched > 0 && entry.use->mask.size() == pair->diffuse_alpha.pixel_count();
  const std::uint8_t* const used = masked ? entry.use->mask.data() : nullptr;
  look_at(*pair, used, in.facts.opaque, in.facts);
  if (in.facts.reached) tell_conversion(in, m, entry, conversion_cost(m, images, *pair, gloss, used));
  give_back_pictures(m);
  if (writes_floats(options.output.write)) {
    in.convert_floats = [this, material = entry.material] { return floats_of(material); };
    look_at(floats_of(entry.material), used, in.facts.opaque, in.facts);
  }
  if (outside > 0)
    entry.clamped =
        100 * static_cast<double>(outside) / static_cast<double>(pair->diffuse_alpha.pixel_count());
  entry.pair = std::move(pair);
  in.convert = [shared = entry.pair](std::vector<std::string>&) { return *shared; };
}

void ScenePack::State::tell_conversion(const PackInput& in, const GltfMaterial& m, Entry& entry,
                                       const ConversionCost& cost) {
  entry.exact = cost.is_exact();
  if (const auto told = sentence_of(cost))
    entry.remarks.push_back(in.name + ": " + *told +
                            (is_plain_metal_rough(m) ? "; the form metal-rough keeps its own textures" : ""));
}

// Finds which resolution and which mips the cameras can show, and the density that was asked for needs.
void ScenePack::State::scale_of(PackInput& in, const Entry& entry, const GltfTexture& lead) {
  in.facts.levels = lead.sampler.mipmaps ? 0 : 1;
  if (options.leave_out.texel_density == 0 && options.leave_out.view_height == 0) return;
  const TexelScale scale =
      texel_scale(*uses, entry.material, lead, in.width, in.height, options.leave_out.view_height);
  constexpr double rounding = 1e-6;
  std::optional<double> halvings;
  if (options.leave_out.texel_density > 0 && scale.least_density > 0)
    halvings = std::log2(scale.least_density / options.leave_out.texel_density);
  if (scale.seen && std::isfinite(scale.least_level))
    halvings = std::min(halvings.value_or(scale.least_level), scale.least_level);
  if (options.leave_out.view_height == 0 || scale.seen)
    in.facts.unseen = std::clamp(static_cast<int>(std::floor(halvings.value_or(0) + rounding)), 0, 15);
  if (scale.seen && lead.sampler.mipmaps && std::isfinite(scale.most_level))
    in.facts.levels =
        1 + oblique_levels + std::clamp(static_cast<int>(std::ceil(scale.most_level - rounding)), 0, 15);
}

// The normal map as it lies on the pair, at the pair's size.
void ScenePack::State::normals_of(PackInput& in, const GltfMaterial& m, Entry& entry,
                                  const GltfTexture& lead) {
  if (!m.normal_texture) return;
  const GltfTexture& map = *m.normal_texture;
  const auto place = normals_on_pair(map, lead, *entry.use);
  if (!place) {
    entry.remarks.push_back(in.name + ": its normal map is looked up elsewhere and does not widen its gloss");
    return;
  }
  in.load_normals = [this, image = map.image, scale = m.normal_scale, width = in.width, height = in.height,
                     at = *place] { return scaled_normals(picture(image), scale, width, height, at); };
}

void ScenePack::State::use_of(PackInput& in, Entry& entry, const GltfTexture& lead) {
  entry.use = texel_use(*uses, entry.material, lead, in.width, in.height);
  const TexelUse& use = *entry.use;
  in.wrap = {lead.sampler.wrap_u, lead.sampler.wrap_v};
  if (use.touched == 0) return;
  const bool by_islands =
      options.leave_out.islands && !options.leave_out.keep.contains("islands") && use.foldable;
  if (use.tiles && !by_islands) {
    // The whole period: only a page of its own can repeat it.
    in.own_page = entry.tiles = in.facts.tiles = true;
    return;
  }
  in.facts.crop = box_of(use.box);
  if (!by_islands) return;
  for (const Island& island : islands(use, island_margin, island_cost))
    in.facts.islands.push_back({island.x, island.y, island.width, island.height});
}

// Which pictures can do with less than their files. Only forms of PNG that are read row by row are looked at
// for their colours: of others the first texel would take the whole picture.
void ScenePack::State::find_light_pictures() {
  if (!writes_scene() || !options.leave_out.leaves("files")) return;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const auto index = static_cast<int>(i);
    if (!scene.image_used[i] || stands_for[i] != index) continue;
    const PictureFile& image = scene.images[i];
    const PictureHeader& from = header(index);
    const TextureTotals whole = image_totals(index);
    LightPicture found{std::nullopt, whole};
    if (!image.path.empty()) {
      SteadyFile file(image.path, largest_picture_bytes);
      found.totals.disk = size_of_texels_alone(file).value_or(whole.disk);
    }
    if (from.strips && from.bits == 8) {
      auto texel = one_texel_of(*open_picture(image, options.input.pictures.door));
      if (texel && texel->file.size() <= found.totals.disk)
        found = {texel, {1, texel->file.size(), texture_bytes(texel->header, true)}};
    }
    if (found.totals != whole) light.emplace(index, std::move(found));
  }
}

ScenePack::ScenePack(const std::string& path, const PackOptions& options)
    : state_(std::make_unique<State>(options)) {
  State& s = *state_;
  s.scene = read_gltf(path, options.input.gltf);
  s.stands_for = first_of_same_images(s.scene);
  s.uses.emplace(s.scene);
  s.inputs.gloss = s.gloss;
  if (s.gloss == GlossForm::roughness)
    throw Error::at(setting("gloss-channel"), "roughness",
                    "schueler or one_minus_roughness for a glTF scene");
  if (s.gloss == GlossForm::schueler && has_form(s.forms, GltfForm::specular_glossiness))
    throw Error::at(setting("gltf-form"), "specular-glossiness, whose gloss is 1 - roughness",
                    setting("gloss-channel") + " one_minus_roughness");
  std::set<std::string> names;
  for (const GltfMaterial& m : s.scene.materials) s.add_material(m, names);
  parallel_chunks(s.inputs.materials.size(), options.run.threads, 1,
                  [&](std::size_t begin, std::size_t, unsigned) { s.learn(begin); });
  s.find_light_pictures();
  for (std::size_t i = 0; i < s.entries.size(); ++i) {
    const State::Entry& entry = s.entries[i];
    s.remarks.insert(s.remarks.end(), entry.remarks.begin(), entry.remarks.end());
    if (entry.clamped > 0)
      s.remarks.push_back(s.inputs.materials[i].name + ": gloss of " + number(entry.clamped, 3) +
                          " % of the texels lies outside of what the form " + std::string(name(s.gloss)) +
                          " can hold and was brought back to its ends");
  }
  ContentHash hash;
  hash.add(*s.scene.json);
  for (const std::string& buffer : *s.scene.buffers) hash.add(buffer);
  s.inputs.settings = hash.hex();
}

ScenePack::~ScenePack() = default;

const GltfScene& ScenePack::scene() const {
  return state_->scene;
}

PackInputs ScenePack::inputs() {
  return state_->inputs;
}

PackedScene ScenePack::packed() const {
  PackedScene out;
  out.uses = &*state_->uses;
  for (std::size_t i = 0; i < state_->entries.size(); ++i) {
    const State::Entry& entry = state_->entries[i];
    out.materials.emplace(entry.material,
                          PackedScene::Material{state_->inputs.materials[i].name, entry.pair.get(),
                                                entry.use ? &*entry.use : nullptr, &entry.metallic});
  }
  return out;
}

int ScenePack::sampled_levels(int levels) const {
  bool mips = false;
  for (const auto& entry : state_->entries) {
    const GltfMaterial& m = state_->scene.materials[static_cast<std::size_t>(entry.material)];
    const GltfTexture* lead = leading_texture(m);
    mips = mips || (lead != nullptr && lead->sampler.mipmaps);
  }
  if (!mips) return 1;
  return levels == 0 ? 0 : std::max(levels, sampled_gutter_levels);
}

void ScenePack::add_files(std::vector<std::string>& files) const {
  for (std::size_t i = 0; i < state_->scene.images.size(); ++i)
    if (const std::string& path = state_->scene.images[i].path; !path.empty() && fs::exists(path))
      files.push_back(path);
}

void ScenePack::add_remarks(std::vector<std::string>& remarks) const {
  remarks.insert(remarks.end(), state_->remarks.begin(), state_->remarks.end());
  state_->tell_light_pictures(remarks);
  if (!state_->costs.empty() && state_->others_in(state_->forms) == Others::stay)
    for (const State::Entry& entry : state_->entries) {
      const auto index = static_cast<std::size_t>(entry.material);
      const GltfMaterial& m = state_->scene.materials[index];
      if (state_->scene.material_used[index] && !is_plain_metal_rough(m))
        remarks.push_back((m.name.empty() ? "material " + std::to_string(m.index) : m.name) +
                          ": is not of plain metal-rough form and stays as it is in scene.gltf");
    }
  if (!state_->writes_scene())
    remarks.push_back("no scene.gltf was written: its pictures are PNG, which " + setting("textures") +
                      " does not name");
}

}  // namespace etak
