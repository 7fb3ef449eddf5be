// SPDX-License-Identifier: Apache-2.0
// What each form of a scene would take, the choice among them, and the files that the packer writes.
#include "core/pack/scene/scene_output.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/steady_file.h"
#include "core/base/setting.h"
#include "core/image/files/png_keep.h"
#include "core/image/load.h"
#include "core/image/picture_bytes.h"
#include "core/pack/pack.h"
#include "core/pack/scene/scene_document.h"
#include "core/pack/scene/scene_facts.h"
#include "core/pack/scene/scene_pictures.h"
#include "core/pack/table.h"
#include "core/scene/image_roles.h"

namespace etak {
namespace {

constexpr std::array all_forms{GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough};

/// Which of the scene's other textures may be placed, for each of Others.
using MapsOfOthers = std::array<SceneMaps, 2>;

// How textures are weighed for a goal.
using WeightOf = std::function<TextureWeight(PackGoal)>;

// Images that are written as less than their files, beside the pages.
std::vector<int> kept_light(const SceneRead& read, const SceneChoice& choice) {
  if (read.light.empty() || choice.costs.empty()) return {};  // nothing is decided yet
  const std::vector<bool> kept = images_kept(read.scene, choice.output);
  std::vector<int> out;
  for (const auto& [image, picture] : read.light)
    if (kept[static_cast<std::size_t>(image)]) out.push_back(image);
  return out;
}

void tell_light_pictures(const SceneRead& read, const SceneChoice& choice,
                         std::vector<std::string>& remarks) {
  std::uint64_t bytes = 0;
  for (const int image : kept_light(read, choice)) {
    const SceneRead::LightPicture& picture = read.light.at(image);
    if (picture.texel)
      remarks.push_back(std::filesystem::path(read.file(image).label).filename().string() +
                        ": is of one colour, and scene.gltf reads one texel of it");
    else
      bytes += read.image_totals(image).disk - picture.totals.disk;
  }
  if (bytes > 0)
    remarks.push_back(
        std::to_string(bytes) +
        " bytes of kept PNG files that say nothing of their texels are left out: texts, profiles and the like, of which glTF takes no notice");
}

// The totals of all textures that scene.gltf would read, with `placed` on its pages.
TextureTotals scene_totals(const SceneRead& read, const std::vector<GltfForm>& forms, const SceneMaps& placed,
                           const PackDecision& decision) {
  const SceneOutput of_scene = scene_output(read, placed, forms, decision);
  TextureTotals out = of_scene.totals(decision);
  out.add(read.kept_totals(images_kept(read.scene, of_scene.gltf)));
  return out;
}

// Whether what is written of the form is what was read, but for the rounding of the pair's codes.
bool is_exact(const SceneRead& read, GltfForm form, const MapsOfOthers& maps, const PackDecision& decision) {
  if (form != GltfForm::metal_rough)
    return (form == GltfForm::specular_ior || read.gloss != GlossForm::schueler) &&
           std::ranges::all_of(read.entries, [&](const SceneRead::Entry& entry) {
             return entry.exact || !read.is_used(entry) ||
                    stays_for_its_extensions(read.material(entry), {form});
           });
  const Others others = others_in(read, {form});
  const SceneMaps& of_form = maps[static_cast<std::size_t>(others)];
  for (std::size_t i = 0; i < read.entries.size(); ++i) {
    const MaterialFate& fate = decision.left_out.fates[i];
    if (!is_written(read, read.entries[i], others)) continue;
    const auto found = of_form.find(fate.owner);
    if (fate.texels) {
      if (found == of_form.end() || !found->second.exact) return false;
      continue;
    }
    const GltfMaterial& m = read.material(read.entries[i]);
    AtlasMaterial constants;
    if (!is_plain_metal_rough(m) ||
        !scene_constants(read.inputs.materials[i].facts, m, read.gloss, read.entries[i].own, constants))
      return false;
  }
  return true;
}

MapsOfOthers placeable(const SceneRead& read, const PackDecision& decision) {
  return {scene_maps(read, decision, Others::written), scene_maps(read, decision, Others::stay)};
}

// The forms one of which is written.
std::vector<GltfForm> forms_to_weigh(const SceneRead& read, const MapsOfOthers& maps,
                                     const PackDecision& decision) {
  if (!read.options.output.smallest_form) return read.options.output.forms;
  std::vector<GltfForm> out;
  for (const GltfForm form : all_forms)
    if (is_exact(read, form, maps, decision)) out.push_back(form);
  // None is exact where a texture is stored with fewer texels: of these the pair is meant.
  if (out.empty()) out.push_back(GltfForm::specular_ior);
  return out;
}

// The input without what needs no page to be saved: of pictures with the same texels one counts, of those of one colour
// a texel, and none of those that nothing reads.
TextureTotals trimmed_input(const SceneRead& read) {
  TextureTotals out;
  for (std::size_t i = 0; i < read.stands_for.size(); ++i) {
    const auto image = static_cast<int>(i);
    if (!read.scene.image_used[i] || read.stands_for[i] != image) continue;
    const auto light = read.light.find(image);
    const bool one_texel = light != read.light.end() && light->second.texel;
    out.add(one_texel ? light->second.totals : read.image_totals(image));
  }
  return out;
}

// Places textures on single pages, or leaves them as they were, kind by kind where that is lighter.
void refine(const SceneMaps& maps, const PackDecision& decision,
            const std::function<double(const SceneMaps&)>& weight, SceneMaps& best) {
  using ImageOf = std::optional<int> MaterialMaps::*;
  const std::vector<std::vector<ImageOf>> kinds{{&MaterialMaps::base_color},
                                                {&MaterialMaps::metal_rough, &MaterialMaps::occlusion},
                                                {&MaterialMaps::normal},
                                                {&MaterialMaps::emissive}};
  std::map<int, std::set<std::size_t>> owners;  // by page
  for (std::size_t r = 0; r < decision.regions.size(); ++r)
    if (maps.contains(decision.regions[r].material))
      owners[decision.plan.places[r].page].insert(decision.regions[r].material);
  double least = weight(best);
  for (const auto& [page, on_page] : owners)
    for (const std::vector<ImageOf>& kind : kinds) {
      const auto is_placed = [&](std::size_t owner) {
        return std::ranges::any_of(kind, [&](ImageOf image) { return (best.at(owner).*image).has_value(); });
      };
      const bool placed = std::ranges::any_of(on_page, is_placed);
      SceneMaps other = best;
      for (const std::size_t owner : on_page)
        for (const ImageOf image : kind)
          other.at(owner).*image = placed ? std::nullopt : maps.at(owner).*image;
      if (const double now = weight(other); now < least) least = now, best = std::move(other);
    }
}

// The textures of `maps` that are placed in these forms.
SceneMaps placed(const SceneRead& read, const MapsOfOthers& maps, const std::vector<GltfForm>& forms,
                 const PackDecision& decision, const WeightOf& weight_of, PackGoal goal) {
  const Others others = others_in(read, forms);
  const auto by = [&](PackGoal of) {
    return worthwhile(maps[static_cast<std::size_t>(others)], forms, decision,
                      {others, weight_of(of), [&](int image) { return read.kept_totals(image); }});
  };
  std::vector<SceneMaps> ways{by(goal)};
  // A choice that is lighter page by page may take more than the input on the disk or on the GPU.
  if (goal == PackGoal::within) ways.insert(ways.end(), {by(PackGoal::gpu), by(PackGoal::disk)});
  // Pages were judged one by one; a texture that stays for one of them stays for all.
  ways.push_back(none_placed(ways.front()));
  const auto weight = [&](const SceneMaps& of) {
    return weight_of(goal)(scene_totals(read, forms, of, decision));
  };
  std::vector<double> weights;
  for (const SceneMaps& each : ways) weights.push_back(weight(each));
  const auto least = std::ranges::min_element(weights) - weights.begin();
  SceneMaps best = std::move(ways[static_cast<std::size_t>(least)]);
  constexpr std::size_t most_pages = 16;  // each look weighs the whole scene
  if (goal == PackGoal::within && decision.plan.pages.size() <= most_pages)
    refine(maps[static_cast<std::size_t>(others)], decision, weight, best);
  return best;
}

// The texels of a PNG file as lossless WebP; empty where that is no smaller, or cannot be: 16 bits, or larger than WebP can be.
std::string smaller_webp(std::string_view png, const std::string& label, const PictureDoor& door) {
  constexpr int most_side = 16383;
  if (!door.encode || picture_format(png.substr(0, 32), label) != "png") return {};
  const Picture picture = load_picture(png, label, door);
  const auto* const codes = std::get_if<Image8>(&picture.pixels);
  if (codes == nullptr || codes->width > most_side || codes->height > most_side) return {};
  Image fractions(codes->width, codes->height, codes->channels);
  std::ranges::transform(codes->values, fractions.values.begin(),
                         [](std::uint8_t code) { return static_cast<float>(code) / 255; });
  std::string webp = door.encode(fractions, "webp", "");
  if (webp.size() >= png.size()) return {};
  const auto again = open_picture(webp, label, door), before = rows_of(*codes);
  std::vector<std::uint8_t> one(4 * static_cast<std::size_t>(codes->width)), other = one;
  for (int y = 0; y < codes->height; ++y) {
    again->read_rows(one.data(), one.size(), 1);
    before->read_rows(other.data(), other.size(), 1);
    if (one != other) throw Error::at(label, "a WebP file that reads as other texels", "the same texels");
  }
  return webp;
}

std::string webp_name(const std::string& png, std::set<std::string>& taken) {
  std::string out = std::filesystem::path(png).replace_extension(".webp").string();
  for (int i = 1; !taken.insert(out).second; ++i)
    out = std::to_string(i) + "_" + std::filesystem::path(png).replace_extension(".webp").string();
  return out;
}

// Writes WebP files for pictures of pages and for those that stay, where these are smaller.
//   names   of the files that the scene alone reads
void put_webp(OutputFolder& folder, const SceneRead& read, const SceneChoice& choice, GltfOutput& out,
              std::set<std::string>& names) {
  const PictureDoor& door = read.options.input.pictures.door;
  for (std::string& image : out.images) {
    const std::string webp = smaller_webp(read_file(folder.path_until_commit(image)), image, door);
    if (webp.empty()) continue;
    const std::string name = webp_name(image, *out.taken);
    folder.write(name, webp);
    if (names.erase(image) > 0) folder.take_back(image);
    names.insert(image = name);
  }
  const std::vector<bool> kept = images_kept(read.scene, choice.output);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto index = static_cast<int>(i);
    const PictureFile& file = read.file(index);
    if (!kept[i] || out.rewritten.contains(index)) continue;
    const std::string webp =
        smaller_webp(file.bytes.empty() ? read_file(file.path) : file.bytes, file.label, door);
    if (webp.empty()) continue;
    const std::string plain = file.bytes.empty() ? std::filesystem::path(file.path).filename().string()
                                                 : "image" + std::to_string(i);
    const std::string name = webp_name(plain, *out.taken);
    folder.write(name, webp);
    names.insert(name);
    out.rewritten.emplace(index, name);
  }
}

// Writes scene.glb and takes away the files that it holds.
void write_one_file(OutputFolder& folder, const WrittenGltf& written, const GltfOutput& out,
                    std::set<std::string>& names) {
  std::map<std::string, std::string> pictures;
  for (const auto& list : {std::set<std::string>(out.images.begin(), out.images.end()), names})
    for (const std::string& name : list)
      pictures.try_emplace(name, read_file(folder.path_until_commit(name)));
  const std::string glb = one_file(written, pictures, "scene.glb");
  for (const std::string& name : names) folder.take_back(name);
  folder.write("scene.glb", glb);
  names = {"scene.glb"};
}

}  // namespace

