// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uv_use.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Corners = std::array<std::array<float, 2>, 3>;

GltfScene scene_of_triangles(const std::vector<Corners>& triangles) {
  GltfScene scene;
  scene.path = "s.gltf";
  scene.materials.resize(1);
  GltfUse use;
  use.material = 0;
  use.uv[0] = triangles;
  use.world_area.assign(triangles.size(), 1);
  scene.uses.push_back(use);
  return scene;
}
std::vector<Corners> rectangle(float u0, float v0, float u1, float v1) {
  return {{{{u0, v0}, {u1, v0}, {u1, v1}}}, {{{u0, v0}, {u1, v1}, {u0, v1}}}};
}
GltfTexture texture(Wrap wrap, const UvTransform& transform = {}) {
  GltfTexture out;
  out.sampler.wrap_u = out.sampler.wrap_v = wrap;
  out.transform = transform;
  return out;
}
TexelUse use_of(const std::vector<Corners>& triangles, Wrap wrap, int size = 64) {
  return texel_use(scene_of_triangles(triangles), 0, texture(wrap), size, size);
}
bool marked(const TexelUse& use, int x, int y) {
  return use.mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(use.width) +
                  static_cast<std::size_t>(x)] != 0;
}

}  // namespace

TEST_CASE("a rectangle touches its texels and those that bilinear filtering reaches") {
  // From the middle of texel 16 to the middle of texel 31: filtering reads those alone, and with the slack of
  // samplers one more on each side.
  const TexelUse middle = use_of(rectangle(16.5f / 64, 16.5f / 64, 31.5f / 64, 31.5f / 64), Wrap::repeat);
  CHECK(middle.box == std::array<int, 4>{15, 15, 18, 18});
  const TexelUse edges = use_of(rectangle(16.f / 64, 16.f / 64, 32.f / 64, 24.f / 64), Wrap::repeat);
  CHECK(edges.box == std::array<int, 4>{15, 15, 18, 10});
  CHECK(edges.touched == 180);
  CHECK(edges.extent == edges.box);
  CHECK(!edges.tiles);
}

TEST_CASE("no texel that a bilinear lookup reads is missed, for any triangles and wrap") {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uv(-0.7f, 1.9f), small(-0.1f, 0.1f);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 60; ++round) {
    const int width = 1 + static_cast<int>(random() % 90), height = 1 + static_cast<int>(random() % 90);
    const auto wrap = static_cast<Wrap>(round % 3);
    const GltfTexture t =
        texture(wrap, {{0.1 * (round % 7), 0.2}, {1 - 0.1 * (round % 4), 0.5}, 0.3 * (round % 5)});
    const bool whole = round % 4 == 0;
    const auto around = [&](float c) { return whole ? uv(random) : std::clamp(c + small(random), 0.f, 1.f); };
    std::vector<Corners> triangles;
    for (int i = 0; i < 6; ++i) {
      const float u = std::abs(uv(random)) / 2, v = std::abs(uv(random)) / 2;
      triangles.push_back({{{around(u), around(v)}, {around(u), around(v)}, {around(u), around(v)}}});
    }
    const TexelUse use = texel_use(scene_of_triangles(triangles), 0, t, width, height);
    for (const Corners& c : triangles) {
      std::array<Uv, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = transformed(use.fold, transformed(t.transform, {double{c[k][0]}, double{c[k][1]}}));
      const auto own = footprint_of(corners, t.sampler, width, height);
      for (int i = 0; i < 300; ++i) {
        double a = share(random), b = share(random);
        if (a + b > 1) {
          a = 1 - a;
          b = 1 - b;
        }
        if (i < 3) {
          a = i == 1;
          b = i == 2;
        }
        Uv at;
        for (std::size_t k = 0; k < 2; ++k)
          at[k] = double{c[0][k]} + a * (double{c[1][k]} - double{c[0][k]}) +
                  b * (double{c[2][k]} - double{c[0][k]});
        at = transformed(use.fold, transformed(t.transform, at));
        // A triangle in one period of a tiling texture is marked as if it lay in the first.
        const Uv in_extent = at;
        if (own) at = transformed(own->fold, at);
        const double x = at[0] * width - 0.5, y = at[1] * height - 0.5;
        for (int corner = 0; corner < 4; ++corner) {
          int column = static_cast<int>(std::floor(x)) + corner % 2,
              row = static_cast<int>(std::floor(y)) + corner / 2;
          const int x_extent = static_cast<int>(std::floor(in_extent[0] * width - 0.5)) + corner % 2;
          const int y_extent = static_cast<int>(std::floor(in_extent[1] * height - 0.5)) + corner / 2;
          REQUIRE((x_extent >= use.extent[0] && x_extent < use.extent[0] + use.extent[2]));
          REQUIRE((y_extent >= use.extent[1] && y_extent < use.extent[1] + use.extent[3]));
          const auto wrapped = [&](int texel, int n) {
            if (wrap == Wrap::clamp) return std::clamp(texel, 0, n - 1);
            if (wrap == Wrap::repeat) return ((texel % n) + n) % n;
            const int in = ((texel % (2 * n)) + 2 * n) % (2 * n);
            return in < n ? in : 2 * n - 1 - in;
          };
          // What only the footprint reaches across a border is in the extent.
          const bool across = column < 0 || row < 0 || column >= width || row >= height;
          if (across && wrap != Wrap::clamp && own) continue;
          REQUIRE(marked(use, wrapped(column, width), wrapped(row, height)));
        }
      }
    }
  }
}

