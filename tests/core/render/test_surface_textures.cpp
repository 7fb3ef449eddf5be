// SPDX-License-Identifier: Apache-2.0
#include "core/render/surface_textures.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/light/studio.h"
#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/reference.h"
#include "core/render/view_state.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene lit_scene(const char* model) {
  Scene scene;
  scene.width = scene.height = 40;
  scene.surface.f0 = {0.95, 0.64, 0.54};
  scene.surface.diffuse = {0.2, 0.1, 0.3};
  scene.surface.gloss = 0.8;
  complete_from_f0(scene.surface);
  scene.specular = find_model(model);
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  scene.diffuse = find_model("lambert");
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.lights = default_lights();
  scene.lights.environment = "studio";
  return scene;
}

Image filled(int width, int height, const std::vector<float>& texel) {
  Image out(width, height, static_cast<int>(texel.size()));
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = texel[i % texel.size()];
  return out;
}

float largest_gap(const Image& a, const Image& b) {
  float out = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) out = std::max(out, std::abs(a.values[i] - b.values[i]));
  return out;
}

}  // namespace

TEST_CASE("textures of one emission and of one occlusion are the numbers: moving, refined and reference") {
  const Environment studio(environment_picture(*find_studio("studio"), 64), 1, "studio", 2);
  const Image emission = filled(3, 2, {0.5F, 0.25F, 2}), occlusion = filled(1, 4, {0.5F});
  for (const bool emits : {true, false})
    for (const bool occluded : {true, false}) {
      Scene numbers = lit_scene("ggx-schlick"), textured = numbers;
      if (emits) {
        numbers.surface.emission = {0.4, 0.05, 1};
        textured.surface.emission = {0.8, 0.2, 0.5};
      }
      if (occluded) numbers.surface.occlusion = 0.4, textured.surface.occlusion = 0.8;
      textured.textures = surface_textures(
          {.emission = emits ? &emission : nullptr, .occlusion = occluded ? &occlusion : nullptr});
      for (const bool refined : {false, true}) {
        numbers.refined = textured.refined = refined;
        Image expected, got;
        render_cpu(numbers, &studio, 2, Precision::f64, expected);
        render_cpu(textured, &studio, 2, Precision::f64, got);
        INFO("emits " << emits << ", occluded " << occluded << ", refined " << refined);
        CHECK(largest_gap(expected, got) < 1e-5F);
      }
      const ReferenceOptions options{2, 4, 2};
      CHECK(largest_gap(render_reference(numbers, &studio, options).picture,
                        render_reference(textured, &studio, options).picture) < 1e-5F);
    }
}

TEST_CASE("emission and occlusion lie where the texture has them, in every kind of picture") {
  Image emission(2, 1, 3), occlusion(2, 1, 1, 1);
  emission.at(0, 0)[0] = 1;   // red at the left
  occlusion.at(1, 0)[0] = 0;  // no light from all around at the right
  Scene scene = lit_scene("ggx-schlick");
  scene.shape = Shape::quad;
  scene.surface.emission = {3, 3, 3};
  scene.lights.lights.clear();
  scene.lights.environment.clear();
  scene.textures = surface_textures({.emission = &emission, .occlusion = &occlusion});
  Image quick;
  render_cpu(scene, nullptr, 1, Precision::f64, quick);
  for (const Image& picture : {quick, render_reference(scene, nullptr, {1, 16, 1}).picture}) {
    CHECK(picture.at(6, 20)[0] > 3);
    CHECK(picture.at(6, 20)[1] > 0.01F);
    CHECK(picture.at(33, 20)[0] == 0);
    CHECK(picture.at(33, 20)[1] == 0);
  }
}

