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
  std::string views, accessors;
};

Geometry geometry() {
  const SphereMesh mesh = sphere_mesh(slices, stacks);
  Geometry out;
  std::size_t begin = 0;
  const auto end_view = [&](int target) {
    append(out.views, begin == 0 ? "\n" : ",\n",
           "    {\"buffer\": 0, \"byteOffset\": ", std::to_string(begin),
           ", \"byteLength\": ", std::to_string(out.buffer.size() - begin),
           ", \"target\": ", std::to_string(target), "}");
    while (out.buffer.size() % 4 != 0) out.buffer.push_back('\0');
    begin = out.buffer.size();
  };
  constexpr int vertices = 34962, indices = 34963;
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
  const std::string count = std::to_string(mesh.points.size());
  out.accessors = "\n    {\"bufferView\": 0, \"componentType\": 5123, \"count\": " +
                  std::to_string(mesh.triangles.size()) + ", \"type\": \"SCALAR\"},\n" +
                  "    {\"bufferView\": 1, \"componentType\": 5126, \"count\": " + count +
                  ", \"type\": \"VEC3\", \"min\": " + json_array_of(least) +
                  ", \"max\": " + json_array_of(most) + "},\n" +
                  "    {\"bufferView\": 2, \"componentType\": 5126, \"count\": " + count +
                  ", \"type\": \"VEC2\"}";
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
  for (const Change& change : changes) lines.push_back(json(one_line(change)));
  std::vector<std::string> notes;
  for (const std::string& note : s.notes) notes.push_back(json(note));
  std::vector<JsonMember> members{{"f0_linear_srgb", three(s.f0)}};
  if (!s.gloss.held()) members.push_back({"schueler_gloss", json(double{s.gloss})});
  if (s.f82) members.push_back({"f82_linear_srgb", three(*s.f82)});
  if (!s.source.empty()) members.push_back({"source", json(s.source)});
  if (!notes.empty()) members.push_back({"notes", json_array(notes)});
  if (!changes.empty()) members.push_back({"changes", json_array(lines)});
  return json_object(members, 6);
}

// A body with absorption is as thick as the depth that its colour is told for, so that it shows that colour;
// else as thick as the sphere, which then only bends the light.
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
    extensions.push_back({"KHR_materials_pbrSpecularGlossiness",
                          json_object(std::array{JsonMember{"diffuseFactor", four(v.base_color, v.opacity)},
                                                 JsonMember{"specularFactor", three(v.specular_color)},
                                                 JsonMember{"glossinessFactor", json(v.glossiness)}},
                                      -1)});
  } else {
    members.push_back({"pbrMetallicRoughness",
                       json_object(std::array{JsonMember{"baseColorFactor", four(v.base_color, v.opacity)},
                                              JsonMember{"metallicFactor", json(v.metallic)},
                                              JsonMember{"roughnessFactor", json(v.roughness)}},
                                   -1)});
    if (v.metallic == 0) {
      used.ior = true;
      extensions.push_back(
          {"KHR_materials_ior", json_object(std::array{JsonMember{"ior", json(v.ior)}}, -1)});
      if (v.specular_color != LinearRgb{1, 1, 1}) {
        used.specular = true;
        extensions.push_back(
            {"KHR_materials_specular",
             json_object(std::array{JsonMember{"specularColorFactor", three(v.specular_color)}}, -1)});
      }
      if (v.transmission > 0) {
        used.transmission = true;
        extensions.push_back(
            {"KHR_materials_transmission",
             json_object(std::array{JsonMember{"transmissionFactor", json(v.transmission)}}, -1)});
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
  std::string materials, meshes, nodes, roots;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ExportSurface& s = surfaces[i];
    validate(s);
    if (s.space != RgbSpace::srgb)
      throw Error::at(s.id, "colours in " + std::string(name(s.space)), "linear sRGB");
    const char* const comma = i == 0 ? "\n    " : ",\n    ";
    const std::string index = std::to_string(i);
    append(materials, comma, material_of(s, form, fit, used, changes[i]));
    append(meshes, comma, "{\"name\": ", json(s.id),
           ", \"primitives\": [{\"attributes\": {\"POSITION\": 1, \"NORMAL\": 1, \"TEXCOORD_0\": 2}, "
           "\"indices\": 0, "
           "\"material\": ",
           index, "}]}");
    append(nodes, comma, "{\"name\": ", json(s.id), ", \"mesh\": ", index);
    if (i > 0) append(nodes, ", \"translation\": [", json(spacing * static_cast<double>(i)), ", 0, 0]");
    nodes += '}';
    append(roots, i == 0 ? "" : ", ", index);
  }
  std::vector<std::string> names;
  if (used.ior) names.push_back(json("KHR_materials_ior"));
  if (used.specular) names.push_back(json("KHR_materials_specular"));
  if (used.transmission) {
    names.push_back(json("KHR_materials_transmission"));
    names.push_back(json("KHR_materials_volume"));
  }
  if (used.glossiness) names.push_back(json("KHR_materials_pbrSpecularGlossiness"));

  const Geometry sphere = geometry();
  std::string out = "{\n  \"asset\": {\"version\": \"2.0\", \"generator\": \"etak\"},\n";
  if (!names.empty()) append(out, "  \"extensionsUsed\": ", json_array(names), ",\n");
  append(out, "  \"scene\": 0,\n  \"scenes\": [{\"nodes\": [", roots, "]}],\n  \"nodes\": [", nodes,
         "\n  ],\n  \"meshes\": [", meshes, "\n  ],\n  \"materials\": [", materials,
         "\n  ],\n  \"accessors\": [", sphere.accessors, "\n  ],\n  \"bufferViews\": [", sphere.views,
         "\n  ],\n  \"buffers\": [{");
  if (container == GltfContainer::gltf)
    append(out, "\"uri\": \"data:application/octet-stream;base64,", base64(sphere.buffer), "\", ");
  append(out, "\"byteLength\": ", std::to_string(sphere.buffer.size()), "}]\n}\n");
  return container == GltfContainer::gltf ? out : glb(std::move(out), sphere.buffer);
}

}  // namespace etak
