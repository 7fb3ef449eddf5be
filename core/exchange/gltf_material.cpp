// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/gltf_material.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/base64.h"
#include "core/base/bytes_le.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/exchange/engine_values.h"
#include "core/math/sphere_mesh.h"

namespace etak {
namespace {

// ---- the sphere

constexpr int slices = 48, stacks = 24;
constexpr double spacing = 2.4;

// The buffer: indices, normals (as positions too), UVs; each begins at a multiple of four.
struct Geometry {
  std::string buffer;
  std::vector<std::string> views, accessors;  // JSON
};

// What a glTF file calls the types of components and the uses of a buffer view.
constexpr std::size_t unsigned_short = 5123, single_float = 5126;
constexpr std::size_t vertices = 34962, indices = 34963;

std::string line_object(std::initializer_list<JsonMember> members) {
  return json_object(members, -1);
}

Geometry geometry() {
  const SphereMesh mesh = sphere_mesh(slices, stacks);
  Geometry out;
  std::size_t begin = 0;
  const auto end_view = [&](std::size_t target) {
    out.views.push_back(line_object({{"buffer", "0"},
                                     {"byteOffset", json(begin)},
                                     {"byteLength", json(out.buffer.size() - begin)},
                                     {"target", json(target)}}));
    while (out.buffer.size() % 4 != 0) out.buffer.push_back('\0');
    begin = out.buffer.size();
  };
  for (const std::uint16_t index : mesh.triangles) bytes_le::append(out.buffer, index, 2);
  end_view(indices);
  std::array<float, 3> least{}, most{};
  for (const auto& point : mesh.points)
    for (std::size_t c = 0; c < 3; ++c) {
      bytes_le::append_float(out.buffer, point[c]);
      least[c] = std::min(least[c], point[c]);
      most[c] = std::max(most[c], point[c]);
    }
  end_view(vertices);
  for (const auto& uv : mesh.uvs)
    for (const float c : uv) bytes_le::append_float(out.buffer, c);
  end_view(vertices);
  out.accessors = {line_object({{"bufferView", "0"},
                                {"componentType", json(unsigned_short)},
                                {"count", json(mesh.triangles.size())},
                                {"type", json("SCALAR")}}),
                   line_object({{"bufferView", "1"},
                                {"componentType", json(single_float)},
                                {"count", json(mesh.points.size())},
                                {"type", json("VEC3")},
                                {"min", json_array_of(least)},
                                {"max", json_array_of(most)}}),
                   line_object({{"bufferView", "2"},
                                {"componentType", json(single_float)},
                                {"count", json(mesh.points.size())},
                                {"type", json("VEC2")}})};
  return out;
}

// ---- the materials

std::string three(const LinearRgb& c) {
  return json_array_of(std::array{c.r, c.g, c.b});
}

std::string four(const LinearRgb& c, double alpha) {
  return json_array_of(std::array{c.r, c.g, c.b, alpha});
}

std::string extras_of(const ExportSurface& s, const Changes& changes) {
  std::vector<std::string> lines;
  for (const Change& change : changes) lines.push_back(one_line(change));
  std::vector<JsonMember> members{{"f0_linear_srgb", three(s.f0)}};
  if (!s.gloss.held()) members.push_back({"schueler_gloss", json(double{s.gloss})});
  if (s.f82) members.push_back({"f82_linear_srgb", three(*s.f82)});
  if (!s.source.empty()) members.push_back({"source", json(s.source)});
  if (!s.notes.empty()) members.push_back({"notes", json_array_of(s.notes)});
  if (!changes.empty()) members.push_back({"changes", json_array_of(lines)});
  return json_object(members, 6);
}

// A body with absorption is as thick as the depth for which its colour is stated, so that it shows that
// colour; otherwise it is as thick as the sphere and only bends the light.
std::vector<JsonMember> volume_of(const ClearBody& body) {
  constexpr double diameter = 2;
  if (body.depth_m <= 0) return {{"thicknessFactor", json(diameter)}};
  return {{"thicknessFactor", json(body.depth_m)},
          {"attenuationColor", three(body.color)},
          {"attenuationDistance", json(body.depth_m)}};
}

struct Used {
  bool ior = false, specular = false, glossiness = false, transmission = false;
};

std::string material_of(const ExportSurface& s, GltfMaterialForm form, Fit fit, Used& used,
                        Changes& changes) {
  const GltfMaterialValues v = gltf_values(s, form == GltfMaterialForm::specular_glossiness, fit, changes);
  std::vector<JsonMember> members{{"name", json(s.name.empty() ? s.id : s.name)}};
  std::vector<JsonMember> extensions;
  if (v.specular_glossiness) {
    used.glossiness = true;
    extensions.push_back(
        {"KHR_materials_pbrSpecularGlossiness", line_object({{"diffuseFactor", four(v.base_color, v.opacity)},
                                                             {"specularFactor", three(v.specular_color)},
                                                             {"glossinessFactor", json(v.glossiness)}})});
  } else {
    members.push_back(
        {"pbrMetallicRoughness", line_object({{"baseColorFactor", four(v.base_color, v.opacity)},
                                              {"metallicFactor", json(v.metallic)},
                                              {"roughnessFactor", json(v.roughness)}})});
    if (v.metallic == 0) {
      used.ior = true;
      extensions.push_back({"KHR_materials_ior", line_object({{"ior", json(v.ior)}})});
      if (v.specular_color != LinearRgb{1, 1, 1}) {
        used.specular = true;
        extensions.push_back(
            {"KHR_materials_specular", line_object({{"specularColorFactor", three(v.specular_color)}})});
      }
      if (v.transmission > 0) {
        used.transmission = true;
        extensions.push_back(
            {"KHR_materials_transmission", line_object({{"transmissionFactor", json(v.transmission)}})});
        extensions.push_back({"KHR_materials_volume", json_object(volume_of(*v.volume), -1)});
      }
    }
  }
  if (s.opacity < 1) members.push_back({"alphaMode", json("BLEND")});
  if (!extensions.empty()) members.push_back({"extensions", json_object(extensions, 6)});
  members.push_back({"extras", extras_of(s, changes)});
  return json_object(members, 4);
}

// ---- the file

// The unit sphere of surface i.
std::string mesh_of(const ExportSurface& s, std::size_t i) {
  const std::string primitive =
      line_object({{"attributes", line_object({{"POSITION", "1"}, {"NORMAL", "1"}, {"TEXCOORD_0", "2"}})},
                   {"indices", "0"},
                   {"material", json(i)}});
  return line_object({{"name", json(s.id)}, {"primitives", '[' + primitive + ']'}});
}

std::string node_of(const ExportSurface& s, std::size_t i) {
  std::vector<JsonMember> members{{"name", json(s.id)}, {"mesh", json(i)}};
  const std::array<double, 3> place{spacing * static_cast<double>(i), 0, 0};
  if (i > 0) members.push_back({"translation", json_array_of(place)});
  return json_object(members, -1);
}

std::string buffer_of(const Geometry& sphere, GltfContainer container) {
  std::vector<JsonMember> members;
  if (container == GltfContainer::gltf)
    members.push_back({"uri", json("data:application/octet-stream;base64," + base64(sphere.buffer))});
  members.push_back({"byteLength", json(sphere.buffer.size())});
  return json_object(members, -1);
}

std::vector<std::string> extensions_of(const Used& used) {
  std::vector<std::string> names;
  if (used.ior) names.push_back("KHR_materials_ior");
  if (used.specular) names.push_back("KHR_materials_specular");
  if (used.transmission) names.insert(names.end(), {"KHR_materials_transmission", "KHR_materials_volume"});
  if (used.glossiness) names.push_back("KHR_materials_pbrSpecularGlossiness");
  return names;
}

std::string glb(std::string json_chunk, std::string_view binary) {
  while (json_chunk.size() % 4 != 0) json_chunk.push_back(' ');
  std::string out = "glTF";
  bytes_le::append32(out, 2);
  bytes_le::append32(out, 12 + 8 + json_chunk.size() + 8 + binary.size());
  bytes_le::append32(out, json_chunk.size());
  out += "JSON";
  out += json_chunk;
  bytes_le::append32(out, binary.size());
  out.append("BIN\0", 4);
  return out.append(binary);
}

}  // namespace

std::string gltf_document(std::span<const ExportSurface> surfaces, GltfMaterialForm form,
                          GltfContainer container, Fit fit, std::vector<Changes>& changes) {
  if (surfaces.empty()) throw Error::at("glTF", "no material", "one or more");
  changes.assign(surfaces.size(), {});
  Used used;
  std::vector<std::string> materials, meshes, nodes;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ExportSurface& s = surfaces[i];
    validate(s);
    if (s.space != RgbSpace::srgb)
      throw Error::at(s.id, "colours in " + std::string(name(s.space)), "linear sRGB");
    materials.push_back(material_of(s, form, fit, used, changes[i]));
    meshes.push_back(mesh_of(s, i));
    nodes.push_back(node_of(s, i));
    roots.push_back(i);
  }

  const Geometry sphere = geometry();
  std::vector<JsonMember> members{
      {"asset", line_object({{"version", json("2.0")}, {"generator", json("etak")}})}};
  const std::vector<std::string> extensions = extensions_of(used);
  if (!extensions.empty()) members.push_back({"extensionsUsed", json_array_of(extensions)});
  members.insert(members.end(), {{"scene", "0"},
                                 {"scenes", '[' + line_object({{"nodes", json_array_of(roots)}}) + ']'},
                                 {"nodes", json_lines(nodes, 2)},
                                 {"meshes", json_lines(meshes, 2)},
                                 {"materials", json_lines(materials, 2)},
                                 {"accessors", json_lines(sphere.accessors, 2)},
                                 {"bufferViews", json_lines(sphere.views, 2)},
                                 {"buffers", '[' + buffer_of(sphere, container) + ']'}});
  std::string out = json_object(members, 0) + '\n';
  return container == GltfContainer::gltf ? out : glb(std::move(out), sphere.buffer);
}

}  // namespace etak
