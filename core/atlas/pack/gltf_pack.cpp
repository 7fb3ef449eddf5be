// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/gltf_pack.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "core/atlas/pack/decision.h"
#include "core/atlas/pack/pack.h"
#include "core/atlas/pack/scene_facts.h"
#include "core/atlas/pack/scene_pictures.h"
#include "core/atlas/pack/table.h"
#include "core/atlas/sources/floats.h"
#include "core/base/error.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"
#include "core/scene/texel_scale.h"
#include "core/scene/uv_use.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// A box more takes a gutter and a place; that is worth about so many texels.
constexpr std::size_t island_cost = 256;
constexpr int island_margin = 0;  // footprints hold what bilinear filtering reads; gutters serve the mips
constexpr int sampled_gutter_levels = 4;
// Surfaces are seen at an angle, and isotropic filters go by the longer side of a pixel's footprint: so many
// levels more are an angle of 83 degrees (a cosine of 1/8).
constexpr int oblique_levels = 3;

PixelBox box_of(const std::array<int, 4>& box) {
  return {box[0], box[1], box[2], box[3]};
}
// The names of a scene's files, each once, in the order in which they were first asked for.
struct ImageList {
  std::vector<std::string> names;
  std::map<std::string, int> numbers;
  int number_of(const std::string& file) {
    const auto [found, fresh] = numbers.try_emplace(file, static_cast<int>(names.size()));
    if (fresh) names.push_back(file);
    return found->second;
  }
};

}  // namespace

struct ScenePack::State {
  struct Entry {
    int material = -1;  // in the document
    std::optional<TexelUse> use;
    std::shared_ptr<const MaterialPair> pair;
    bool tiles = false;  // on a page of its own
  };

  GltfScene scene;
  std::optional<MaterialUses> uses;  // of the scene, once that is read
  const PackOptions& options;
  GlossForm gloss;
  std::vector<Entry> entries;  // beside the inputs
  PackInputs inputs;
  std::vector<std::string> remarks;
  std::map<int, Image8> pictures;
  std::map<int, int> pictures_awaited;  // by image: lookups in learn() that are still to come
  std::mutex pictures_lock;
  std::set<std::string> written;

  explicit State(const PackOptions& options_)
      : options(options_), gloss(options_.input.pictures.gloss.value_or(GlossForm::one_minus_roughness)) {}

  // The bytes of an image, inside the document or from its file.
  std::string_view bytes_of(const PictureFile& image, FileBytes& file) const {
    if (image.path.empty()) return image.bytes;
    file.load(image.path);
    return file.view();
  }

  FloatPair floats_of(int material) const {
    std::map<int, Image> images;
    const SceneImages<float> floats = [&](int index) -> const Image& {
      const auto [found, fresh] = images.try_emplace(index);
      if (!fresh) return found->second;
      const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
      FileBytes file;
      return found->second =
                 fractions(load_picture(bytes_of(image, file), image.label, options.input.pictures.door));
    };
    std::size_t clamped = 0;
    return scene_material_pair(scene.materials[static_cast<std::size_t>(material)], floats, gloss,
                               options.leave_out.keep.contains("alpha"), clamped);
  }

  const Image8& picture(int index) {
    const std::lock_guard lock(pictures_lock);
    auto [found, fresh] = pictures.try_emplace(index);
    if (!fresh) return found->second;
    const PictureFile& image = scene.images[static_cast<std::size_t>(index)];
    FileBytes file;
    try {
      return found->second = codes_of(
                 load_picture(bytes_of(image, file), image.label, options.input.pictures.door), false);
    } catch (...) {
      pictures.erase(index);
      throw;
    }
  }

  void await_pictures(const GltfMaterial& m) {
    for (const GltfTexture* texture : replaced_textures(m)) ++pictures_awaited[texture->image];
  }

  // A picture that no other material asks for is given back: all of a scene's at once would be most of the
  // memory.
  void give_back_pictures(const GltfMaterial& m) {
    const std::lock_guard lock(pictures_lock);
    for (const GltfTexture* texture : replaced_textures(m))
      if (--pictures_awaited[texture->image] == 0) pictures.erase(texture->image);
  }