void weigh_page(const SceneRead& read, int page, const PagePixels& pixels, PackDecision& decision,
                const WriteOptions& options) {
  const MapsOfOthers all = placeable(read, decision);
  for (const Others others : {Others::written, Others::stay}) {
    const auto i = static_cast<std::size_t>(others);
    const SceneMaps& maps = all[i];
    std::vector<std::string> names;
    for (const GltfForm form : forms_to_weigh(read, all, decision))
      if (others_in(read, {form}) == others)
        for (const std::string& name : scene_output(read, maps, {form}, decision).gltf.images)
          names.push_back(name);
    if (names.empty()) continue;
    const MapPixels on_page = map_pixels(page, maps, read, decision, options.threads);
    add_scene_picture_sizes({page, pixels, on_page, maps, decision, names, read.gloss}, options,
                            (*decision.sizes)[i]);
  }
}

SceneChoice choose_pictures(const SceneRead& read, const PackDecision& decision, PackGoal goal) {
  SceneChoice out;
  if (!read.writes_scene()) return out;
  const PackOutputOptions& asked = read.options.output;
  const MapsOfOthers maps = placeable(read, decision);
  TextureTotals input;
  if (goal == PackGoal::within)
    input = trimmed_input(read);
  else if (goal == PackGoal::both)
    input = read.input_totals(read.scene.image_used);
  const WeightOf weight_of = [&](PackGoal of) { return TextureWeight(of, input); };
  const TextureWeight weight = weight_of(goal);
  const std::vector<GltfForm> weighed = forms_to_weigh(read, maps, decision);
  std::optional<std::pair<double, GltfForm>> least;
  for (const GltfForm form : all_forms) {
    const SceneMaps on_pages = placed(read, maps, {form}, decision, weight_of, goal);
    const TextureTotals totals = scene_totals(read, {form}, on_pages, decision);
    FormCost& cost = out.costs.emplace_back(
        FormCost{form, totals.files, totals.gpu, std::nullopt, is_exact(read, form, maps, decision), false});
    if (!has_form(weighed, form)) continue;
    if (decision.sizes) cost.disk = totals.disk;
    if (!least || weight(totals) < least->first) least = {weight(totals), form};
  }
  out.forms = asked.smallest_form ? std::vector{least->second} : asked.forms;
  for (FormCost& each : out.costs) each.written = has_form(out.forms, each.form);
  out.maps = placed(read, maps, out.forms, decision, weight_of, goal);
  out.output = scene_output(read, out.maps, out.forms, decision).gltf;
  out.totals = scene_totals(read, out.forms, out.maps, decision);
  out.weight = weight(out.totals);
  return out;
}

