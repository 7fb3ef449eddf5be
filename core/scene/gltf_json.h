// SPDX-License-Identifier: Apache-2.0
// What the gltf_*json.cpp files share: no public header, because it names nlohmann-json.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json/node_json.h"
#include "core/scene/gltf.h"

namespace etak {

/// A document and the bytes of its buffers.
struct GltfDocument {
  const Json& root;
  std::string_view file;                  // for messages
  std::vector<std::string_view> buffers;  // one per buffer of the document

  JsonNode node() const { return {root, file, ""}; }
  /// Elements of an array of the document ("meshes"); 0 where it is absent.
  std::size_t count(const char* array) const;
  JsonNode element(const char* array, int index) const;
  /// The number in `node`, as an index into that array. Throws Error out of range.
  int index(const JsonNode& node, const char* array) const;
};

/// A count, length or offset.
std::size_t size_at(const JsonNode& node, std::string_view key, std::size_t otherwise);
/// The number under `key`, or the specification's default `otherwise`.
double number_at(const JsonNode& node, std::string_view key, double otherwise, double least, double most);
/// `node` as numbers in the array `to`.
void numbers_into(const JsonNode& node, double* to, std::size_t count, double least, double most);
template <std::size_t n>
void numbers_at(const JsonNode& node, std::string_view key, std::array<double, n>& out, double least,
                double most) {
  if (node.has(key)) numbers_into(node.at(key), out.data(), n, least, most);
}
/// The extension of that name on an object; none when it has none.
const Json* extension(const Json& object, std::string_view name);

/// The elements of an accessor, sparse ones put in place. Every element lies within its buffer.
struct GltfElements {
  std::size_t count = 0, components = 0;
  int type = 5126;  // the specification's componentType
  bool normalized = false;
  std::size_t size = 0;    // bytes of one element
  std::size_t stride = 0;  // bytes from one element to the next
  const char* first = nullptr;
  std::vector<char> owned;  // where they had to be copied

  GltfElements() = default;
  GltfElements(GltfElements&&) = default;
  GltfElements& operator=(GltfElements&&) = default;

  /// Integers as numbers, or as shares of their range when normalised.
  double number(std::size_t element, std::size_t component) const;
  std::uint32_t integer(std::size_t element) const;
};
/// The index of a new element of an array of the document, which is made where it is absent.
int append_element(Json& root, const char* array, Json element);
/// Takes an extension off an object, and `extensions` too when it was the last.
void remove_extension(Json& object, std::string_view name);
/// Elements of `size` bytes, one behind the other, and what their view is for: 34962 (vertices) or 34963 (indices).
struct TightElements {
  const std::string& bytes;
  std::size_t size = 0;
  int target = 34962;
};
/// Gives the elements of an accessor a view and a buffer of their own in the document; returns the bytes of that buffer,
/// in which vertices are padded to whole words.
std::string put_in_view(Json& root, Json& accessor, const TightElements& elements);

/// Decompresses the views and primitives of a document whose bytes are there in compressed form alone
/// (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression), each array into a buffer of its own
/// at the end of `buffers`. Throws Error for what the door refuses, and for more than most_gltf_buffer_bytes in all.
/// Returns what was decompressed, for people; empty where nothing was.
std::string unpack_meshes(Json& root, std::vector<std::string>& buffers, std::string_view file,
                          const MeshDoor& door);
/// Takes these extensions off the elements of a document, whose meshes were decompressed.
void drop_packing(Json& root);
/// Whether the document names one of these extensions anywhere.
bool has_packed_meshes(const Json& root);

/// The bytes that an accessor reads, counted from the beginning of its view.
struct AccessorBytes {
  int view = -1;
  std::size_t begin = 0, end = 0;
  std::size_t stride = 0;  // of the view; 0: its elements are packed
};
/// None for an accessor without a view, with sparse elements, or of matrices.
std::optional<AccessorBytes> bytes_of_accessor(const GltfDocument& document, int index);

/// What an accessor says of its elements, none of which are there.
GltfElements shape_of_accessor(const JsonNode& accessor);
/// Opens accessor `index` of the document: SCALAR and VEC2..4.
GltfElements open_accessor(const GltfDocument& document, int index);

/// The vertex indices of what a primitive draws, as triangles: of a line the second stands twice, of a point all are
/// the same.
struct DrawnCorners {
  int distinct = 3;  // corners of an element: 1 of points, 2 of lines
  std::vector<std::array<std::uint32_t, 3>> elements;
};
///   vertices   all indices are below it
///   most       more elements than this throw Error
DrawnCorners drawn_corners(const GltfDocument& document, const JsonNode& primitive, std::size_t vertices,
                           std::size_t most);

/// All materials of the document.
std::vector<GltfMaterial> materials_of(const GltfDocument& document);
/// The image of a texture of the document: its source, or that of an extension; -1 when it has none.
int image_of_texture(const GltfDocument& document, int texture);

/// The materials of a primitive: its own, then those of its variants, then those of their levels of detail.
std::vector<int> materials_of_primitive(const GltfDocument& document, const JsonNode& primitive,
                                        bool variants);

/// The elements of an object's MSFT_lod, indices into `array`; none where it has no such extension.
std::vector<int> lower_levels(const GltfDocument& document, const JsonNode& node, const char* array);

/// Walks the scenes that `scene.options` names: uses, cameras, used materials. Then the other scenes.
void walk_scenes(const GltfDocument& document, GltfScene& scene);

/// Calls see(key, value) for every key of every object in `json`, outer ones first.
template <class Value, class See>
void each_key(Value& json, const See& see) {
  if (json.is_object())
    for (auto item = json.begin(); item != json.end(); ++item) see(item.key(), *item);
  if (json.is_structured())
    for (auto& child : json) each_key(child, see);
}
/// Calls see(uri, is_picture) for the URI of every image and buffer that is a file of its own, images first.
/// Members of wrong types are passed over.
template <class Value, class See>
void each_file(Value& root, const See& see) {
  if (!root.is_object()) return;
  for (const char* array : {"images", "buffers"}) {
    const auto list = root.find(array);
    if (list == root.end() || !list->is_array()) continue;
    for (auto& element : *list)
      if (element.is_object())
        if (const auto uri = element.find("uri"); uri != element.end() && uri->is_string())
          if (!uri->template get_ref<const std::string&>().starts_with("data:"))
            see(*uri, std::string_view(array) == "images");
  }
}
/// Calls see(key, texture_info) for every texture a material refers to, extensions included: what the glTF
/// family of specifications calls a textureInfo stands under a key that ends so.
template <class Value, class See>
void each_texture_info(Value& material, const See& see) {
  each_key(material, [&](const std::string& key, auto& value) {
    if ((key.ends_with("Texture") || key == "texture") && value.is_object() && value.contains("index"))
      see(key, value);
  });
}
/// Calls see(key, image) for every texture of a material of the document that has an image; `key` is that of
/// the texture info. Throws Error for a texture that is not there.
template <class See>
void each_image_of_material(const GltfDocument& document, std::size_t material, const See& see) {
  each_texture_info(document.root["materials"][material], [&](const std::string& key, const Json& info) {
    const std::string pointer = "/materials/" + std::to_string(material) + "/.../index";
    const int texture = document.index({info["index"], document.file, pointer}, "textures");
    if (const int image = image_of_texture(document, texture); image >= 0)
      see(key, static_cast<std::size_t>(image));
  });
}

}  // namespace etak