  std::string name_of(const GltfMaterial& m, std::set<std::string>& names) const {
    std::string name = m.name.empty() ? "material" + std::to_string(m.index) : m.name;
    if (!names.insert(name).second) name += "#" + std::to_string(m.index);
    names.insert(name);
    return name;
  }

  void add_material(const GltfMaterial& m, std::set<std::string>& names) {
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
    entries.push_back({m.index, {}, {}, false});
  }

  // Size, texels and their use, for one material.
  void learn(std::size_t i) {
    PackInput& in = inputs.materials[i];
    Entry& entry = entries[i];
    const GltfMaterial& m = scene.materials[static_cast<std::size_t>(entry.material)];
    const SceneImages<std::uint8_t> images = [this](int index) -> const Image8& { return picture(index); };
    std::size_t clamped = 0;
    auto pair = std::make_shared<MaterialPair>(
        scene_material_pair(m, images, gloss, options.leave_out.keep.contains("alpha"), clamped));
    give_back_pictures(m);
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
    if (writes_floats(options.output.write)) {
      in.convert_floats = [this, material = entry.material] { return floats_of(material); };
      look_at(floats_of(entry.material), used, in.facts.opaque, in.facts);
    }
    if (clamped > 0)
      clamped_percent[i] =
          100 * static_cast<double>(clamped) / static_cast<double>(pair->diffuse_alpha.pixel_count());
    entry.pair = std::move(pair);
    in.convert = [shared = entry.pair](std::vector<std::string>&) { return *shared; };
  }

