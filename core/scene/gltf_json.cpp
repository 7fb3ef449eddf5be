// SPDX-License-Identifier: Apache-2.0
// Based on: Khronos Group, glTF 2.0 specification, and the extensions named in gltf.h.
#include "core/scene/gltf_json.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/memory.h"
#include "core/base/system.h"
#include "core/exchange/content_kind.h"
#include "core/scene/glb.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

constexpr int most_depth = 64;

/// Extensions that may be required: those read here, and those that change nothing an atlas depends on.
///   mesh   the triangles themselves are asked for: their copies are not placed
bool can_be_required(std::string_view name, bool mesh) {
  if (name == "EXT_mesh_gpu_instancing") return !mesh;
  // image_of_texture() says which picture of KHR_texture_basisu cannot be read.
  return name.starts_with("KHR_materials_") || name == "KHR_texture_transform" ||
         name == "KHR_mesh_quantization" || name == "KHR_lights_punctual" || name == "EXT_texture_webp" ||
         name == "KHR_draco_mesh_compression" || name.ends_with("_meshopt_compression") ||
         name == "KHR_texture_basisu";
}

void check_head(const GltfDocument& document, const GltfOptions& options) {
  const JsonNode root = document.node();
  root.expect_object();
  const JsonNode asset = root.at("asset");
  asset.expect_object();
  const std::string version = asset.at("version").text();
  if (!version.starts_with("2.")) asset.at("version").fail(in_quotes(version), "version 2.x");
  if (asset.has("minVersion") && asset.at("minVersion").text() != "2.0")
    asset.at("minVersion").fail_type("at most \"2.0\"");
  if (!root.has("extensionsRequired")) return;
  const JsonNode required = root.at("extensionsRequired");
  const auto names = required.texts();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!can_be_required(names[i], options.mesh))
      required.at(i).fail("required extension " + in_quotes(names[i]), "extensions that etak knows");
  }
}

std::string beside(std::string_view scene, const std::string& file) {
  return path_beside(sys::path_text(std::filesystem::path(scene).parent_path()), file);
}

std::vector<std::string> buffers_of(const GltfDocument& document,
                                    std::optional<std::string_view> binary_chunk) {
  std::vector<std::string> out;
  const int count = static_cast<int>(document.count("buffers"));
  for (int i = 0; i < count; ++i) {
    const JsonNode node = document.element("buffers", i);
    const std::size_t length = size_at(node.at("byteLength"), "", 0);
    std::string& bytes = out.emplace_back();
    if (node.has("uri")) {
      const std::string uri = node.at("uri").text();
      const std::string place = std::string(document.file) + '#' + node.pointer + "/uri";
      if (auto data = data_of_uri(uri, place))
        bytes = std::move(*data);
      else
        read_file(beside(document.file, file_of_uri(uri, place)), bytes, most_gltf_buffer_bytes);
    } else if (i == 0 && binary_chunk) {
      bytes = *binary_chunk;
    } else if (extension(node.value, "EXT_meshopt_compression") ||
               extension(node.value, "KHR_meshopt_compression")) {
      continue;  // a fallback without bytes: unpack_meshes() fills its views
    } else {
      node.fail("a buffer without bytes", "\"uri\", or the BIN chunk of a .glb");
    }
    if (length > bytes.size())
      node.at("byteLength")
          .fail(std::to_string(length) + " with " + std::to_string(bytes.size()) + " bytes there",
                "no more than there are");
    bytes.resize(length);  // the chunk of a .glb is padded
  }
  return out;
}

