// SPDX-License-Identifier: Apache-2.0
// Scenes that programs make: the demo's, and those of a generator that plants what can be left out. What holds for
// the real ones holds for them.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "core/scene/gltf.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/atlas/shaded_scenes.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"
#include "tests/core/validate/scene_verdicts.h"
#include "tests/scene/demo_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t generated_places = 5000;

// Calls act(path of scene.gltf, its folder) for one scene after the other.
template <class Act>
void each_generated(const Act& act) {
  {
    const TempFolder folder;
    demo::write_demo_scene(folder.file("scene"), false);
    INFO("the demo's scene");
    act(folder.file("scene/scene.gltf"), folder);
  }
  const auto shared = shared_folder();
  const std::string program = shared ? *shared + "/bench/pack/make_scene.py" : "";
  if (!shared || std::system("python3 -c '' >/dev/null 2>&1") != 0) {
    WARN("no shared folder or no python3: one generated scene only");
    return;
  }
  for (const int seed : {2, 3, 8}) {
    const TempFolder folder;
    const std::string command = "python3 '" + program + "' --size 96 --seed " + std::to_string(seed) +
                                " --out '" + folder.file("scene") + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    INFO("seed " << seed);
    act(folder.file("scene/scene.gltf"), folder);
  }
}

}  // namespace

TEST_CASE("generated scenes take no more than they did, look the same, and have one verdict") {
  double shares = 0;
  std::size_t count = 0;
  each_generated([&](const std::string& scene, const TempFolder& folder) {
    const ValidationReport input = said_of(scene);
    for (const PackGoal goal : {PackGoal::gpu, PackGoal::disk, PackGoal::within}) {
      CAPTURE(name(goal));
      PackOptions options;
      options.leave_out.islands = true;
      options.output.smallest_form = true;
      options.output.goal = goal;
      const std::string out = folder.file(name(goal));
      PackResult result;
      const ValidationReport packed = said_while_packing(scene, out, options, {}, &result);
      CHECK(told(packed) == told(input));
      REQUIRE(result.totals);
      const TextureTotals before = PackTotals::all(result.totals->input);
      if (goal == PackGoal::gpu) {
        CHECK(result.totals->scene->gpu <= before.gpu);
        CHECK(PackTotals::of_materials(result.totals->output).gpu <=
              PackTotals::of_materials(result.totals->input).gpu);
        shares += static_cast<double>(result.totals->scene->gpu) / static_cast<double>(before.gpu);
        ++count;
      } else {
        CHECK(result.totals->scene->disk <= before.disk);
      }
      if (goal == PackGoal::within) CHECK(result.totals->scene->gpu <= before.gpu);
      const auto form = std::find_if(result.forms.begin(), result.forms.end(),
                                     [](const FormCost& each) { return each.written; });
      REQUIRE(form != result.forms.end());
      const ShadedDifference found = shaded_difference(scene, out + "/scene.gltf", generated_places);
      CHECK(found.places > generated_places / 2);
      CHECK(found.nearest <= 1);
      CHECK(form->exact);
      CHECK(found.bilinear <= 1);
      if (has_validator()) CHECK(validator_errors(out + "/scene.gltf", {out}).empty());
    }
  });
  CHECK(shares / static_cast<double>(count) <= 0.85);
}

TEST_CASE("pictures whose gutters would take more than they do themselves lie whole on pages of their own") {
  const TempFolder folder;
  std::string images, textures, materials;
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i), comma = i == 0 ? "" : ",";
    save_png(folder.file("p" + number + ".png"), noise(64, 64, 3, static_cast<unsigned>(i)));
    images += comma + R"({"uri":"p)" + number + R"(.png"})";
    textures += comma + R"({"sampler":0,"source":)" + number + "}";
    if (i % 2 == 0)
      materials += comma + R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":)" + number +
                   R"(},"metallicRoughnessTexture":{"index":)" + std::to_string(i + 1) + "}}}";
  }
  const std::string one = R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0})";
  spit(folder.file("quad.bin"), unit_quad());
  spit(folder.file("scene.gltf"),
       replaced(
           quad_json("[" + materials + "]",
                     R"("images":[)" + images +
                         R"(],"samplers":[{"wrapS":33071,"wrapT":33071}],"textures":[)" + textures + "],"),
           one, one + "," + replaced(one, R"("material":0)", R"("material":1)")));
  for (const bool gutter : {false, true}) {
    CAPTURE(gutter);
    PackOptions options;
    options.output.smallest_form = true;
    if (gutter) options.layout.gutter = 1;
    const std::string out = folder.file(gutter ? "with" : "without");
    const PackResult result = pack_scene(folder.file("scene.gltf"), out, true, options);
    REQUIRE(result.totals);
    const std::uint64_t input = PackTotals::of_materials(result.totals->input).gpu,
                        pair = PackTotals::of_materials(result.totals->output).gpu;
    if (gutter) {
      CHECK(result.pages.size() == 1);
      CHECK(pair > input);
    } else {
      CHECK(result.pages == std::vector<PlannedPage>(2, PlannedPage{64, 64}));
      CHECK(pair == input);
      for (const AtlasRect& rect : result.layout.rects) CHECK_FALSE(rect.repeats);  // as its sampler clamps
    }
    const ShadedDifference found = shaded_difference(folder.file("scene.gltf"), out + "/scene.gltf", 1000);
    CHECK(found.nearest <= 1);
    CHECK(found.bilinear <= 1);
    if (has_validator()) CHECK(validator_errors(out + "/scene.gltf", {out}).empty());
  }
}
