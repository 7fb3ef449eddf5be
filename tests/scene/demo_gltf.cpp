// SPDX-License-Identifier: Apache-2.0
#include "tests/scene/demo_gltf.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes/bytes_le.h"
#include "core/base/json/json_text.h"
#include "core/math/sphere_mesh.h"

namespace etak::demo {
namespace {

struct Vertex {
  std::array<float, 3> position, normal;
  std::array<float, 2> uv;
};
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> triangles;
};

Mesh sphere(int slices, int stacks) {
  SphereMesh mesh = sphere_mesh(slices, stacks);
  Mesh out;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    out.vertices.push_back({mesh.points[i], mesh.points[i], mesh.uvs[i]});
  out.triangles = std::move(mesh.triangles);
  return out;
}

// Two units wide and deep, facing up, with texture coordinates from (u0, v0) to (u1, v1).
Mesh quad(float u0, float v0, float u1, float v1) {
  const std::array<float, 3> up{0, 1, 0};
  return {{{{-1, 0, -1}, up, {u0, v0}},
           {{1, 0, -1}, up, {u1, v0}},
           {{-1, 0, 1}, up, {u0, v1}},
           {{1, 0, 1}, up, {u1, v1}}},
          {0, 2, 1, 1, 2, 3}};
}

// Buffer, views and accessors as they grow; four accessors a mesh: indices, position, normal, uv.
struct Geometry {
  std::string buffer;
  std::vector<std::string> views, accessors;

  void view(std::size_t from, int target) {
    views.push_back("{\"buffer\": 0, \"byteOffset\": " + std::to_string(from) + ", \"byteLength\": " +
                    std::to_string(buffer.size() - from) + ", \"target\": " + std::to_string(target) + "}");
    while (buffer.size() % 4 != 0) buffer.push_back('\0');
  }
  void accessor(int component, std::size_t count, std::string_view type, std::string_view more = {}) {
    accessors.push_back("{\"bufferView\": " + std::to_string(views.size() - 1) + ", \"componentType\": " +
                        std::to_string(component) + ", \"count\": " + std::to_string(count) +
                        ", \"type\": \"" + std::string(type) + '"' + std::string(more) + "}");
  }
  std::size_t add(const Mesh& mesh) {
    constexpr int vertices = 34962, indices = 34963, ushort = 5123, real = 5126;
    const std::size_t first = accessors.size(), count = mesh.vertices.size();
    std::size_t from = buffer.size();
    for (const std::uint16_t i : mesh.triangles) bytes_le::append(buffer, i, 2);
    view(from, indices);
    accessor(ushort, mesh.triangles.size(), "SCALAR");
    std::array<float, 3> least = mesh.vertices[0].position, most = least;
    from = buffer.size();
    for (const Vertex& v : mesh.vertices)
      for (std::size_t c = 0; c < 3; ++c) {
        least[c] = std::min(least[c], v.position[c]);
        most[c] = std::max(most[c], v.position[c]);
        bytes_le::append_float(buffer, v.position[c]);
      }
    view(from, vertices);
    const auto three = [](const std::array<float, 3>& v) {
      return "[" + json(double{v[0]}) + ", " + json(double{v[1]}) + ", " + json(double{v[2]}) + "]";
    };
    accessor(real, count, "VEC3", ", \"min\": " + three(least) + ", \"max\": " + three(most));
    from = buffer.size();
    for (const Vertex& v : mesh.vertices)
      for (const float c : v.normal) bytes_le::append_float(buffer, c);
    view(from, vertices);
    accessor(real, count, "VEC3");
    from = buffer.size();
    for (const Vertex& v : mesh.vertices)
      for (const float c : v.uv) bytes_le::append_float(buffer, c);
    view(from, vertices);
    accessor(real, count, "VEC2");
    return first;
  }
};

std::string list(std::string_view name, const std::vector<std::string>& items) {
  std::string out = "  \"" + std::string(name) + "\": [\n";
  for (std::size_t i = 0; i < items.size(); ++i)
    out += "    " + items[i] + (i + 1 < items.size() ? ",\n" : "\n");
  return out + "  ]";
}

}  // namespace