std::string_view bytes_of_view(const GltfDocument& document, const JsonNode& number) {
  const JsonNode view = document.element("bufferViews", document.index(number, "bufferViews"));
  const auto buffer = static_cast<std::size_t>(document.index(view.at("buffer"), "buffers"));
  const std::string_view bytes = document.buffers[buffer];
  const std::size_t offset = size_at(view, "byteOffset", 0), length = size_at(view.at("byteLength"), "", 0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    view.fail("bytes beyond the end of its buffer", "bytes inside the buffer");
  return bytes.substr(offset, length);
}

std::vector<PictureFile> images_of(const GltfDocument& document) {
  std::vector<PictureFile> out;
  const int count = static_cast<int>(document.count("images"));
  std::size_t inside = 0;
  for (int i = 0; i < count; ++i) {
    const JsonNode node = document.element("images", i);
    const std::string place = std::string(document.file) + '#' + node.pointer;
    PictureFile& image = out.emplace_back();
    image.label = place;
    if (node.has("uri")) {
      const std::string uri = node.at("uri").text();
      if (auto data = data_of_uri(uri, place + "/uri"))
        image.bytes = std::move(*data);
      else
        image.path = image.label = beside(document.file, file_of_uri(uri, place + "/uri"));
    } else if (node.has("bufferView")) {
      image.bytes = bytes_of_view(document, node.at("bufferView"));
    } else {
      node.fail("an image without a picture", "\"uri\" or \"bufferView\"");
    }
    // Many images may name the same bytes: a small file must not ask for much memory.
    if ((inside += image.bytes.size()) > most_gltf_buffer_bytes)
      node.fail("images inside of more than 2 GiB", "at most so much");
  }
  return out;
}

void mark_used_images(const GltfDocument& document, GltfScene& scene) {
  scene.image_used.assign(scene.images.size(), false);
  for (std::size_t i = 0; i < scene.material_written.size(); ++i) {
    if (!scene.material_written[i]) continue;
    each_image_of_material(document, i,
                           [&](const std::string&, std::size_t image) { scene.image_used[image] = true; });
  }
}

void read_variants(const GltfDocument& document, GltfScene& scene) {
  if (!extension(document.root, "KHR_materials_variants")) return;
  const JsonNode variants = document.node().at("extensions").at("KHR_materials_variants").at("variants");
  variants.expect_array();
  scene.variants = variants.size();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    variants.at(i).expect_object();
    scene.variant_names.push_back(variants.at(i).text_or_empty("name"));
  }
}

}  // namespace

namespace {

/// The document with its meshes decompressed, which `scene` then tells of.
JsonDocument without_packed_meshes(JsonDocument read, std::vector<std::string>& buffers, GltfScene& scene) {
  Json changed = std::move(read).take();
  try {
    scene.unpacked = unpack_meshes(changed, buffers, scene.path, scene.options.mesh_door);
  } catch (...) {
    take_apart(changed);
    throw;
  }
  return JsonDocument(std::move(changed));
}

GltfScene parse_in_memory(std::string_view bytes, const std::string& path, const GltfOptions& options) {
  GltfScene scene;
  scene.path = path;
  scene.options = options;
  std::optional<std::string_view> binary_chunk;
  std::string_view text = bytes;
  if (is_glb(bytes)) {
    const GlbParts parts = split_glb(bytes, path);
    text = parts.json;
    binary_chunk = parts.binary;
  }
  JsonDocument read = parse_json_strictly(text, path, most_depth, "a glTF document");
  check_head({read, path, {}}, options);
  std::vector<std::string> buffers = buffers_of({read, path, {}}, binary_chunk);
  const bool packed = has_packed_meshes(read);
  const JsonDocument root = packed ? without_packed_meshes(std::move(read), buffers, scene) : std::move(read);
  scene.json = std::make_shared<const std::string>(packed ? root->dump() : std::string(text));
  scene.buffers = std::make_shared<const std::vector<std::string>>(std::move(buffers));
  GltfDocument document{root, path, {}};
  document.buffers.assign(scene.buffers->begin(), scene.buffers->end());
  scene.images = images_of(document);
  scene.materials = materials_of(document);
  scene.material_used.assign(scene.materials.size(), false);
  scene.material_written = scene.material_used;
  scene.scenes = document.count("scenes");
  read_variants(document, scene);
  walk_scenes(document, scene);
  mark_used_images(document, scene);
  return scene;
}

}  // namespace

GltfScene parse_gltf(std::string_view bytes, const std::string& path, const GltfOptions& options) {
  return with_memory_for(
      path, [&] { return "a scene of " + mebibytes(bytes.size()); },
      [&] { return parse_in_memory(bytes, path, options); });
}

GltfScene read_gltf(const std::string& path, const GltfOptions& options) {
  std::string bytes;
  read_file(path, bytes, most_gltf_buffer_bytes);
  return parse_gltf(bytes, path, options);
}

GltfFiles files_of_gltf(const std::string& path) {
  GltfFiles out;
  try {
    std::string bytes;
    read_file(path, bytes, most_gltf_buffer_bytes);
    const JsonDocument read = parse_json_strictly(is_glb(bytes) ? split_glb(bytes, path).json : bytes, path,
                                                  most_depth, "a glTF document");
    const auto folder = std::filesystem::path(path).parent_path();
    each_file(*read, [&](const Json& uri, bool picture) {
      try {
        out.all.push_back(
            sys::path_text((folder / file_of_uri(uri.get<std::string>(), path)).lexically_normal()));
      } catch (const Error&) {
        return;
      }
      if (picture) out.pictures.push_back(out.all.back());
    });
  } catch (const Error&) {
    return {};
  }
  return out;
}

bool is_gltf_file(const std::string& path) {
  if (path.ends_with(".gltf") || path.ends_with(".glb")) return true;
  return is_pipe_input(path) && content_kind(read_head(path, content_head)) == ContentKind::gltf;
}

}  // namespace etak
