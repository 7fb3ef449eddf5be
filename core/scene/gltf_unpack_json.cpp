// SPDX-License-Identifier: Apache-2.0
// Based on: Khronos Group, EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression.
#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/text/text.h"
#include "core/scene/gltf_json.h"

namespace etak {
namespace {

constexpr std::array meshopt_names{"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr const char* draco_name = "KHR_draco_mesh_compression";

class Unpacking {
 public:
  Unpacking(Json& root, std::vector<std::string>& buffers, std::string_view file, const MeshDoor& door)
      : root_(root), buffers_(buffers), file_(file), door_(door) {}

  void views() {
    const int count = static_cast<int>(document().count("bufferViews"));
    for (int i = 0; i < count; ++i)
      for (const char* name : meshopt_names)
        if (extension(document().element("bufferViews", i).value, name)) view(i, name);
  }

  void primitives() {
    const int count = static_cast<int>(document().count("meshes"));
    for (int mesh = 0; mesh < count; ++mesh) {
      const JsonNode node = document().element("meshes", mesh);
      if (!node.has("primitives")) continue;
      node.at("primitives").expect_array();
      for (std::size_t i = 0; i < node.at("primitives").size(); ++i)
        if (extension(node.at("primitives").at(i).value, draco_name)) primitive(mesh, i);
    }
  }

  std::string told() const {
    if (unpacked_ == 0) return {};
    return "meshes of " + std::to_string(packed_) + " bytes that " + std::string(by_) +
           " had compressed are written as " + std::to_string(unpacked_) + " bytes";
  }

 private:
  /// The document of `root_` as it is now: a reference to an element does not outlive an addition to its array.
  GltfDocument document() const { return {root_, file_, {buffers_.begin(), buffers_.end()}}; }
  static std::string place_of(const JsonNode& node) { return std::string(node.file) + '#' + node.pointer; }

  /// The bytes of a buffer that `node` describes as a view does.
  std::string_view bytes_at(const JsonNode& node) const {
    const auto buffer = static_cast<std::size_t>(document().index(node.at("buffer"), "buffers"));
    const std::string_view bytes = buffers_[buffer];
    const std::size_t offset = size_at(node, "byteOffset", 0), length = size_at(node.at("byteLength"), "", 0);
    if (offset > bytes.size() || length > bytes.size() - offset)
      node.fail("bytes beyond the end of its buffer", "bytes inside the buffer");
    return bytes.substr(offset, length);
  }

  void count(const JsonNode& node, std::string_view by, std::size_t packed, std::size_t bytes) {
    by_ = by;
    packed_ += packed;
    unpacked_ += bytes;
    if (unpacked_ > most_gltf_buffer_bytes) node.fail("meshes of more than 2 GiB", "at most so much");
  }

  template <class Decode>
  static void expect_decoder(const Decode& decode, const JsonNode& node, std::string_view name) {
    if (!decode)
      node.fail("meshes compressed by " + std::string(name),
                "meshes that are not compressed: there is no decoder here");
  }

  void view(int index, const char* name) {
    const GltfDocument now = document();
    const JsonNode node = now.element("bufferViews", index);
    const std::string_view fallback =
        now.buffers[static_cast<std::size_t>(now.index(node.at("buffer"), "buffers"))];
    const std::size_t offset = size_at(node, "byteOffset", 0), length = size_at(node.at("byteLength"), "", 0);
    if (offset <= fallback.size() && length <= fallback.size() - offset) return;
    const JsonNode from = node.at("extensions").at(name);
    MeshoptElements elements;
    elements.count = size_at(from.at("count"), "", 0);
    elements.stride = size_at(from.at("byteStride"), "", 0);
    elements.mode = one_of(from.at("mode"), {"ATTRIBUTES", "TRIANGLES", "INDICES"});
    if (from.has("filter"))
      elements.filter = one_of(from.at("filter"), {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"});
    elements.bytes = bytes_at(from);
    if (elements.stride > 256 || elements.count * elements.stride != length)
      from.fail(std::to_string(elements.count) + " elements of " + std::to_string(elements.stride) + " bytes",
                "the byteLength of its view, " + std::to_string(length));
    expect_decoder(door_.meshopt, from, name);
    count(from, name, elements.bytes.size(), length);
    std::string bytes = door_.meshopt(elements, place_of(from));
    const int buffer = append_element(root_, "buffers", {{"byteLength", bytes.size()}});
    buffers_.push_back(std::move(bytes));
    Json& view = root_["bufferViews"][static_cast<std::size_t>(index)];
    view["buffer"] = buffer;
    view.erase("byteOffset");
  }

  static std::string one_of(const JsonNode& node, const std::vector<std::string>& words) {
    std::string out = node.text();
    if (std::find(words.begin(), words.end(), out) == words.end()) node.fail_type(joined(words, ", "));
    return out;
  }

  /// An array of a Draco mesh, and the accessor that takes it.
  struct Taken {
    int accessor = -1;
    DracoArray array;
    std::size_t size = 0;  // bytes of an element
  };

  Taken taken(const JsonNode& accessor_index, int id) const {
    const int index = document().index(accessor_index, "accessors");
    const JsonNode accessor = document().element("accessors", index);
    const GltfElements shape = shape_of_accessor(accessor);
    return {index, {id, shape.type, shape.components, shape.count}, shape.size};
  }

  bool has_view(int accessor) const { return document().element("accessors", accessor).has("bufferView"); }

  void primitive(int mesh, std::size_t index) {
    const GltfDocument now = document();
    const JsonNode node = now.element("meshes", mesh).at("primitives").at(index);
    const JsonNode from = node.at("extensions").at(draco_name);
    const JsonNode ids = from.at("attributes"), attributes = node.at("attributes");
    ids.expect_object();
    attributes.expect_object();
    std::vector<Taken> wanted;
    for (const auto& [name, id] : ids.value.items())
      wanted.push_back(taken(attributes.at(name), ids.at(name).integer(0)));
    if (!node.has("indices")) node.fail("a mesh of Draco without indices", "\"indices\"");
    wanted.push_back(taken(node.at("indices"), -1));
    // Beside an uncompressed mesh the compressed one is not read; nor twice, where two primitives share one.
    if (std::all_of(wanted.begin(), wanted.end(), [&](const Taken& each) { return has_view(each.accessor); }))
      return;
    expect_decoder(door_.draco, from, draco_name);
    const JsonNode view = now.element("bufferViews", now.index(from.at("bufferView"), "bufferViews"));
    const std::string_view bytes = bytes_at(view);
    std::vector<DracoArray> arrays;
    std::size_t size = 0;
    for (const Taken& each : wanted) {
      arrays.push_back(each.array);
      if (each.array.count > most_gltf_buffer_bytes / 64)
        node.fail("a mesh of " + std::to_string(each.array.count) + " elements", "fewer");
      size += each.array.count * each.size;
    }
    count(from, draco_name, bytes.size(), size);
    const std::vector<std::string> decoded = door_.draco(bytes, arrays, place_of(from));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      Json& accessor = root_["accessors"][static_cast<std::size_t>(wanted[i].accessor)];
      const int target = wanted[i].array.id < 0 ? 34963 : 34962;
      buffers_.push_back(put_in_view(root_, accessor, {decoded[i], wanted[i].size, target}));
    }
    root_["meshes"][static_cast<std::size_t>(mesh)]["primitives"][index]["mode"] =
        4;  // strips are triangles now
  }

  Json& root_;
  std::vector<std::string>& buffers_;
  std::string_view file_;
  const MeshDoor& door_;
  std::string_view by_;
  std::size_t packed_ = 0, unpacked_ = 0;
};

}  // namespace

int append_element(Json& root, const char* array, Json element) {
  Json& elements = root[array];
  if (!elements.is_array()) elements = Json::array();
  elements.push_back(std::move(element));
  return static_cast<int>(elements.size()) - 1;
}

void remove_extension(Json& object, std::string_view name) {
  if (!object.is_object()) return;
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return;
  extensions->erase(std::string(name));
  if (extensions->empty()) object.erase(extensions);
}

std::string put_in_view(Json& root, Json& accessor, const TightElements& e) {
  const std::size_t count = e.size == 0 ? 0 : e.bytes.size() / e.size;
  const std::size_t stride = e.target == 34963 ? e.size : (e.size + 3) / 4 * 4;
  std::string bytes(count * stride, '\0');
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(bytes.data() + i * stride, e.bytes.data() + i * e.size, e.size);
  const int buffer = append_element(root, "buffers", {{"byteLength", bytes.size()}});
  Json view{{"buffer", buffer}, {"byteLength", bytes.size()}, {"target", e.target}};
  if (stride != e.size) view["byteStride"] = stride;
  accessor["bufferView"] = append_element(root, "bufferViews", std::move(view));
  accessor.erase("byteOffset");
  accessor.erase("sparse");
  return bytes;
}

void drop_packing(Json& root) {
  const auto from_each = [&](Json& array) {
    for (Json& element : array)
      for (const char* name : {meshopt_names[0], meshopt_names[1], draco_name})
        remove_extension(element, name);
  };
  for (const char* array : {"buffers", "bufferViews"})
    if (root.contains(array)) from_each(root[array]);
  if (root.contains("meshes"))
    for (Json& mesh : root["meshes"])
      if (mesh.is_object() && mesh.contains("primitives")) from_each(mesh["primitives"]);
}

bool has_packed_meshes(const Json& root) {
  bool found = false;
  each_key(root, [&](const std::string& key, const Json&) {
    found = found || key == draco_name ||
            std::find(meshopt_names.begin(), meshopt_names.end(), key) != meshopt_names.end();
  });
  return found;
}

std::string unpack_meshes(Json& root, std::vector<std::string>& buffers, std::string_view file,
                          const MeshDoor& door) {
  Unpacking unpacking(root, buffers, file, door);
  unpacking.views();
  unpacking.primitives();
  return unpacking.told();
}

}  // namespace etak