TEST_CASE("a range inside one period is shifted, a mirrored one turned over, a wider one tiles") {
  const TexelUse shifted = use_of(rectangle(1.25f, -2, 1.5f, -1.5f), Wrap::repeat);
  CHECK(!shifted.tiles);
  CHECK(shifted.fold == UvTransform{{-1, 2}, {1, 1}, 0});
  CHECK(shifted.box == std::array<int, 4>{15, 0, 18, 33});
  CHECK(shifted.extent == std::array<int, 4>{15, -1, 18, 34});

  const TexelUse mirrored = use_of(rectangle(1.25f, 2, 1.5f, 2.5f), Wrap::mirrored);
  CHECK(mirrored.fold == UvTransform{{2, -2}, {-1, 1}, 0});
  CHECK(mirrored.box == std::array<int, 4>{31, 0, 18, 33});

  const TexelUse tiling = use_of(rectangle(0.5f, 0, 1.25f, 0.5f), Wrap::repeat);
  CHECK((tiling.tiles && !tiling.foldable));
  CHECK(tiling.box == std::array<int, 4>{0, 0, 64, 64});
  CHECK((marked(tiling, 10, 10) && marked(tiling, 40, 10) && !marked(tiling, 24, 10) &&
         !marked(tiling, 10, 50)));

  // Two charts in periods of their own: rewritten UVs can bring them together.
  auto two = rectangle(0.25f, 0, 0.5f, 0.5f);
  for (const Corners& c : rectangle(3, 3, 3.25f, 3.25f)) two.push_back(c);
  const TexelUse apart = use_of(two, Wrap::repeat);
  CHECK((apart.tiles && apart.foldable && apart.footprints.size() == 4));
  CHECK(apart.touched == 18 * 33 + 17 * 17 - 17 * 2);

  // Beyond the edge a clamped texture goes on, which a part of a page would not.
  CHECK(!use_of(rectangle(0.5f, 0.5f, 1, 0.75f), Wrap::clamp).tiles);
  const TexelUse clamped = use_of(rectangle(0.5f, 0.5f, 3, 0.75f), Wrap::clamp);
  CHECK((clamped.tiles && !clamped.foldable));
  CHECK((marked(clamped, 63, 40) && !marked(clamped, 10, 40)));
  CHECK(clamped.box == std::array<int, 4>{0, 0, 64, 64});
  CHECK(clamped.extent == std::array<int, 4>{31, 31, 162, 18});

  // Half a texel over the edge is no tiling; a texture that is read at 1 alone is not shifted.
  CHECK(!use_of(rectangle(0, 0, 1 + 0.4f / 64, 1), Wrap::repeat).tiles);
  CHECK(use_of(rectangle(1, 1, 1, 1), Wrap::repeat).fold == UvTransform{});
}

TEST_CASE("texels beyond a border that only footprints cross are read where the texture repeats") {
  const auto read = [](Wrap wrap, int x, int y) {
    const TexelUse use = use_of(rectangle(0, 0, 0.25f, 0.25f), wrap);
    CHECK(!use.mask[static_cast<std::size_t>(64 * y + x)]);
    GltfSampler sampler;
    sampler.wrap_u = sampler.wrap_v = wrap;
    return texels_read(use, sampler)[static_cast<std::size_t>(64 * y + x)] == 1;
  };
  CHECK(read(Wrap::repeat, 63, 0));
  CHECK(read(Wrap::repeat, 5, 63));
  CHECK(read(Wrap::repeat, 63, 63));
  CHECK(!read(Wrap::repeat, 63, 40));
  CHECK((!read(Wrap::clamp, 63, 0) && !read(Wrap::mirrored, 5, 63)));
}

