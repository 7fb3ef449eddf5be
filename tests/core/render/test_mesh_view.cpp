// SPDX-License-Identifier: Apache-2.0
#include "core/render/mesh/mesh_view.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/surface_textures.h"
#include "tests/core/render/ball_mesh.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene metal_scene(std::shared_ptr<const MeshShape> mesh) {
  Scene scene;
  scene.width = 110;
  scene.height = 100;
  scene.surface.f0 = {0.9, 0.6, 0.3};
  scene.surface.diffuse = {0.1, 0.2, 0.3};
  scene.surface.gloss = 0.5;
  scene.specular = find_model("ggx-schlick");
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  scene.diffuse = find_model("lambert");
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.lights = default_lights();
  scene.mesh = std::move(mesh);
  return scene;
}

std::shared_ptr<const MeshShape> fine_sphere() {
  return std::make_shared<const MeshShape>(in_place_of_ball(test::ball_mesh(250, 200), "test"));
}

// The square of --quad at another place and of another size.
Mesh square(float half, float z, const std::array<float, 3>& normal = {0, 0, 1}) {
  Mesh out;
  for (const auto& [x, y] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
    out.vertices.push_back({{half * x, half * y, z}, normal, {0.5f + 0.5f * x, 0.5f - 0.5f * y}});
  out.triangles = {{0, 1, 2}, {0, 2, 3}};
  return out;
}

Image drawn_mesh(const Scene& scene, unsigned threads = 1, Precision precision = Precision::f32) {
  Image out;
  render_cpu(scene, nullptr, threads, precision, out);
  return out;
}

// The largest difference of pixels that the object of both covers wholly, of those near the rim of the ball, where a
// pixel's mean is not its centre, and of the coverage of all.
struct Difference {
  double delta_e = 0, rim_delta_e = 0, coverage = 0;
};
Difference difference(const Image& a, const Image& b) {
  Difference out;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto p = a.at(x, y), q = b.at(x, y);
      out.coverage = std::max(out.coverage, std::abs(double{p[3]} - double{q[3]}));
      if (p[3] < 0.9999f || q[3] < 0.9999f) continue;
      const double off =
          delta_e2000(to_lab(LinearRgb{p[0], p[1], p[2]}), to_lab(LinearRgb{q[0], q[1], q[2]}));
      double& worst = std::hypot(x + 0.5 - a.width / 2.0, y + 0.5 - a.height / 2.0) * 2.2 / a.height < 0.95
                          ? out.delta_e
                          : out.rim_delta_e;
      worst = std::max(worst, off);
    }
  return out;
}

}  // namespace

TEST_CASE("a fine sphere as a mesh is the ball, from any side and in perspective") {
  const auto mesh = fine_sphere();
  for (const bool perspective : {false, true})
    for (const bool turned : {false, true}) {
      Scene scene = metal_scene(mesh), ball = metal_scene(nullptr);
      for (Scene* each : {&scene, &ball}) {
        each->perspective = perspective;
        if (turned) each->view = View{.turn_deg = 40, .rise_deg = -25};
      }
      const Difference off = difference(drawn_mesh(scene), drawn_mesh(ball));
      INFO(perspective << turned << " dE " << off.delta_e << ", rim " << off.rim_delta_e << ", coverage "
                       << off.coverage);
      CHECK(off.delta_e < 0.5);
      CHECK(off.rim_delta_e < 3);
      CHECK(off.coverage < 0.2);  // of 16 samples against a distance
    }
}

TEST_CASE("a textured square as a mesh is the quad, turned too, and from both sides") {
  Image picture(8, 8, 4);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const float values[] = {0.1f * float(x), 0.1f * float(y), 0.5f, 1};
      std::ranges::copy(values, picture.at(x, y).begin());
    }
  Image bumps(8, 8, 4);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const float values[] = {0.06f * float(x) - 0.2f, 0.3f - 0.05f * float(y), 0.9f, 1};
      std::ranges::copy(values, bumps.at(x, y).begin());
    }
  for (const double turn : {0.0, 50.0, 160.0})
    for (const bool perspective : {false, true}) {
      Scene mesh = metal_scene(std::make_shared<const MeshShape>(square(1, 0))), quad = metal_scene(nullptr);
      quad.shape = Shape::quad;
      for (Scene* each : {&mesh, &quad}) {
        each->perspective = perspective;
        each->view = View{.turn_deg = turn, .rise_deg = 10};
        SurfaceTextures textures = *surface_textures({.body = &picture});
        textures.has.normal = turn < 90;
        textures.normal = bumps;
        each->textures = std::make_shared<const SurfaceTextures>(std::move(textures));
        each->texture_scale = {2, 3};
      }
      const Difference off = difference(drawn_mesh(mesh), drawn_mesh(quad));
      INFO(turn << perspective << " dE " << off.delta_e << ", coverage " << off.coverage);
      CHECK(std::max(off.delta_e, off.rim_delta_e) < 0.02);
      CHECK(off.coverage < 0.2);
    }
}

TEST_CASE("what is nearer hides, edges have no holes, and threads and precision change nothing") {
  Mesh both = square(0.5f, 0.25f);
  const Mesh behind = square(0.75f, -0.25f, {0, 0.6f, 0.8f});
  both.vertices.insert(both.vertices.end(), behind.vertices.begin(), behind.vertices.end());
  for (const auto& [a, b, c] : behind.triangles) both.triangles.push_back({a + 4, b + 4, c + 4});
  Scene scene = metal_scene(std::make_shared<const MeshShape>(both)),
        front = metal_scene(std::make_shared<const MeshShape>(square(0.5f, 0.25f)));
  const Image all = drawn_mesh(scene), one = drawn_mesh(front);
  for (int y = 0; y < all.height; ++y)
    for (int x = 0; x < all.width; ++x) {
      if (one.at(x, y)[3] == 1) CHECK(std::ranges::equal(all.at(x, y), one.at(x, y)));
      const double far = std::max(std::abs(x - 54.5), std::abs(y - 49.5)) * 2.2 / 100;
      CHECK(all.at(x, y)[3] == Approx(far < 0.72 ? 1 : far > 0.78 ? 0 : double{all.at(x, y)[3]}));
    }
  for (const unsigned threads : {2u, 7u}) CHECK(drawn_mesh(scene, threads) == all);
  const Image exact = drawn_mesh(scene, 1, Precision::f64);
  CHECK(difference(all, exact).delta_e < 1e-3);
  Image8 codes;
  render_cpu_codes(scene, nullptr, 2, codes);
  CHECK(codes.at(54, 49)[0] == srgb_u8(double{all.at(54, 49)[0]}));
}

TEST_CASE("a mesh takes the place of the ball") {
  const Mesh mesh = in_place_of_ball(square(3, 7), "test");
  for (const Mesh::Vertex& vertex : mesh.vertices) {
    CHECK(std::abs(vertex.position[0]) == Approx(std::sqrt(0.5)));
    CHECK(vertex.position[2] == Approx(0).margin(1e-6));
  }
}

TEST_CASE("a mesh without triangles or without size has no place, and GL and the reference refuse one") {
  CHECK(test::contains(test::error_of([] { in_place_of_ball({}, "a.glb"); }),
                       "a.glb: no triangle of any size"));
  CHECK_THROWS(in_place_of_ball(square(0, 1), "a.glb"));
  CHECK_THROWS(validate(metal_scene(std::make_shared<const MeshShape>(square(1, 0)))));
}

}  // namespace etak
