// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/gltf_pack.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "core/atlas/sources/floats.h"
#include "core/base/error.h"
#include "core/base/files/paths.h"
#include "core/base/files/steady_file.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/image/files/png_keep.h"
#include "core/image/load.h"
#include "core/image/same_pictures.h"
#include "core/image/texture_bytes.h"
#include "core/math/functions.h"
#include "core/pack/pack.h"
#include "core/pack/scene/scene_facts.h"
#include "core/pack/scene/scene_maps.h"
#include "core/scene/conversion_cost.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/image_roles.h"
#include "core/scene/texel_scale.h"

namespace etak {
namespace {

// One more box costs about so many texels, for its gutter and for the waste around it.
constexpr std::size_t island_cost = 256;
// An outline costs its gutter alone: others use the room around it.
constexpr std::size_t outline_cost = 64;
constexpr int island_margin = 0;  // footprints hold what bilinear filtering reads; gutters are for the mips
constexpr int sampled_gutter_levels = 4;
// Surfaces are seen at an angle, and isotropic filters choose the level by the longer side of a pixel's
// footprint. So many more levels are for angles up to 83 degrees (a cosine of 1/8).
constexpr int oblique_levels = 3;

PixelBox box_of(const std::array<int, 4>& box) {
  return {box[0], box[1], box[2], box[3]};
}

// Decoded pictures of a scene, which are kept until all that asked for them have given them back: all pictures of a
// scene at once would take most of the memory.
class DecodedPictures {
 public:
  explicit DecodedPictures(const SceneRead& scene) : scene_(scene) {}

  const Image8& operator()(int image) {
    const std::lock_guard guard(lock_);
    if (const auto found = pictures_.find(image); found != pictures_.end()) return found->second;
    return pictures_.emplace(image, codes_of(scene_.decoded(image), false)).first->second;
  }

  void await(const GltfMaterial& m) {
    for (const GltfTexture* texture : replaced_textures(m)) ++awaited_[texture->image];
  }
  void give_back(const GltfMaterial& m) {
    const std::lock_guard guard(lock_);
    for (const GltfTexture* texture : replaced_textures(m))
      if (--awaited_[texture->image] == 0) pictures_.erase(texture->image);
  }