std::vector<GoalCost> other_goals(const SceneRead& read, const std::vector<PackDecision>& ways) {
  std::vector<GoalCost> out;
  for (const PackGoal goal : {PackGoal::gpu, PackGoal::disk, PackGoal::both}) {
    if (goal == read.options.output.goal) continue;
    std::optional<double> least;
    for (const PackDecision& way : ways) {
      const SceneChoice choice = choose_pictures(read, way, goal);
      if (least && choice.weight >= *least) continue;
      if (!least) out.emplace_back();
      least = choice.weight;
      out.back() = {goal, choice.forms.front(), choice.totals};
    }
  }
  return out;
}

std::set<std::string> write_page(OutputFolder& folder, const WholePage& page, const SceneRead& read,
                                 const SceneChoice& choice) {
  if (!read.writes_scene()) return {};
  const MapPixels maps = map_pixels(page.number, choice.maps, read, page.decision, page.options.threads);
  return write_scene_pictures(
      folder, {page.number, page.pixels, maps, choice.maps, page.decision, choice.output.images, read.gloss},
      page.options);
}

std::vector<std::string> write_scene(OutputFolder& folder, const AtlasLayout& layout, const SceneRead& read,
                                     const SceneChoice& choice, const std::set<std::string>& pictures) {
  if (!read.writes_scene()) return {};
  GltfOutput out = choice.output;
  out.taken.emplace(pictures.begin(), pictures.end());
  for (const AtlasPage& page : layout.pages)
    for (const auto& files : page.files) out.taken->insert(files.begin(), files.end());
  out.taken->insert({out.buffer_name, "scene.gltf", "scene.glb", layout_file_name});
  std::set<std::string> names = pictures;
  std::map<std::string, const std::string*> texels;
  for (const int image : kept_light(read, choice))
    if (const auto& texel = read.light.at(image).texel) texels.emplace(texel->name, &texel->file);
  for (const auto& [name, bytes] : texels) {
    out.taken->insert(name);
    folder.write(name, *bytes);
    names.insert(name);
  }
  if (read.options.output.webp) put_webp(folder, read, choice, out, names);
  const WrittenGltf written = write_gltf(read.scene, out);
  for (const CopiedFile& copy : written.files) {
    FileBytes file;
    file.load(copy.from);
    BytesInMemory bytes(file.view());
    const auto light = read.light.empty() ? std::nullopt : texels_alone(bytes);
    folder.write(copy.name, light ? std::string_view(*light) : file.view());
    names.insert(copy.name);
  }
  if (read.options.output.one_file) {
    write_one_file(folder, written, out, names);
    return {names.begin(), names.end()};
  }
  folder.write("scene.gltf", written.json);
  names.insert("scene.gltf");
  if (!written.buffer.empty()) {
    folder.write(out.buffer_name, written.buffer);
    names.insert(out.buffer_name);
  }
  return {names.begin(), names.end()};
}

void add_remarks(const SceneRead& read, const SceneChoice& choice, std::vector<std::string>& remarks) {
  remarks.insert(remarks.end(), read.remarks.begin(), read.remarks.end());
  tell_light_pictures(read, choice, remarks);
  if (!choice.costs.empty() && others_in(read, choice.forms) == Others::stay)
    for (const SceneRead::Entry& entry : read.entries)
      if (const GltfMaterial& m = read.material(entry); read.is_used(entry) && !is_plain_metal_rough(m))
        remarks.push_back(SceneRead::label(m, " ") +
                          ": is not of plain metal-rough form and stays as it is in scene.gltf");
  for (const SceneRead::Entry& entry : read.entries)
    if (const GltfMaterial& m = read.material(entry);
        read.is_used(entry) && stays_for_its_extensions(m, choice.forms))
      remarks.push_back(
          SceneRead::label(m, " ") +
          ": has extensions beside which specular-glossiness may not stand, and stays as it is in scene.gltf");
  if (!read.writes_scene())
    remarks.push_back("no scene.gltf was written: its pictures are PNG, which " + setting("textures") +
                      " does not name");
}

}  // namespace etak