TEST_CASE("emission and occlusion of two sizes become one texture of the larger size") {
  Image emission(2, 1, 3);
  emission.at(1, 0)[2] = 8;
  const Image occlusion = filled(1, 3, {0.25F});
  const Image both = emission_texture(&emission, &occlusion);
  CHECK(both.width == 2);
  CHECK(both.height == 3);
  for (int y = 0; y < 3; ++y) {
    CHECK(both.at(0, y)[2] == 0);
    CHECK(both.at(1, y)[2] == 8);
    CHECK(both.at(1, y)[3] == 0.25F);
  }
  CHECK(emission_texture(&emission, nullptr).at(0, 0)[3] == 1);
  CHECK(emission_texture(nullptr, &occlusion).at(0, 0)[0] == 1);
  CHECK(emission_texture(nullptr, nullptr).width == 0);
  CHECK(test::error_of([&] { (void)emission_texture(&occlusion, nullptr); }) ==
        "texture: 1 channels; expected three");
}

// A quad of white paper under one light from straight in front, with a normal map of one normal.
double brightness_of_quad(const std::vector<float>& normal, const std::array<double, 2>& scale = {1, 1}) {
  Scene scene = lit_scene("ggx-schlick");
  scene.shape = Shape::quad;
  scene.specular = nullptr;
  scene.specular_values.clear();
  scene.lights = {};
  Light light;
  light.kind = LightKind::directional;
  light.direction = {0, 0, -1};
  scene.lights.lights = {light};
  scene.transfer = Transfer::linear;
  SurfaceTextures textures;
  textures.has = {false, false, false, false, false, false, true};
  textures.normal = filled(1, 1, normal);
  scene.textures = std::make_shared<const SurfaceTextures>(std::move(textures));
  scene.texture_scale = scale;
  Image out;
  render_cpu(scene, nullptr, 1, Precision::f64, out);
  return double{out.at(20, 20)[0]};
}

TEST_CASE(
    "a normal map turns the surface: under light from in front it is as dark as the cosine of its angle") {
  const double flat = brightness_of_quad({0, 0, 1, 1});
  REQUIRE(flat > 0.01);
  for (const double degrees : {20.0, 45.0, 60.0})
    for (const bool along_x : {true, false}) {
      const double a = degrees * std::numbers::pi / 180;
      const auto s = static_cast<float>(std::sin(a)), c = static_cast<float>(std::cos(a));
      const double bent =
          brightness_of_quad(along_x ? std::vector<float>{s, 0, c, 1} : std::vector<float>{0, -s, c, 1});
      CHECK(bent / flat == Approx(std::cos(a)).epsilon(1e-4));
    }
  // A texel that looks away is held at a small cosine, where the surface is dark and no light comes from behind.
  CHECK(brightness_of_quad({1, 0, -0.5F, 1}) / flat < 0.05);
}

TEST_CASE("y of a normal map points up, and textures that repeat lie in the quad as often as they say") {
  Scene scene = lit_scene("ggx-schlick");
  scene.shape = Shape::quad;
  scene.specular = nullptr;
  scene.specular_values.clear();
  scene.lights = {};
  Light light;
  light.kind = LightKind::directional;
  light.direction = {0, -0.8, -0.6};  // from above
  scene.lights.lights = {light};
  SurfaceTextures textures;
  textures.has = {false, false, false, false, false, false, true};
  textures.normal = Image(2, 1, 4, 1);
  for (const int x : {0, 1}) {
    textures.normal.at(x, 0)[0] = 0;
    textures.normal.at(x, 0)[1] = x == 0 ? 0.6F : -0.6F;
    textures.normal.at(x, 0)[2] = 0.8F;
  }
  scene.textures = std::make_shared<const SurfaceTextures>(std::move(textures));
  const auto row = [&](double repeats) {
    scene.texture_scale = {repeats, 1};
    Image out;
    render_cpu(scene, nullptr, 1, Precision::f64, out);
    const std::array columns{5, 14, 25, 34};
    float most = 0;
    for (const int x : columns) most = std::max(most, out.at(x, 20)[1]);
    std::string bright;
    for (const int x : columns) bright += out.at(x, 20)[1] > most / 2 ? '#' : '.';
    return bright;
  };
  CHECK(row(1) == "##..");  // leaning up on the left, which the light from above meets
  CHECK(row(2) == "#.#.");
}