 private:
  const SceneRead& scene_;
  std::mutex lock_;
  std::map<int, Image8> pictures_;
  std::map<int, int> awaited_;  // by image: look-ups that are still to come
};

FloatPair floats_of(const SceneRead& read, const GltfMaterial& m) {
  std::map<int, Image> images;
  const SceneImages<float> floats = [&](int image) -> const Image& {
    const auto [found, fresh] = images.try_emplace(image);
    return fresh ? found->second = fractions(read.decoded(image)) : found->second;
  };
  std::size_t outside = 0;
  return scene_material_pair(m, floats, read.gloss, read.options.leave_out.keep.contains("alpha"), outside);
}

std::string name_of(const GltfMaterial& m, std::set<std::string>& names) {
  std::string name = SceneRead::label(m, "");
  if (!names.insert(name).second) name += "#" + std::to_string(m.index);
  names.insert(name);
  return name;
}

// Why a material is not packed; null for one that is.
const char* why_it_stays(const SceneRead& read, const GltfMaterial& m, bool used) {
  if (!used)
    return read.scene.material_written[static_cast<std::size_t>(m.index)] ? "is reached by other scenes alone"
                                                                          : nullptr;
  if (!textures_agree(m)) return "its textures are looked up at different places";
  const GltfTexture* const lead = leading_texture(m);
  const bool is_morphed =
      lead != nullptr && std::ranges::any_of(read.uses->of(m.index), [&](const GltfUse* use) {
        return use->morphed_uv_sets.contains(lead->uv_set);
      });
  return is_morphed ? "morph targets move its UVs" : nullptr;
}

void add_material(const GltfMaterial& m, std::set<std::string>& names, SceneRead& read) {
  const bool used = read.scene.material_used[static_cast<std::size_t>(m.index)];
  if (const char* why = why_it_stays(read, m, used)) {
    read.remarks.push_back(SceneRead::label(m, " ") + ": " + why + "; it stays as it is");
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
  in.facts.opaque = m.alpha_mode == AlphaMode::opaque && !read.options.leave_out.keep.contains("alpha");
  in.facts.source = std::to_string(m.index);
  read.inputs.materials.push_back(std::move(in));
  read.entries.emplace_back().material = m.index;
}

using Decoded = std::shared_ptr<DecodedPictures>;

void tell_conversion(const PackInput& in, const GltfMaterial& m, SceneRead::Entry& entry,
                     const ConversionCost& cost) {
  entry.exact = cost.is_exact();
  if (const auto told = sentence_of(cost))
    entry.remarks.push_back(in.name + ": " + *told +
                            (is_plain_metal_rough(m) ? "; the form metal-rough keeps its own textures" : ""));
}

// Finds which resolution and which mips the cameras can show, and the density that was asked for needs.
void scale_of(const SceneRead& read, PackInput& in, const SceneRead::Entry& entry, const GltfTexture& lead) {
  const PackLeaveOutOptions& asked = read.options.leave_out;
  in.facts.levels = lead.sampler.mipmaps ? 0 : 1;
  if (asked.texel_density == 0 && asked.view_height == 0) return;
  const TexelScale scale =
      texel_scale(*read.uses, entry.material, lead, in.width, in.height, asked.view_height);
  constexpr double rounding = 1e-6;
  std::optional<double> halvings;
  if (asked.texel_density > 0 && scale.least_density > 0)
    halvings = math::log2(scale.least_density / asked.texel_density);
  if (scale.seen && std::isfinite(scale.least_level))
    halvings = std::min(halvings.value_or(scale.least_level), scale.least_level);
  if (asked.view_height == 0 || scale.seen)
    in.facts.unseen = std::clamp(static_cast<int>(std::floor(halvings.value_or(0) + rounding)), 0, 15);
  if (scale.seen && lead.sampler.mipmaps && std::isfinite(scale.most_level))
    in.facts.levels =
        1 + oblique_levels + std::clamp(static_cast<int>(std::ceil(scale.most_level - rounding)), 0, 15);
}

// The normal map as it lies on the pair, at the pair's size.
void normals_of(const Decoded& pictures, PackInput& in, const GltfMaterial& m, SceneRead::Entry& entry,
                const GltfTexture& lead) {
  if (!m.normal_texture) return;
  const GltfTexture& map = *m.normal_texture;
  const auto place = normals_on_pair(map, lead, *entry.use);
  if (!place) {
    entry.remarks.push_back(in.name + ": its normal map is looked up elsewhere and does not widen its gloss");
    return;
  }
  in.load_normals = [pictures, image = map.image, scale = m.normal_scale, width = in.width,
                     height = in.height,
                     at = *place] { return scaled_normals((*pictures)(image), scale, width, height, at); };
}

void use_of(const SceneRead& read, PackInput& in, SceneRead::Entry& entry, const GltfTexture& lead) {
  entry.use = texel_use(*read.uses, entry.material, lead, in.width, in.height);
  const TexelUse& use = *entry.use;
  in.wrap = {lead.sampler.wrap_u, lead.sampler.wrap_v};
  if (use.touched == 0) return;
  const bool by_islands =
      read.options.leave_out.islands && !read.options.leave_out.keep.contains("islands") && use.foldable;
  if (use.tiles && !by_islands) {
    // The whole period: only a page of its own can repeat it.
    in.own_page = entry.tiles = in.facts.tiles = true;
    return;
  }
  in.facts.crop = box_of(use.box);
  if (!by_islands) return;
  for (const Island& island : islands(use, island_margin, island_cost))
    in.facts.islands.push_back({island.x, island.y, island.width, island.height});
  for (Outline& outline : outlines(use, outline_cost)) {
    const Island& box = outline.box;
    in.facts.outlines.push_back({{box.x, box.y, box.width, box.height}, std::move(outline.texels)});
  }
}

// Finds the size, the texels and the used texels of one material.
void learn(SceneRead& read, std::size_t i, const Decoded& pictures) {
  PackInput& in = read.inputs.materials[i];
  SceneRead::Entry& entry = read.entries[i];
  const GltfMaterial& m = read.material(entry);
  const PackOptions& options = read.options;
  const SceneImages<std::uint8_t> images = [&](int image) -> const Image8& { return (*pictures)(image); };
  std::size_t outside = 0;
  auto pair = std::make_shared<MaterialPair>(
      scene_material_pair(m, images, read.gloss, options.leave_out.keep.contains("alpha"), outside));
  if (options.check.scene)
    entry.metallic = scene_metallic(m, images, pair->diffuse_alpha.width, pair->diffuse_alpha.height);
  in.width = in.facts.width = pair->diffuse_alpha.width;
  in.height = in.facts.height = pair->diffuse_alpha.height;
  in.facts.crop = {0, 0, in.width, in.height};
  const GltfTexture* lead = leading_texture(m);
  if (in.facts.reached && lead != nullptr) {
    use_of(read, in, entry, *lead);
    scale_of(read, in, entry, *lead);
    normals_of(pictures, in, m, entry, *lead);
  }
  const bool masked =
      entry.use && entry.use->touched > 0 && entry.use->mask.size() == pair->diffuse_alpha.pixel_count();
  const std::vector<std::uint8_t> read_texels =
      masked ? texels_read(*entry.use, lead->sampler) : std::vector<std::uint8_t>();
  const std::uint8_t* const used = masked ? read_texels.data() : nullptr;
  look_at(*pair, used, in.facts.opaque, in.facts);
  if (is_plain_metal_rough(m) && in.facts.range.varying() == 0)
    entry.own = own_metal_rough(m, images, pair->diffuse_alpha, used);
  if (in.facts.reached) {
    VertexColors colors;
    for (const GltfUse* use : read.uses->of(entry.material)) colors.add(use->colors);
    tell_conversion(in, m, entry, conversion_cost(m, images, *pair, read.gloss, used, colors));
  }
  pictures->give_back(m);
  if (writes_floats(options.output.write)) {
    in.convert_floats = [&read, &m] { return floats_of(read, m); };
    look_at(floats_of(read, m), used, in.facts.opaque, in.facts);
  }
  if (outside > 0)
    entry.clamped =
        100 * static_cast<double>(outside) / static_cast<double>(pair->diffuse_alpha.pixel_count());
  entry.pair = std::move(pair);
  in.convert = [shared = entry.pair](std::vector<std::string>&) { return *shared; };
}

// Finds the pictures that can do with less than their files. Only forms of PNG that are read row by row are looked at
// for their colours: of others the first texel would take the whole picture.
void find_light_pictures(SceneRead& read) {
  const GltfScene& scene = read.scene;
  if (!read.writes_scene() || !read.options.leave_out.leaves("files")) return;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const auto index = static_cast<int>(i);
    if (!scene.image_used[i] || read.stands_for[i] != index) continue;
    const PictureFile& image = scene.images[i];
    const PictureHeader& from = read.header(index);
    const TextureTotals whole = read.image_totals(index);
    SceneRead::LightPicture found{std::nullopt, whole};
    if (!image.path.empty()) {
      SteadyFile file(image.path, largest_picture_bytes);
      found.totals.disk = size_of_texels_alone(file).value_or(whole.disk);
    }
    if (from.strips && from.bits == 8) {
      auto texel = one_texel_of(*open_picture(image, read.options.input.pictures.door));
      if (texel && texel->file.size() <= found.totals.disk)
        found = {texel, {1, texel->file.size(), texture_bytes(texel->header, true)}};
    }
    if (found.totals != whole) read.light.emplace(index, std::move(found));
  }
}

void check_gloss(GlossForm gloss, const std::vector<GltfForm>& forms) {
  if (gloss == GlossForm::roughness)
    throw Error::at(setting("gloss-channel"), "roughness",
                    "schueler or one_minus_roughness for a glTF scene");
  if (gloss == GlossForm::schueler && has_form(forms, GltfForm::specular_glossiness))
    throw Error::at(setting("gltf-form"), "specular-glossiness, whose gloss is 1 - roughness",
                    setting("gloss-channel") + " one_minus_roughness");
}

}  // namespace

std::string SceneRead::label(const GltfMaterial& m, std::string_view between) {
  return m.name.empty() ? "material" + std::string(between) + std::to_string(m.index) : m.name;
}

Picture SceneRead::decoded(int image) const {
  const PictureFile& from = file(image);
  FileBytes bytes;
  if (!from.path.empty()) bytes.load(from.path);
  return load_picture(from.path.empty() ? std::string_view(from.bytes) : bytes.view(), from.label,
                      options.input.pictures.door);
}

const PictureHeader& SceneRead::header(int image) const {
  const auto [found, fresh] = headers.try_emplace(image);
  const PictureFile& from = file(image);
  const PictureDoor& door = options.input.pictures.door;
  if (fresh)
    found->second = from.path.empty() ? open_picture(from, door)->header() : picture_header(from.path, door);
  return found->second;
}

TextureTotals SceneRead::image_totals(int image) const {
  const PictureFile& from = file(image);
  const std::uint64_t gpu = texture_bytes(header(image), true);
  return {1, from.path.empty() ? from.bytes.size() : size_of_file(from.path), gpu};
}

TextureTotals SceneRead::kept_totals(int image) const {
  const auto found = light.find(image);
  return found == light.end() ? image_totals(image) : found->second.totals;
}

TextureTotals SceneRead::input_totals(const std::vector<bool>& images) const {
  TextureTotals out;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string& path = scene.images[i].path;
    if (images[i] && (path.empty() || seen.insert(path).second)) out.add(image_totals(static_cast<int>(i)));
  }
  return out;
}