GltfText demo_gltf(const std::string& buffer_name) {
  Geometry geometry;
  const std::size_t ball = geometry.add(sphere(32, 16)), whole = geometry.add(quad(0, 0, 1, 1));
  const std::size_t tiled = geometry.add(quad(0, 0, 4, 4)),
                    part = geometry.add(quad(0.125f, 0.25f, 0.5f, 0.625f));

  // Texture i shows image i; the floor alone repeats.
  const std::vector<std::string> images{
      "wood_colour.png", "wood_metal_rough.png",  "leaf.png",          "gold_metal_rough.png",
      "stone_dry.png",   "stone_dry_copy.png",    "stone_normals.png", "stone_wet_f0_gloss.png",
      "stone_wet.png",   "copper_metal_rough.png"};
  std::vector<std::string> image_items, texture_items;
  for (std::size_t i = 0; i < images.size(); ++i) {
    image_items.push_back("{\"uri\": " + json(images[i]) + "}");
    texture_items.push_back("{\"source\": " + std::to_string(i) + ", \"sampler\": " + (i < 2 ? "0" : "1") +
                            "}");
  }

  const std::vector<std::string> materials{
      R"({"name": "gold", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.78, 0.34, 1], "metallicRoughnessTexture": {"index": 3}}})",
      R"({"name": "floor", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}}})",
      R"({"name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": true, "pbrMetallicRoughness": {"baseColorTexture": {"index": 2}, "metallicFactor": 0, "roughnessFactor": 0.6}})",
      R"({"name": "red plastic", "pbrMetallicRoughness": {"baseColorFactor": [0.45, 0.006, 0.01, 1], "metallicFactor": 0, "roughnessFactor": 0.3}})",
      R"({"name": "dry stone", "normalTexture": {"index": 6}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 4}, "metallicFactor": 0, "roughnessFactor": 0.85}})",
      R"({"name": "dry stone again", "extensions": {"KHR_materials_ior": {"ior": 1.4}}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 5}, "metallicFactor": 0, "roughnessFactor": 0.85}})",
      R"({"name": "wet stone", "normalTexture": {"index": 6}, "extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseTexture": {"index": 8}, "specularGlossinessTexture": {"index": 7}}}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 8}, "metallicFactor": 0, "roughnessFactor": 0.2}})",
      R"({"name": "glass", "alphaMode": "BLEND", "extensions": {"KHR_materials_ior": {"ior": 1.517}}, "pbrMetallicRoughness": {"baseColorFactor": [0.05, 0.07, 0.055, 0.08], "metallicFactor": 0, "roughnessFactor": 0}})",
      R"({"name": "nobody's copper", "pbrMetallicRoughness": {"baseColorFactor": [0.96, 0.64, 0.54, 1], "metallicRoughnessTexture": {"index": 9}}})"};

  struct Thing {
    const char* name;
    std::size_t first_accessor;
    int material;
    std::string place;
  };
  const std::vector<Thing> things{
      {"floor", tiled, 1, R"("scale": [6, 1, 6], "translation": [0, -1, 0])"},
      {"gold ball", ball, 0, R"("translation": [-3.3, 0, 0])"},
      {"plastic ball", ball, 3, R"("translation": [-1.1, 0, 0])"},
      {"wet ball", ball, 6, R"("translation": [1.1, 0, 0])"},
      {"glass ball", ball, 7, R"("translation": [3.3, 0, 0.5])"},
      {"dry slab", part, 4, R"("scale": [1.2, 1, 1.2], "translation": [-2, -0.99, 3])"},
      {"other slab", part, 5, R"("scale": [1.2, 1, 1.2], "translation": [2, -0.99, 3])"},
      {"leaf", whole, 2, R"("rotation": [0.70710678, 0, 0, 0.70710678], "translation": [0, 0.2, -2.5])"}};
  std::vector<std::string> meshes, nodes;
  std::string roots;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Thing& t = things[i];
    const auto accessor = [&](std::size_t n) { return std::to_string(t.first_accessor + n); };
    meshes.push_back(
        "{\"name\": " + json(t.name) + ", \"primitives\": [{\"attributes\": {\"POSITION\": " + accessor(1) +
        ", \"NORMAL\": " + accessor(2) + ", \"TEXCOORD_0\": " + accessor(3) +
        "}, \"indices\": " + accessor(0) + ", \"material\": " + std::to_string(t.material) + "}]}");
    nodes.push_back("{\"name\": " + json(t.name) + ", \"mesh\": " + std::to_string(i) + ", " + t.place + "}");
    roots += std::to_string(i) + ", ";
  }
  nodes.push_back(
      R"({"name": "eye", "camera": 0, "rotation": [-0.17364818, 0, 0, 0.98480775], "translation": [0, 3.4, 10]})");
  roots += std::to_string(things.size());

  std::string out =
      "{\n  \"asset\": {\"version\": \"2.0\", \"generator\": \"etak-demo-scene\"},\n"
      "  \"extensionsUsed\": [\"KHR_materials_ior\", \"KHR_materials_pbrSpecularGlossiness\"],\n"
      "  \"scene\": 0,\n  \"scenes\": [{\"nodes\": [" +
      roots + "]}],\n";
  out += list("nodes", nodes) + ",\n" + list("meshes", meshes) + ",\n" + list("materials", materials) + ",\n";
  out += list("textures", texture_items) + ",\n" + list("images", image_items) + ",\n";
  out += list("samplers", {R"({"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497})",
                           R"({"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071})"}) +
         ",\n";
  out +=
      R"(  "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.6, "znear": 0.1, "zfar": 100}}],)"
      "\n";
  out += list("accessors", geometry.accessors) + ",\n" + list("bufferViews", geometry.views) + ",\n";
  out += "  \"buffers\": [{\"uri\": " + json(buffer_name) +
         ", \"byteLength\": " + std::to_string(geometry.buffer.size()) + "}]\n}\n";
  return {std::move(out), std::move(geometry.buffer)};
}

}  // namespace etak::demo