  // What the cameras, and the density that was asked for, leave of the texture's resolution and mips.
  void scale_of(PackInput& in, const Entry& entry, const GltfTexture& lead) {
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
  void normals_of(PackInput& in, const GltfMaterial& m, const Entry& entry, const GltfTexture& lead) {
    if (!m.normal_texture) return;
    const GltfTexture& map = *m.normal_texture;
    const auto place = normals_on_pair(map, lead, *entry.use);
    if (!place) {
      remarks.push_back(in.name + ": its normal map is looked up elsewhere and does not widen its gloss");
      return;
    }
    in.load_normals = [this, image = map.image, scale = m.normal_scale, width = in.width, height = in.height,
                       at = *place] { return scaled_normals(picture(image), scale, width, height, at); };
  }

  void use_of(PackInput& in, Entry& entry, const GltfTexture& lead) {
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

  void set_images(const MaterialFate& fate, const AtlasPage& files, int page, ImageList& images,
                  AtlasMaterial& to) const;
  AtlasMaterial atlas_material(std::size_t i, const AtlasLayout& layout, const PackDecision& decision,
                               ImageList& images) const;

  std::map<std::size_t, double> clamped_percent;  // of the texels, by material

  // ---- output

  bool writes_scene() const {
    const auto& formats = options.output.write.formats;
    return std::find(formats.begin(), formats.end(), "png") != formats.end();
  }

  bool has_form(GltfForm form) const {
    return std::find(options.output.forms.begin(), options.output.forms.end(), form) !=
           options.output.forms.end();
  }
};

ScenePack::ScenePack(const std::string& path, const PackOptions& options)
    : state_(std::make_unique<State>(options)) {
  State& s = *state_;
  s.scene = read_gltf(path, options.input.gltf);
  s.uses.emplace(s.scene);
  s.inputs.gloss = s.gloss;
  if (s.gloss == GlossForm::roughness)
    throw Error::at("--gloss", "roughness", "schueler or one_minus_roughness for a glTF scene");
  if (s.gloss == GlossForm::schueler && s.has_form(GltfForm::specular_glossiness))
    throw Error::at("--gltf-form", "specular-glossiness, whose gloss is 1 - roughness",
                    "--gloss one_minus_roughness");
  std::set<std::string> names;
  for (const GltfMaterial& m : s.scene.materials) s.add_material(m, names);
  parallel_chunks(s.inputs.materials.size(), options.run.threads, 1,
                  [&](std::size_t begin, std::size_t, unsigned) { s.learn(begin); });
  for (const auto& [i, share] : s.clamped_percent)
    s.remarks.push_back(s.inputs.materials[i].name + ": gloss of " + number(share, 3) +
                        " % of the texels lies outside of what the form " + std::string(name(s.gloss)) +
                        " can hold and was brought back to its ends");
  ContentHash hash;
  hash.add(*s.scene.json);
  for (const std::string& buffer : *s.scene.buffers) hash.add(buffer);
  s.inputs.settings = hash.hex();
}

ScenePack::~ScenePack() = default;

PackInputs ScenePack::inputs() {
  return state_->inputs;
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
  if (!state_->writes_scene())
    remarks.push_back("no scene.gltf was written: its pictures are PNG, which --format does not name");
}

void ScenePack::write_page(OutputFolder& folder, int page, const PagePixels& pixels,
                           const WriteOptions& options) {
  State& s = *state_;
  if (!s.writes_scene()) return;
  for (std::string& name : write_scene_pictures(folder, page, pixels, s.options.output.forms, s.gloss,
                                                {options.png_level, options.threads}))
    s.written.insert(std::move(name));
}

// Which pictures of its page a material reads.
void ScenePack::State::set_images(const MaterialFate& fate, const AtlasPage& files, int page,
                                  ImageList& images, AtlasMaterial& to) const {
  const auto varies = [&](std::size_t first, std::size_t count) {
    for (std::size_t c = first; c < first + count; ++c)
      if (!fate.constant[c]) return true;
    return false;
  };
  const bool a = varies(0, 4) && !files.files[0].empty();
  const bool f0 = varies(4, 3) && !files.files[1].empty(), smooth = varies(7, 1) && !files.files[1].empty();
  if (a) to.diffuse_alpha_image = images.number_of(page_file(page, Texture::diffuse_alpha, "png"));
  const bool sg = has_form(GltfForm::specular_glossiness) ? f0 || smooth : f0;
  if (sg) to.specular_gloss_image = images.number_of(page_file(page, Texture::specular_gloss, "png"));
  if (smooth && has_form(GltfForm::specular_ior))
    to.roughness_image = images.number_of(scene_picture(page, "roughness"));
  if (has_form(GltfForm::metal_rough)) {
    to.base_color_image = images.number_of(scene_picture(page, "base_color"));
    to.metallic_roughness_image = images.number_of(scene_picture(page, "metal_rough"));
  }
}

AtlasMaterial ScenePack::State::atlas_material(std::size_t i, const AtlasLayout& layout,
                                               const PackDecision& decision, ImageList& images) const {
  const Entry& entry = entries[i];
  const PackInput& in = inputs.materials[i];
  const GltfMaterial& m = scene.materials[static_cast<std::size_t>(entry.material)];
  const MaterialFate& fate = decision.left_out().fates[i];
  AtlasMaterial to;
  to.material = entry.material;
  const GltfTexture* const lead = leading_texture(m);
  if (lead != nullptr) to.uv_set = lead->uv_set;
  scene_constants(in.facts, m, gloss, to);
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
  set_images(fate, layout.pages[static_cast<std::size_t>(on.page)], on.page, images, to);
  if (on.own_page && lead != nullptr) to.sampler = lead->sampler;
  return to;
}

std::vector<std::string> ScenePack::write_scene(OutputFolder& folder, const AtlasLayout& layout,
                                                const PackDecision& decision) {
  State& s = *state_;
  if (!s.writes_scene()) return {};
  GltfOutput out;
  out.forms = s.options.output.forms;
  ImageList images;
  for (std::size_t i = 0; i < s.entries.size(); ++i)
    if (s.scene.material_used[static_cast<std::size_t>(s.entries[i].material)])
      out.materials.push_back(s.atlas_material(i, layout, decision, images));
  out.images = std::move(images.names);
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
