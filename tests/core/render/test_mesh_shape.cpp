// SPDX-License-Identifier: Apache-2.0
#include "core/render/mesh/mesh_shape.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "core/render/cpu_renderer.h"
#include "tests/core/render/ball_mesh.h"
#include "tests/support.h"

namespace etak {
namespace {

// A square of two triangles: its middle, half of two sides, and its normal.
void add_square(Mesh& mesh, const Vec3& middle, const Vec3& along, const Vec3& across, const Vec3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    Mesh::Vertex vertex{};
    for (std::size_t i = 0; i < 3; ++i) {
      vertex.position[i] = static_cast<float>(middle[i] + x * along[i] + y * across[i]);
      vertex.normal[i] = static_cast<float>(normal[i]);
    }
    mesh.vertices.push_back(vertex);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

// A floor at y = 0 and a smaller roof one unit above its middle.
Mesh floor_and_roof() {
  Mesh out;
  add_square(out, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  add_square(out, {0, 1, 0}, {0.3, 0, 0}, {0, 0, 0.3}, {0, 1, 0});
  return out;
}

Scene white_scene(std::shared_ptr<const MeshShape> mesh) {
  Scene scene;
  scene.width = scene.height = 101;
  scene.diffuse = find_model("lambert");
  scene.surface.diffuse = {0.8, 0.8, 0.8};
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.lights = {};
  scene.mesh = std::move(mesh);
  scene.view = View{.turn_deg = 0, .rise_deg = 60};
  return scene;
}

Image drawn(const Scene& scene) {
  Image out;
  render_cpu(scene, nullptr, 2, Precision::f32, out);
  return out;
}

}  // namespace

TEST_CASE("a ball as a mesh keeps no light from itself, and the ground below it has the ball's shadow") {
  const MeshShape ball(test::ball_mesh(128, 64), 2);
  for (std::size_t i = 0; i < ball.mesh().vertices.size(); ++i) REQUIRE(ball.open(i, false) == 1);
  CHECK(ball.ground() == Approx(-1));
  for (const double r : {0.0, 0.3, 0.7, 1.0, 2.0, 6.0}) {
    const double expected = 1 - std::pow(1 + r * r, -1.5);
    INFO(r << ": " << ball.ground_light(r, 0) << ", a ball's " << expected);
    CHECK(ball.ground_light(r, 0) == Approx(expected).margin(0.02));
    CHECK(ball.ground_light(-0.6 * r, 0.8 * r) == Approx(expected).margin(0.02));
  }
}

TEST_CASE("a roof hides what is above it and nothing beside it") {
  const MeshShape shape(floor_and_roof(), 1);
  const Vec3 up{0, 1, 0}, slanted{std::sqrt(0.5), std::sqrt(0.5), 0};
  CHECK(shape.hides({0, 0, 0}, up, 1e9));
  CHECK(shape.hides({0.29, 0, -0.29}, up, 1e9));
  CHECK_FALSE(shape.hides({0.31, 0, 0}, up, 1e9));
  CHECK_FALSE(shape.hides({0, 0, 0}, slanted, 1e9));
  CHECK(shape.hides({-1, 0, 0}, slanted, 1e9));
  CHECK_FALSE(shape.hides({0, 0, 0}, up, 0.9));  // a light below the roof
}

TEST_CASE("half of the sky is open beside a high wall") {
  Mesh mesh;
  add_square(mesh, {1, 0, 0}, {0.95, 0, 0}, {0, 0, 5}, {0, 1, 0});
  add_square(mesh, {0, 50, 0}, {0, 50, 0}, {0, 0, 80}, {1, 0, 0});
  mesh.vertices.push_back({{0.05f, 0, 0}, {0, 1, 0}});
  const MeshShape shape(std::move(mesh), 1);
  CHECK(shape.open(8, false) == Approx(0.5).margin(0.03));
}

TEST_CASE("a roof's shadow lies on the floor in the light of a lamp, and softly in that of an area") {
  const auto roof = std::make_shared<const MeshShape>(floor_and_roof(), 1);
  Mesh alone;
  add_square(alone, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  const auto bare = std::make_shared<const MeshShape>(std::move(alone), 1);
  Light sun;
  sun.kind = LightKind::directional;
  const double slope = std::sqrt(0.5);
  sun.direction = {0, -slope, -slope};  // the shadow lies behind the roof
  Light area;
  area.kind = LightKind::rectangle;
  area.position = {0, 3, 0};
  area.direction = {0, -1, 0};
  area.width = area.height = 1;
  area.up = {0, 0, 1};
  for (const Light& light : {sun, area}) {
    Scene shaded = white_scene(roof), lit = white_scene(bare);
    for (Scene* each : {&shaded, &lit}) {
      each->refined = true;
      each->lights.lights = {light};
    }
    const Image a = drawn(shaded), b = drawn(lit);
    int dark = 0, half = 0;
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        if (b.at(x, y)[3] < 1) continue;
        const float share = a.at(x, y)[0] / b.at(x, y)[0];
        if (share == 0) ++dark;
        if (share > 0.05f && share < 0.95f) ++half;
      }
    INFO(dark << " dark, " << half << " half");
    CHECK(dark > 20);
    if (light.kind == LightKind::rectangle) CHECK(half > 100);
  }
}

TEST_CASE("the shadows of a mesh are the same for any number of threads") {
  const MeshShape one(shader_ball(), 1), many(shader_ball(), 5);
  for (std::size_t i = 0; i < one.mesh().vertices.size(); ++i)
    REQUIRE(one.open(i, true) == many.open(i, true));
  for (double x = -2; x < 2; x += 0.37) CHECK(one.ground_light(x, 0.3) == many.ground_light(x, 0.3));
}

TEST_CASE("the shader ball is closed, its normals point outwards, and its groove is darker than its ball") {
  const Mesh mesh = shader_ball();
  const MeshShape shape(mesh, 2);
  double volume = 0, darkest = 1;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = widened(mesh.vertices[a].position), q = widened(mesh.vertices[b].position),
               r = widened(mesh.vertices[c].position);
    volume += dot(p, cross(q, r)) / 6;
  }
  CHECK(volume > 1);  // triangles turn counter-clockwise, seen from outside
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Mesh::Vertex& vertex = mesh.vertices[i];
    CHECK(dot(widened(vertex.normal), widened(vertex.normal)) == Approx(1).margin(1e-5));
    darkest = std::min(darkest, double{shape.open(i, false)});
  }
  CHECK(darkest < 0.6);
  CHECK(shape.ground() < -0.8);
}

}  // namespace etak
