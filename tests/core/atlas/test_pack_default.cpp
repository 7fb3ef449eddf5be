// SPDX-License-Identifier: Apache-2.0
// What `etak pack SCENE` does where nothing more is asked for.
#include <catch2/catch.hpp>

#include "core/image/texture_bytes.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"

using namespace etak;
using namespace etak::test;

namespace {

PackResult packed_by(PackSettings settings, const std::string& scene, const std::string& out) {
  PackOptions options = pack_options(settings);
  options.run.threads = 2;
  options.input.pictures.door = picture_door();
  return pack(scene, out, options, test::library());
}

// Counted from the pictures that a document names, each as often as it is stored.
TextureTotals counted(const std::string& path) {
  TextureTotals out;
  std::set<std::string> seen;
  for (const PictureFile& image : read_gltf(path, {}).images) {
    if (!image.path.empty() && !seen.insert(image.path).second) continue;
    const Image8 picture = picture_of(image);
    const std::size_t bytes = picture.channels <= 2 ? static_cast<std::size_t>(picture.channels) : 4;
    ++out.files;
    out.gpu += bytes * picture.pixel_count();
    out.disk += image.path.empty() ? image.bytes.size() : slurp(image.path).size();
  }
  return out;
}

double share(std::uint64_t part, std::uint64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

const FormCost& form_written(const PackResult& result) {
  const auto found = std::ranges::find(result.forms, true, &FormCost::written);
  REQUIRE(found != result.forms.end());
  return *found;
}

}  // namespace

TEST_CASE(
    "by default no scene takes more than it did, on the GPU or the disk, and real ones 70 % on the GPU") {
  if (!asset("")) return;
  std::vector<std::string> models = real_models;
  models.push_back("synthetic_a/scene.gltf");
  double shares = 0;
  for (const std::string& name : models) {
    INFO(name);
    const TempFolder folder;
    const PackResult result = packed_by({}, *asset(name), folder.file("out"));
    CHECK(form_written(result).exact);
    const TextureTotals before = counted(*asset(name)), after = counted(folder.file("out/scene.gltf"));
    CHECK(after.gpu <= before.gpu);
    CHECK(after.disk <= before.disk);
    CHECK(result.totals->scene->disk == after.disk);
    CHECK(form_written(result).textures == after.files);
    if (name != models.back())
      shares += share(after.gpu, before.gpu) / static_cast<double>(real_models.size());
    // Two levels are clean wherever a viewer's mips could mix neighbours.
    CHECK(result.mixed_from.value_or(2) >= 2);
    // Each of the other goals is best by what it weighs, and the line tells of it.
    REQUIRE(result.other_goals.size() == 3);
    CHECK(result.other_goals[0].totals.gpu <= result.totals->scene->gpu);
    CHECK(result.other_goals[1].totals.disk <= result.totals->scene->disk);
    CHECK(contains(report_text(result, false), "\nchosen: " + result.way + ": "));
  }
  CHECK(shares <= 0.70);
}

TEST_CASE("what is asked for of a scene is done: the default chooses the rest") {
  if (!asset("")) return;
  const std::string scene = *asset("tennis_racquet/TennisRacquet.gltf");
  const auto result_of = [&](auto change) {
    const TempFolder folder;
    PackSettings settings;
    change(settings);
    return packed_by(settings, scene, folder.file("out"));
  };
  const PackResult form = result_of([](PackSettings& s) { s.gltf_form = "metal-rough"; });
  CHECK(form_written(form).form == GltfForm::metal_rough);
  CHECK(contains(form.way, "islands by outline"));
  const PackResult crops = result_of([](PackSettings& s) { s.keep = {"islands"}; });
  CHECK(crops.way.starts_with("crops"));
  const PackResult bare = result_of([](PackSettings& s) { s.gutter = "1"; });
  CHECK(bare.mixed_from == 1);
  CHECK(result_of([](PackSettings& s) { s.goal = "gpu"; }).other_goals.empty());
}

TEST_CASE("more than the input takes weighs more than anything else, on the GPU before the disk") {
  const TextureTotals input{4, 1000, 8000};
  const TextureWeight weight(PackGoal::within, input);
  CHECK(weight({1, 1000, 8000}) == Approx(2));
  CHECK(weight({1, 100, 4000}) == Approx(0.1 + 0.5));
  CHECK(weight({1, 1000, 8000}) < weight({1, 1001, 10}));
  CHECK(weight({1, 90000, 8000}) < weight({1, 10, 8001}));
}

TEST_CASE("what only scenes are asked leaves a manifest's atlas as it is, byte for byte") {
  const TempFolder folder;
  add_noise_material(folder, "a", 24, 16, 1);
  add_noise_material(folder, "b", 16, 24, 2);
  spit(folder.file("m.json"), manifest_of({manifest_entry("a"), manifest_entry("b")}));
  PackSettings plain;
  plain.gltf_form = "specular-ior";
  plain.goal = "gpu";
  (void)packed_by({}, folder.file("m.json"), folder.file("default"));
  (void)packed_by(plain, folder.file("m.json"), folder.file("plain"));
  for (const char* file : {"layout.json", "page0_diffuse_alpha.png", "page0_specular_gloss.png"})
    CHECK(slurp(folder.file("default/" + std::string(file))) ==
          slurp(folder.file("plain/" + std::string(file))));
}
