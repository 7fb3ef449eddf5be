// SPDX-License-Identifier: Apache-2.0
#include "tests/core/scene/packed_meshes.h"

#include <draco/compression/encode.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/core/scene/small_scene.h"

namespace etak::test {
namespace {

constexpr int grid_side = 9;
constexpr std::size_t vertices = grid_side * grid_side;

struct Grid {
  std::vector<float> positions, uvs, normals;
  std::vector<std::uint32_t> indices;
};

Grid grid() {
  Grid out;
  for (int y = 0; y < grid_side; ++y)
    for (int x = 0; x < grid_side; ++x) {
      const float u = static_cast<float>(x) / (grid_side - 1), v = static_cast<float>(y) / (grid_side - 1);
      out.positions.insert(out.positions.end(), {u, v, 0.1f * std::sin(7 * u) * std::cos(5 * v)});
      out.uvs.insert(out.uvs.end(), {0.25f + 0.5f * u, 0.125f + 0.3f * v});
      out.normals.insert(out.normals.end(), {0.6f * u, 0.6f * v, std::sqrt(1 - 0.36f * (u * u + v * v))});
    }
  for (std::uint32_t y = 0; y + 1 < grid_side; ++y)
    for (std::uint32_t x = 0; x + 1 < grid_side; ++x) {
      const std::uint32_t a = y * grid_side + x;
      for (const std::uint32_t corner : {a, a + 1, a + grid_side + 1, a, a + grid_side + 1, a + grid_side})
        out.indices.push_back(corner);
    }
  return out;
}

std::string of_vertices(const std::vector<float>& numbers) {
  const std::size_t size = 4 * numbers.size() / vertices;
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(vertices, size));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), numbers.data(), vertices, size));
  return bytes_of(out);
}

std::string of_triangles(const std::vector<std::uint32_t>& indices) {
  std::vector<unsigned char> out(meshopt_encodeIndexBufferBound(indices.size(), vertices));
  out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
  return bytes_of(out);
}

// An attribute of floats that are stored as they are, since no quantisation is asked for.
void add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type,
                   const std::vector<float>& numbers) {
  const auto components = static_cast<std::int8_t>(numbers.size() / vertices);
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, components, draco::DT_FLOAT32, false, 4 * components, 0);
  const int id = mesh.AddAttribute(attribute, true, vertices);
  for (std::size_t i = 0; i < vertices; ++i)
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(static_cast<std::uint32_t>(i)),
                                          &numbers[i * static_cast<std::size_t>(components)]);
}

std::string of_mesh(const Grid& grid) {
  draco::Mesh mesh;
  mesh.set_num_points(vertices);
  for (std::size_t i = 0; i < grid.indices.size(); i += 3)
    mesh.AddFace({draco::PointIndex(grid.indices[i]), draco::PointIndex(grid.indices[i + 1]),
                  draco::PointIndex(grid.indices[i + 2])});
  add_attribute(mesh, draco::GeometryAttribute::POSITION, grid.positions);
  add_attribute(mesh, draco::GeometryAttribute::TEX_COORD, grid.uvs);
  add_attribute(mesh, draco::GeometryAttribute::NORMAL, grid.normals);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  draco::EncoderBuffer out;
  if (!encoder.EncodeMeshToBuffer(mesh, &out).ok()) return {};
  return {out.data(), out.size()};
}

nlohmann::json document() {
  return nlohmann::json::parse(
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"NORMAL":2},"indices":3,"material":0}]}],
"accessors":[{"componentType":5126,"count":81,"type":"VEC3"},
{"componentType":5126,"count":81,"type":"VEC2"},{"componentType":5126,"count":81,"type":"VEC3"},
{"componentType":5125,"count":384,"type":"SCALAR"}],
"materials":[{"name":"m","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":"color.png"}]})");
}

}  // namespace

MeshScene mesh_scene(MeshCoding coding) {
  const Grid g = grid();
  MeshScene out{document(), {}};
  nlohmann::json& json = out.json;
  for (std::size_t c = 0; c < 3; ++c) {
    double least = 1, most = 0;
    for (std::size_t i = c; i < g.positions.size(); i += 3) {
      least = std::min(least, double{g.positions[i]});
      most = std::max(most, double{g.positions[i]});
    }
    json["accessors"][0]["min"].push_back(least);
    json["accessors"][0]["max"].push_back(most);
  }
  const auto put = [&](const std::string& bytes) {
    out.buffer.resize((out.buffer.size() + 3) / 4 * 4);
    const std::size_t at = out.buffer.size();
    out.buffer += bytes;
    return at;
  };
  const std::vector<std::string> plain{bytes_of(g.positions), bytes_of(g.uvs), bytes_of(g.normals),
                                       bytes_of(g.indices)};
  const std::vector<std::string> packed{of_vertices(g.positions), of_vertices(g.uvs), of_vertices(g.normals),
                                        of_triangles(g.indices)};
  std::size_t fallback = 0;
  for (std::size_t i = 0; i < 4 && coding != MeshCoding::draco; ++i) {
    const bool is_indices = i == 3;
    nlohmann::json view{
        {"buffer", 0}, {"byteLength", plain[i].size()}, {"target", is_indices ? 34963 : 34962}};
    if (coding == MeshCoding::meshopt) {
      view["buffer"] = 1;
      view["byteOffset"] = fallback;
      fallback += plain[i].size();
      const std::size_t stride = is_indices ? 4 : plain[i].size() / vertices;
      view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                       {"byteOffset", put(packed[i])},
                                                       {"byteLength", packed[i].size()},
                                                       {"byteStride", stride},
                                                       {"count", plain[i].size() / stride},
                                                       {"mode", is_indices ? "TRIANGLES" : "ATTRIBUTES"}};
    } else {
      view["byteOffset"] = put(plain[i]);
    }
    json["bufferViews"].push_back(view);
    json["accessors"][i]["bufferView"] = i;
  }
  if (coding == MeshCoding::draco) {
    const std::string mesh = of_mesh(g);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", put(mesh)}, {"byteLength", mesh.size()}});
    json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", 0}, {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"NORMAL", 2}}}};
  }
  const char* const name =
      coding == MeshCoding::draco ? "KHR_draco_mesh_compression" : "EXT_meshopt_compression";
  if (coding != MeshCoding::plain) json["extensionsUsed"] = json["extensionsRequired"] = {name};
  json["buffers"].push_back({{"byteLength", out.buffer.size()}});
  if (coding == MeshCoding::meshopt)
    json["buffers"].push_back({{"byteLength", fallback}, {"extensions", {{name, {{"fallback", true}}}}}});
  return out;
}

}  // namespace etak::test
