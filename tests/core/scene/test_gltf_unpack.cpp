// SPDX-License-Identifier: Apache-2.0
#include <draco/compression/encode.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/image/mesh_codecs.h"
#include "core/scene/gltf.h"
#include "tests/core/scene/packed_meshes.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string pixel(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55\0\0\0\nIDATx\x9c\x63\x60\0"
    "\0\0\2\0\1\x48\xaf\xa4\x71\0\0\0\0IEND\xae\x42\x60\x82",
    67);

GltfOptions with_door() {
  GltfOptions out;
  out.mesh_door = mesh_door();
  return out;
}

GltfScene scene_of(const MeshScene& from, const GltfOptions& options) {
  return parse_gltf(glb(from.json.dump(), from.buffer), "s.glb", options);
}

// The triangles of a scene's only use, in an order of their own: UVs of the corners from the least, and the area.
std::vector<std::array<float, 7>> triangles(const GltfScene& scene) {
  REQUIRE(scene.uses.size() == 1);
  std::vector<std::array<float, 7>> out;
  const GltfUse& use = scene.uses[0];
  for (std::size_t i = 0; i < use.world_area.size(); ++i) {
    auto corners = use.uv[0][i];
    std::sort(corners.begin(), corners.end());
    out.push_back({corners[0][0], corners[0][1], corners[1][0], corners[1][1], corners[2][0], corners[2][1],
                   std::round(1e6f * use.world_area[i])});
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string refusal(const MeshScene& scene) {
  return error_of([&] { (void)scene_of(scene, with_door()); });
}

// A pattern of bytes put over the beginning of what is compressed.
MeshScene damaged(MeshScene scene, std::size_t at, const std::string& bytes) {
  scene.buffer.replace(at, bytes.size(), bytes);
  return scene;
}

}  // namespace

TEST_CASE(
    "meshes of meshopt and Draco are the triangles of the uncompressed scene, and are written uncompressed") {
  const GltfScene plain = scene_of(mesh_scene(MeshCoding::plain), {});
  CHECK((triangles(plain).size() == 128 && plain.unpacked.empty()));
  for (const MeshCoding coding : {MeshCoding::meshopt, MeshCoding::draco}) {
    const MeshScene packed = mesh_scene(coding);
    GltfScene scene = scene_of(packed, with_door());
    CHECK(triangles(scene) == triangles(plain));
    CHECK(contains(scene.unpacked, "are written as 4128 bytes"));
    const TempFolder folder;
    spit(folder.file("color.png"), pixel);
    scene.path = folder.file("s.glb");
    const Written written(scene, {}, {folder.path()});
    CHECK_FALSE(written.json.contains("extensionsRequired"));
    CHECK_FALSE(written.json.contains("extensionsUsed"));
    CHECK_FALSE(contains(written.json.dump(), "ompression"));
    CHECK((written.json["buffers"].size() == 1 && written.buffer.size() >= 4128 &&
           written.buffer.size() < 4160));
    CHECK(triangles(written.scene) == triangles(plain));
  }
}

TEST_CASE("where an uncompressed mesh lies beside the compressed one, that is read, without a decoder") {
  MeshScene both = mesh_scene(MeshCoding::plain);
  nlohmann::json& primitive = both.json["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                           {"attributes", {{"POSITION", 0}}}};
  both.json["bufferViews"][1]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  const GltfScene scene = scene_of(both, {});
  CHECK(triangles(scene) == triangles(scene_of(mesh_scene(MeshCoding::plain), {})));
  CHECK_FALSE(contains(write_gltf(scene, {}).json, "ompression"));
}

TEST_CASE("without a decoder compressed meshes are refused in one line that names the extension") {
  for (
      const auto& [coding, line] :
      {std::pair(
           MeshCoding::meshopt,
           "s.glb#/bufferViews/0/extensions/EXT_meshopt_compression: meshes compressed by "
           "EXT_meshopt_compression; expected meshes that are not compressed: there is no decoder here"),
       std::pair(
           MeshCoding::draco,
           "s.glb#/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression: meshes compressed by "
           "KHR_draco_mesh_compression; expected meshes that are not compressed: there is no decoder here")}) {
    const MeshScene scene = mesh_scene(coding);
    CHECK(error_of([&] { (void)scene_of(scene, {}); }) == line);
  }
}

TEST_CASE("streams that lie about their size are refused before memory is asked for") {
  MeshScene vast = mesh_scene(MeshCoding::meshopt);
  nlohmann::json& view = vast.json["bufferViews"][0];
  view["extensions"]["EXT_meshopt_compression"]["count"] = std::size_t{1} << 36;
  CHECK(contains(refusal(vast), "elements of 12 bytes; expected the byteLength of its view, 972"));
  view["byteLength"] = 12 * (std::size_t{1} << 36);
  CHECK(contains(refusal(vast), "at most so much"));
  view["extensions"]["EXT_meshopt_compression"]["count"] = 1 << 20;
  view["byteLength"] = 12 << 20;
  CHECK(contains(refusal(vast), "no more than so many bytes can hold"));

  MeshScene many = mesh_scene(MeshCoding::draco);
  many.json["accessors"][3]["count"] = 3 << 20;
  CHECK(contains(refusal(many), "128 triangles in"));
  many.json["accessors"][3]["count"] = 384;
  many.json["accessors"][1]["count"] = 80;
  CHECK(contains(refusal(many), "81 elements of 2 values in place of 80 of 2"));
}

TEST_CASE("what a stream is not is told in one line") {
  const MeshScene meshopt = mesh_scene(MeshCoding::meshopt), draco = mesh_scene(MeshCoding::draco);
  CHECK(contains(refusal(damaged(meshopt, 0, "\xa1")),
                 "version 1 of meshopt's ATTRIBUTES; expected at most version 0"));
  CHECK(contains(refusal(damaged(meshopt, 0, "\xe0")), "no ATTRIBUTES of meshopt"));
  CHECK(contains(refusal(damaged(draco, 0, "draco")), "no head of a stream"));
  CHECK(contains(refusal(damaged(draco, 5, std::string("\2\1", 2))), "bit stream 2.1"));
  CHECK(contains(refusal(damaged(draco, 7, std::string("\0", 1))), "points without triangles"));
  MeshScene filtered = meshopt;
  filtered.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "COLOR";
  CHECK(contains(refusal(filtered), "\"COLOR\"; expected NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL"));
  filtered.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "QUATERNION";
  CHECK(contains(refusal(filtered), "12 bytes an element of ATTRIBUTES with the filter QUATERNION"));
}

TEST_CASE("streams cut anywhere or changed anywhere give an error or a scene, never a crash") {
  for (const MeshCoding coding : {MeshCoding::meshopt, MeshCoding::draco}) {
    const MeshScene scene = mesh_scene(coding);
    for (std::size_t at = 0; at < scene.buffer.size(); at += 3) {
      const auto flipped = static_cast<char>(scene.buffer[at] ^ (1 << at % 8));
      const std::string why = refusal(damaged(scene, at, std::string(1, flipped)));
      CHECK((why.empty() || why.starts_with("s.glb#/")));
      MeshScene cut = scene;
      std::fill(cut.buffer.begin() + static_cast<std::ptrdiff_t>(at), cut.buffer.end(), '\0');
      const std::string cut_why = refusal(cut);
      CHECK((cut_why.empty() || cut_why.starts_with("s.glb#/")));
    }
  }
}

TEST_CASE("the filters of meshopt give the vectors, turns and numbers that were put in") {
  constexpr std::size_t count = 64;
  std::vector<float> unit(4 * count), numbers(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const float a = 0.1f * static_cast<float>(i);
    const std::array<float, 4> each{std::sin(a) * 0.6f, std::cos(a) * 0.6f, 0.8f, 0};
    std::copy(each.begin(), each.end(), unit.begin() + static_cast<std::ptrdiff_t>(4 * i));
    for (std::size_t c = 0; c < 3; ++c) numbers[3 * i + c] = std::sin(a + static_cast<float>(c));
  }
  const auto decoded = [&](const auto& encoded, std::size_t stride, const char* filter) {
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), encoded.data(), count, stride));
    const std::string text = bytes_of(bytes);
    return mesh_door().meshopt({text, count, stride, "ATTRIBUTES", filter}, "here");
  };
  std::vector<std::int16_t> octahedral(4 * count), turns(4 * count);
  meshopt_encodeFilterOct(octahedral.data(), count, 8, 16, unit.data());
  meshopt_encodeFilterQuat(turns.data(), count, 8, 16, unit.data());
  std::vector<std::uint32_t> exponential(3 * count);
  meshopt_encodeFilterExp(exponential.data(), count, 12, 15, numbers.data());
  const std::string normals = decoded(octahedral, 8, "OCTAHEDRAL"),
                    rotations = decoded(turns, 8, "QUATERNION"),
                    floats = decoded(exponential, 12, "EXPONENTIAL");
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::int16_t, 4> normal{}, turn{};
    std::array<float, 3> number{};
    std::memcpy(normal.data(), normals.data() + 8 * i, 8);
    std::memcpy(turn.data(), rotations.data() + 8 * i, 8);
    std::memcpy(number.data(), floats.data() + 12 * i, 12);
    double same_turn = 0;
    for (std::size_t c = 0; c < 4; ++c) same_turn += turn[c] / 32767.0 * double{unit[4 * i + c]};
    CHECK(std::abs(same_turn) == Approx(1).margin(1e-3));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(normal[c] / 32767.0 == Approx(double{unit[4 * i + c]}).margin(1e-3));
      CHECK(double{number[c]} == Approx(double{numbers[3 * i + c]}).margin(1e-4));
    }
  }
}