TEST_CASE("a scene has the samplers of the textures that it has, and no others") {
  const Image picture(2, 2, 3);
  CHECK(samplers_of(*surface_textures({})).empty());
  const auto laid = surface_textures({.body = &picture, .emission = &picture});
  const auto found = samplers_of(*laid);
  REQUIRE(found.size() == 2);
  CHECK(found[0].first == std::string("surface_body"));
  CHECK(found[1].first == std::string("surface_emission"));
}

namespace {

// A fine pattern of two colours with its halves.
std::shared_ptr<SurfaceTextures> fine_pattern(int side) {
  Image body(side, side, 4, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        body.at(x, y)[c] = (x * 7 + y * 13 + (x * y) % 5) % 3 == 0 ? 0.9f : 0.1f * static_cast<float>(c);
  auto out = std::make_shared<SurfaceTextures>(*surface_textures({.body = &body}));
  add_halves(*out);
  return out;
}

ViewState patterned(std::shared_ptr<const SurfaceTextures> textures, double repeats) {
  ViewState out;
  out.a.diffuse = find_model("lambert");
  out.a.textures = std::move(textures);
  out.a.texture_scale = {repeats, repeats};
  out.lights = default_lights();
  return out;
}

}  // namespace

TEST_CASE("halves of textures are means of four texels, down to a few") {
  Image body(10, 6, 4);
  for (std::size_t i = 0; i < body.values.size(); ++i) body.values[i] = static_cast<float>(i * i % 17) / 17;
  SurfaceTextures textures = *surface_textures({.body = &body});
  CHECK(textures.half == nullptr);
  add_halves(textures);
  REQUIRE(textures.half != nullptr);
  const Image& half = textures.half->body;
  REQUIRE((half.width == 5 && half.height == 3));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const float sum = body.at(2 * x, 2 * y)[c] + body.at(2 * x + 1, 2 * y)[c] +
                          body.at(2 * x, 2 * y + 1)[c] + body.at(2 * x + 1, 2 * y + 1)[c];
        CHECK(half.at(x, y)[c] == Approx(sum / 4).margin(1e-6));
      }
  REQUIRE(textures.half->half != nullptr);
  CHECK(textures.half->half->half == nullptr);
  CHECK(textures.half->has.diffuse);
  CHECK_FALSE(textures.half->has.f0);
}

TEST_CASE("textures are drawn from the halves whose texels are about as large as a pixel") {
  const auto textures = fine_pattern(512);
  const auto side = [&](double repeats, double zoom, ViewShape shape) {
    ViewState state = patterned(textures, repeats);
    state.shape = shape;
    state.camera.zoom = zoom;
    return view_tiles(state, 220, 220).front().scene.textures->body.width;
  };
  CHECK(side(1, 1, ViewShape::sphere) == 512);
  CHECK(side(8, 1, ViewShape::sphere) == 64);
  CHECK(side(8, 8, ViewShape::sphere) == 512);
  CHECK(side(1, 1, ViewShape::quad) == 256);
}

TEST_CASE("a pattern that repeats often is nearer to its mean over pixels with halves than without") {
  auto textures = fine_pattern(256);
  const ViewState with = patterned(textures, 16);
  auto alone = std::make_shared<SurfaceTextures>(*textures);
  alone->half = nullptr;
  const ViewState without = patterned(alone, 16);
  constexpr int side = 96, finer = 8;
  const Image drawn = draw_view(with, side, side, 2), flickering = draw_view(without, side, side, 2),
              fine = draw_view(without, side * finer, side * finer, 2);
  const auto off = [&](const Image& picture) {
    double sum = 0;
    for (int y = side / 4; y < 3 * side / 4; ++y)
      for (int x = side / 4; x < 3 * side / 4; ++x) {
        double mean = 0;
        for (int i = 0; i < finer * finer; ++i)
          mean += double{fine.at(finer * x + i % finer, finer * y + i / finer)[1]} / (finer * finer);
        sum += std::abs(double{picture.at(x, y)[1]} - mean);
      }
    return sum;
  };
  INFO(off(drawn) << " with, " << off(flickering) << " without");
  CHECK(4 * off(drawn) < off(flickering));
}

}  // namespace etak