TextureTotals SceneRead::kept_totals(const std::vector<bool>& images) const {
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

std::uint64_t SceneRead::replaced_gpu_bytes() const {
  const std::vector<ImageRole> roles = image_roles(*scene.json, scene.path);
  std::vector<bool> replaced(roles.size());
  for (std::size_t i = 0; i < roles.size(); ++i) replaced[i] = roles[i].material && scene.image_used[i];
  return input_totals(replaced).gpu;
}

bool SceneRead::writes_scene() const {
  // glTF's materials name no part of a texture for one channel: one page is for programs that read layout.json.
  if (options.output.goal == PackGoal::one_page) return false;
  return std::ranges::find(options.output.write.formats, "png") != options.output.write.formats.end();
}

int SceneRead::sampled_levels(int levels) const {
  const bool mips = std::ranges::any_of(entries, [this](const Entry& entry) {
    const GltfTexture* lead = leading_texture(material(entry));
    return lead != nullptr && lead->sampler.mipmaps;
  });
  if (!mips) return 1;
  return levels == 0 ? 0 : std::max(levels, sampled_gutter_levels);
}

PackedScene SceneRead::packed() const {
  PackedScene out;
  out.uses = &*uses;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& entry = entries[i];
    out.materials.emplace(entry.material,
                          PackedScene::Material{inputs.materials[i].name, entry.pair.get(),
                                                entry.use ? &*entry.use : nullptr, &entry.metallic});
  }
  return out;
}

