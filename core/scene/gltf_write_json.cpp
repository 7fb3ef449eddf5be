// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_write_json.h"

#include <filesystem>

#include "core/base/system.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

/// Refuses documents that refer to materials, images or buffers in ways that the writer does not know.
void refuse_unkept(const GltfRewrite& rewrite) {
  const Json& root = rewrite.root;
  if (extension(root, "EXT_lights_image_based"))
    throw Error::at(rewrite.scene.path, "EXT_lights_image_based",
                    "a scene without it: its images are not followed");
  each_key(root, [&](const std::string& key, const Json& value) {
    if (key == "pointer" && value.is_string() && value.get<std::string>().starts_with("/materials/"))
      throw Error::at(rewrite.scene.path, "an animation of " + printable(value.get<std::string>()),
                      "no animated materials");
  });
}

/// Drops the mappings of variants where these do not count: their materials are not reached.
void remove_variants(Json& root) {
  remove_extension(root, "KHR_materials_variants");
  if (!root.contains("meshes")) return;
  for (Json& mesh : root["meshes"])
    if (mesh.contains("primitives"))
      for (Json& primitive : mesh["primitives"]) remove_extension(primitive, "KHR_materials_variants");
}

/// The names that the document's files get beside the written document, by URI.
std::map<std::string, std::string> names_beside(const GltfRewrite& rewrite) {
  std::map<std::string, std::string> out;
  std::set<std::string> taken = *rewrite.output.taken;
  each_file(rewrite.root, [&](const Json& uri, bool) {
    std::string& name = out[uri.get<std::string>()];
    if (!name.empty()) return;
    const std::string file = file_of_uri(uri.get<std::string>(), rewrite.scene.path);
    const std::string plain = name = sys::path_text(std::filesystem::path(file).filename());
    for (int i = 1; !taken.insert(name).second; ++i) name = std::to_string(i) + "_" + plain;
  });
  return out;
}

/// Lets textures read the first of images that have the same bytes.
void share_images(GltfRewrite& rewrite) {
  const std::vector<int>& first = rewrite.output.stands_for;
  if (first.empty() || !rewrite.root.contains("textures")) return;
  each_key(rewrite.root["textures"], [&](const std::string& key, Json& value) {
    if (key == "source" && value.is_number_integer() && value >= 0 && value < first.size())
      value = first[value.get<std::size_t>()];
  });
}

/// Lets textures read WebP pictures by the extension for them.
void name_webp(Json& root) {
  if (!root.contains("textures") || !root.contains("images")) return;
  for (Json& texture : root["textures"]) {
    if (!texture.contains("source")) continue;
    const Json& image = root["images"][texture["source"].get<std::size_t>()];
    if (!image.contains("uri") || !image["uri"].get_ref<const std::string&>().ends_with(".webp")) continue;
    texture["extensions"]["EXT_texture_webp"] = {{"source", texture["source"]}};
    texture.erase("source");
  }
}

/// Puts the files that stand for images of the document in their place.
void rewrite_images(GltfRewrite& rewrite) {
  for (const auto& [image, name] : rewrite.output.rewritten) {
    Json& json = rewrite.root["images"][static_cast<std::size_t>(image)];
    Json to{{"uri", uri_of_file(name)}};
    if (json.contains("name")) to["name"] = json["name"];
    json = std::move(to);
  }
}

}  // namespace

int GltfRewrite::append(const char* array, Json element) {
  return append_element(root, array, std::move(element));
}

namespace {

WrittenGltf written(const GltfScene& scene, const GltfOutput& output) {
  GltfRewrite rewrite{
      scene, output, parse_json_strictly(*scene.json, scene.path, 64, "a glTF document").take(), {}, {}, {}};
  rewrite.buffers.assign(scene.buffers->begin(), scene.buffers->end());
  check_output(rewrite);
  refuse_unkept(rewrite);
  // Before images are added: an image of the atlas may have the name that a file of the document had.
  std::map<std::string, std::string> names;
  if (output.taken) {
    names = names_beside(rewrite);
    each_file(rewrite.root, [&](Json& uri, bool) { uri = uri_of_file(names[uri.get<std::string>()]); });
  }
  const JsonDocument before(rewrite.root);
  drop_packing(rewrite.root);
  share_images(rewrite);
  rewrite_images(rewrite);
  if (!scene.options.variants) remove_variants(rewrite.root);
  for (const AtlasMaterial& material : output.materials) {
    if (const auto transform = transform_of(scene, material)) {
      write_material(rewrite, material, material.uv_set, *transform);
      continue;
    }
    // The material first: what other textures remain in it decides whether its UV set may be written over.
    write_material(rewrite, material, material.uv_set, {});
    const int set = uv_set_for(rewrite, material);
    if (set != material.uv_set) write_material(rewrite, material, set, {});
    rewrite_uvs(rewrite, material, set);
  }
  drop_unused(rewrite, before);
  WrittenGltf out;
  out.buffer = compact_buffers(rewrite);
  name_webp(rewrite.root);
  name_extensions(rewrite, before);
  out.json = rewrite.root.dump(1) + "\n";
  std::set<std::string> used;
  each_file(rewrite.root, [&](const Json& uri, bool) { used.insert(uri.get<std::string>()); });
  const auto folder = std::filesystem::path(scene.path).parent_path();
  for (const auto& [uri, name] : names)
    if (used.contains(uri_of_file(name)))
      out.files.push_back({sys::path_text(folder / file_of_uri(uri, scene.path)), name});
  return out;
}

}  // namespace

WrittenGltf write_gltf(const GltfScene& scene, const GltfOutput& output) {
  try {
    return written(scene, output);
  } catch (const Json::exception& e) {
    // Parts that no scene reaches were not looked at when the document was read.
    throw Error::at(scene.path, printable(e.what(), 200), "a document that follows the specification");
  }
}

}  // namespace etak