TEST_CASE("the texture's own transform is applied first") {
  const auto scene = scene_of_triangles(rectangle(0, 0, 1, 1));
  const TexelUse use = texel_use(scene, 0, texture(Wrap::clamp, {{0.25, 0}, {0.5, 0.5}, 0}), 256, 256);
  CHECK(use.box == std::array<int, 4>{63, 0, 130, 129});
}

TEST_CASE("UVs that are no numbers are refused; wild ones do not hang") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {nan, std::numeric_limits<float>::infinity(), 2e6f})
    CHECK(contains(error_of([&] { use_of({{{{0, 0}, {bad, 0}, {0, 1}}}}, Wrap::repeat); }), "s.gltf: UV "));
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::clamp})
    for (const int size : {1, 64, 4096}) {
      CHECK(use_of({{{{-9e5f, -9e5f}, {9e5f, -9e5f}, {0, 9e5f}}}}, wrap, size).touched > 0);
      CHECK(use_of({{{{9e5f, 9e5f}, {9e5f, 9e5f}, {9e5f, 9e5f}}}}, wrap, size).touched > 0);
      CHECK(use_of({{{{-9e5f, 0.5f}, {9e5f, 0.5f}, {9e5f, 0.5f}}}}, wrap, size).touched > 0);
    }
}

TEST_CASE("a material without UVs counts as touching everything, one without triangles as nothing") {
  auto scene = scene_of_triangles(rectangle(0, 0, 0.1f, 0.1f));
  CHECK(texel_use(scene, 1, texture(Wrap::repeat), 8, 8).touched == 0);
  CHECK(islands(texel_use(scene, 1, texture(Wrap::repeat), 8, 8), 1, 0).empty());
  GltfTexture second = texture(Wrap::repeat);
  second.uv_set = 1;
  CHECK(texel_use(scene, 0, second, 8, 8).touched == 64);
}

TEST_CASE("islands hold every footprint with its margin, and are worth their number") {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> at(0.02f, 0.9f), size(0, 0.06f);
  std::vector<Corners> triangles;
  for (int i = 0; i < 40; ++i) {
    const float u = at(random), v = at(random);
    for (const Corners& c : rectangle(u, v, u + size(random), v + size(random))) triangles.push_back(c);
  }
  const TexelUse use = use_of(triangles, Wrap::repeat, 512);
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const std::size_t cost : {0u, 64u, 1024u, 1u << 20}) {
    const auto found = islands(use, 3, cost);
    CHECK(found == islands(use, 3, cost));
    CHECK(found.size() <= before);
    before = found.size();
    for (const auto& f : use.footprints) {
      const bool held = std::any_of(found.begin(), found.end(), [&](const Island& b) {
        return b.x <= std::max(0, f[0] - 3) && b.y <= std::max(0, f[1] - 3) &&
               b.x + b.width > std::min(511, f[2] + 3) && b.y + b.height > std::min(511, f[3] + 3);
      });
      CHECK(held);
    }
  }
  CHECK(before == 1);
}

TEST_CASE(
    "each triangle finds all texels that it reads in the smallest outline around it that has its centre") {
  std::mt19937 random(19);
  std::uniform_real_distribution<float> at(0.02f, 0.8f), size(0.01f, 0.18f);
  std::vector<Corners> triangles;
  for (int i = 0; i < 60; ++i) {
    const float u = at(random), v = at(random);
    triangles.push_back(rectangle(u, v, u + size(random), v + size(random))[0]);
  }
  const TexelUse all = use_of(triangles, Wrap::repeat, 256);
  for (const std::size_t cost : {0u, 64u, 1u << 20}) {
    const auto found = outlines(all, cost);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& f = all.footprints[t];
      const Outline* best = nullptr;
      for (const Outline& o : found) {
        const Island& b = o.box;
        if (f[0] < b.x || f[1] < b.y || f[2] >= b.x + b.width || f[3] >= b.y + b.height) continue;
        if (!holds(o.texels, all.centres[t][0], all.centres[t][1])) continue;
        if (best == nullptr || b.width * b.height < best->box.width * best->box.height) best = &o;
      }
      REQUIRE(best != nullptr);
      const TexelUse alone = use_of({triangles[t]}, Wrap::repeat, 256);
      std::size_t missing = 0;
      for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
          missing +=
              alone.mask[static_cast<std::size_t>(256 * y + x)] != 0 && !holds(best->texels, x, y) ? 1 : 0;
      CHECK(missing == 0);
    }
  }
}