std::unique_ptr<const SceneRead> read_scene(const std::string& path, const PackOptions& options) {
  GltfOptions parts = options.input.gltf;
  parts.mesh_door = options.input.pictures.door.mesh;
  auto out = std::make_unique<SceneRead>(
      SceneRead{options, options.input.pictures.gloss.value_or(GlossForm::one_minus_roughness),
                read_gltf(path, parts)});
  SceneRead& read = *out;
  if (!read.scene.unpacked.empty()) read.remarks.push_back(read.scene.unpacked);
  read.stands_for = first_of_same_pictures(read.scene.images, read.scene.image_used);
  read.uses.emplace(read.scene);
  read.inputs.gloss = read.gloss;
  check_gloss(read.gloss, options.output.forms);
  std::set<std::string> names;
  for (const GltfMaterial& m : read.scene.materials) add_material(m, names, read);
  const auto pictures = std::make_shared<DecodedPictures>(read);
  for (const SceneRead::Entry& entry : read.entries) pictures->await(read.material(entry));
  parallel_chunks(read.entries.size(), options.run.threads, 1,
                  [&](std::size_t begin, std::size_t, unsigned) { learn(read, begin, pictures); });
  find_light_pictures(read);
  for (std::size_t i = 0; i < read.entries.size(); ++i) {
    const SceneRead::Entry& entry = read.entries[i];
    read.remarks.insert(read.remarks.end(), entry.remarks.begin(), entry.remarks.end());
    if (entry.clamped > 0)
      read.remarks.push_back(read.inputs.materials[i].name + ": gloss of " + number(entry.clamped, 3) +
                             " % of the texels lies outside of what the form " +
                             std::string(name(read.gloss)) + " can hold and was brought back to its ends");
  }
  ContentHash hash;
  hash.add(*read.scene.json);
  for (const std::string& buffer : *read.scene.buffers) hash.add(buffer);
  read.inputs.settings = hash.hex();
  return out;
}

}  // namespace etak
