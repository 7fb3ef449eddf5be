// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes/base64.h"
#include "core/scene/gltf.h"

namespace etak::test {

/// Bytes of numbers, one behind the other.
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string out(numbers.size() * sizeof(Number), '\0');
  std::memcpy(out.data(), numbers.data(), out.size());
  return out;
}

/// A unit square of two triangles at z = 0 with these UVs at (0,0), (1,0), (1,1), (0,1) of the plane.
/// Views and accessors: 0 positions, 1 UVs, 2 indices (u16).
inline std::string quad_buffer(const std::vector<float>& uvs) {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + bytes_of<float>(uvs) +
         bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
}
inline std::string unit_quad() {
  return quad_buffer({0, 0, 1, 0, 1, 1, 0, 1});
}

/// Puts `with` in place of the first `what`; for documents that differ in one thing.
inline std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const auto at = text.find(what);
  return at == text.npos ? "MISSING " + std::string(what) : text.replace(at, what.size(), with);
}

inline constexpr std::string_view quad_accessors = R"("accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},
{"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],)";
inline constexpr std::string_view quad_views = R"("bufferViews":[
{"buffer":0,"byteOffset":0,"byteLength":48,"target":34962},
{"buffer":0,"byteOffset":48,"byteLength":32,"target":34962},
{"buffer":0,"byteOffset":80,"byteLength":12,"target":34963}],)";

/// A document of one such square; `materials` is the array of materials, `rest` more members with a comma
/// behind.
inline std::string quad_json(const std::string& materials, const std::string& rest = "",
                             const std::string& uri = R"("uri":"quad.bin",)") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + rest +
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)" +
         std::string(quad_accessors) + std::string(quad_views) + R"("buffers":[{)" + uri +
         R"("byteLength":92}],"materials":)" + materials + "}";
}

inline constexpr std::string_view two_images = R"("images":[{"uri":"a.png"},{"uri":"b.png"}],
"samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728,"minFilter":9729}],
"textures":[{"source":0},{"source":1,"sampler":0}],)";

/// The binary form of a document.
inline std::string glb(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const auto word = [](std::size_t n) { return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(n)}); };
  const std::string chunks =
      word(json.size()) + "JSON" + json + word(binary.size()) + std::string("BIN\0", 4) + binary;
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

/// The scene of such a document, named s.gltf, whose buffer "quad.bin" is that of a unit square.
inline GltfScene parsed(const std::string& json, const GltfOptions& options = {}) {
  const std::string inside = "\"uri\":\"data:application/octet-stream;base64," + base64(unit_quad()) + "\",";
  return parse_gltf(
      json.find("quad.bin") == json.npos ? json : replaced(json, R"("uri":"quad.bin",)", inside), "s.gltf",
      options);
}

}  // namespace etak::test