TEST_CASE("two charts far apart are two islands, in order, and a cheap merge makes them one") {
  auto two = rectangle(0.5f, 0.5f, 0.75f, 0.75f);
  for (const Corners& c : rectangle(0.125f, 0.125f, 0.25f, 0.25f)) two.push_back(c);
  const TexelUse use = use_of(two, Wrap::repeat);
  CHECK(islands(use, 1, 0) == std::vector<Island>{{6, 6, 12, 12}, {30, 30, 20, 20}});
  // Together 44 x 44 for 144 + 400.
  CHECK(islands(use, 1, 1936 - 544).size() == 2);
  CHECK(islands(use, 1, 1936 - 544 + 1) == std::vector<Island>{{6, 6, 44, 44}});
}

TEST_CASE("texels in use on the real scenes are those of an independent count") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no folder of reference data: real scenes are not read");
    return;
  }
  // The table of the assets' README: box of the UVs and texels covered by triangles, in percent, which leave
  // out the bilinear footprint: ours are larger by what lies along the outlines.
  const std::map<std::string, std::array<double, 3>> table{{"HoseMat", {512, 13, 11.9}},
                                                           {"RubberWoodMat", {512, 98, 50.9}},
                                                           {"GlassPlasticMat", {512, 97, 45.8}},
                                                           {"MetalPartsMat", {512, 98, 46.6}},
                                                           {"LeatherPartsMat", {512, 99, 69.7}},
                                                           {"LensesMat", {512, 58, 40}},
                                                           {"frame_material", {1024, 89, 11.3}},
                                                           {"handle_material", {1024, 84, 59.4}},
                                                           {"plastic_parts_material", {1024, 100, 4.8}},
                                                           {"WickerChair", {1024, 96, 36.8}},
                                                           {"WickerChair_Alpha", {1024, 29, 21.3}},
                                                           {"Mixer02Shader", {2048, 100, 73.3}},
                                                           {"strings_material", {1024, 91, 20.4}}};
  for (const char* file : {"flight_helmet/FlightHelmet.gltf", "mixer/Mixer.gltf",
                           "tennis_racquet/TennisRacquet.gltf", "wicker_chair/WickerChair.gltf"}) {
    const GltfScene scene = read_gltf(*shared + "/data/assets/" + file, {});
    for (const GltfMaterial& material : scene.materials) {
      const auto& [size, box, covered] = table.at(material.name);
      const int side = static_cast<int>(size);
      const TexelUse use = texel_use(scene, material.index, *leading_texture(material), side, side);
      INFO(material.name);
      CHECK(!use.tiles);
      CHECK(100.0 * use.box[2] * use.box[3] / (size * size) == Approx(box).margin(2));
      const double touched = 100.0 * static_cast<double>(use.touched) / (size * size);
      CHECK(touched >= covered);
      // Thin strings have as much outline as inside.
      CHECK(touched <= covered + (material.name == "strings_material" ? 15 : 8.5));
    }
  }
}

TEST_CASE("the planted UV boxes and tiling are found") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no folder of reference data: the planted scene is not read");
    return;
  }
  const std::string folder = *shared + "/data/assets/synthetic_a/";
  const GltfScene scene = read_gltf(folder + "scene.gltf", {});
  const auto truth = nlohmann::json::parse(slurp(folder + "truth.json"));
  for (const auto& row : truth["materials"]) {
    const auto at = std::find_if(scene.materials.begin(), scene.materials.end(), [&](const GltfMaterial& m) {
      return m.name == row["material"].get<std::string>();
    });
    REQUIRE(at != scene.materials.end());
    INFO(at->name);
    CHECK(scene.material_used[static_cast<std::size_t>(at->index)] == row["used"].get<bool>());
    if (!row["used"].get<bool>()) continue;
    const int width = row["size"][0], height = row["size"][1];
    const TexelUse use = texel_use(scene, at->index, *leading_texture(*at), width, height);
    CHECK(use.tiles == row["tiles"].get<bool>());
    const auto box = row["uv_box"].get<std::array<double, 4>>();
    if (use.tiles) continue;
    // One texel more on each side for the footprint, inside the texture.
    const auto first = [](double uv, int size) {
      return std::max(0, static_cast<int>(std::lround(uv * size)) - 1);
    };
    const auto last = [](double uv, int size) {
      return std::min(size, static_cast<int>(std::lround(uv * size)) + 1);
    };
    CHECK(use.box == std::array<int, 4>{first(box[0], width), first(box[1], height),
                                        last(box[2], width) - first(box[0], width),
                                        last(box[3], height) - first(box[1], height)});
  }
}
