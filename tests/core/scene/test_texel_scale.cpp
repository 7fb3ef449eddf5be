// SPDX-License-Identifier: Apache-2.0
#include "core/scene/texel_scale.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/core/scene/small_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string textured = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";

// The unit square under `node`, looked at by `camera` from z = 5.
GltfScene looked_at(const std::string& node, const std::string& camera) {
  std::string json = quad_json(textured, std::string(two_images) + R"("cameras":[)" + camera + "],");
  return parsed(replaced(
      json, R"("nodes":[{"mesh":0}],)",
      R"("nodes":[{"children":[1,2]},{"mesh":0)" + node + R"(},{"camera":0,"translation":[0.5,0.5,5]}],)"));
}

TexelScale scale_of(const GltfScene& scene, int width, int height, int view) {
  return texel_scale(MaterialUses(scene), 0, *leading_texture(scene.materials[0]), width, height, view);
}

const std::string orthographic =
    R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":0.5,"znear":0.1,"zfar":9}})";
const std::string perspective = R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1}})";

}  // namespace

TEST_CASE("texels per unit are those of the direction that has the fewest") {
  const GltfScene plain = looked_at("", orthographic);
  CHECK(scale_of(plain, 64, 64, 0).least_density == Approx(64));
  CHECK(scale_of(plain, 64, 16, 0).least_density == Approx(16));
  CHECK_FALSE(scale_of(plain, 64, 16, 0).seen);
  // Twice as wide in the world: half as many texels that way.
  CHECK(scale_of(looked_at(R"(,"scale":[2,1,1])", orthographic), 64, 64, 0).least_density == Approx(32));
  // A turn changes nothing.
  const auto turned =
      looked_at(R"(,"rotation":[0.2705980501,0.2705980501,0,0.9238795325],"scale":[2,2,2])", orthographic);
  CHECK(scale_of(turned, 64, 64, 0).least_density == Approx(32).epsilon(1e-5));
}

TEST_CASE("a flat camera sees every texel at one size") {
  // A picture of 100 pixels shows one unit: 100 pixels to 64 texels.
  const TexelScale scale = scale_of(looked_at("", orthographic), 64, 64, 100);
  CHECK(scale.seen);
  CHECK(scale.least_level == Approx(std::log2(0.64)));
  CHECK(scale.most_level == Approx(std::log2(0.64)));
  CHECK(scale_of(looked_at("", orthographic), 64, 256, 100).most_level == Approx(std::log2(2.56)));
}

TEST_CASE("from a camera with perspective the nearest corner counts, and the farthest for mips") {
  const TexelScale scale = scale_of(looked_at("", perspective), 1024, 1024, 100);
  REQUIRE(scale.seen);
  // At the distance 5 a picture of 100 pixels shows 10 tan(1/2) units.
  const double middle = std::log2(1024 / (100 / (10 * std::tan(0.5))));
  CHECK(scale.least_level < middle);
  CHECK(scale.least_level > middle - 1);
  CHECK(scale.most_level > middle);
  CHECK(scale.most_level < middle + 0.5);
  // Ten times as far: log2(10) levels more, about.
  const TexelScale far = scale_of(looked_at(R"(,"translation":[0,0,-45])", perspective), 1024, 1024, 100);
  CHECK(far.most_level - scale.most_level == Approx(std::log2(10)).margin(0.3));
}

TEST_CASE("what lies behind every camera is not seen, and what reads one point has no density") {
  CHECK_FALSE(scale_of(looked_at(R"(,"translation":[0,0,9])", perspective), 64, 64, 100).seen);
  std::string json = quad_json(textured, std::string(two_images));
  const std::string point = "\"uri\":\"data:;base64," + base64(quad_buffer({0, 0, 0, 0, 0, 0, 0, 0})) + "\",";
  const GltfScene scene = parsed(replaced(json, R"("uri":"quad.bin",)", point));
  CHECK(scale_of(scene, 64, 64, 0).least_density == 0);
}
