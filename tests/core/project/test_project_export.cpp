// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "core/base/files/file.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/project/project_export.h"
#include "core/scene/material_texels.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/gltf_judge.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int texture_side = 4;

// A picture whose texels differ: code + 3 x + 7 y in each channel.
Image8 export_ramp(std::vector<int> codes) {
  Image8 out(texture_side, texture_side, static_cast<int>(codes.size()));
  for (int y = 0; y < texture_side; ++y)
    for (int x = 0; x < texture_side; ++x)
      for (std::size_t c = 0; c < codes.size(); ++c)
        out.at(x, y)[c] = static_cast<std::uint8_t>(codes[c] + 3 * x + 7 * y);
  return out;
}

// Materials with textures: wood of all four channels, gold with a gloss, a dielectric with an opacity, and a
// plate whose F0 is partly that of a metal.
struct TexturedMaterials {
  TempFolder folder;
  MaterialLibrary library = MaterialLibrary::builtin();
  Image8 diffuse = export_ramp({120, 90, 40}), specular = export_ramp({55, 50, 45}),
         gloss = export_ramp({100}), alpha = export_ramp({80});
  Image8 mixed = export_ramp({55, 55, 55});
  std::vector<ProjectMaterial> materials;

  TexturedMaterials() {
    for (int x = 0; x < texture_side; ++x)
      for (std::size_t c = 0; c < 3; ++c) mixed.at(x, 0)[c] = static_cast<std::uint8_t>(250 - 40 * c);
    ProjectMaterial wood, gold, leaf, plate;
    wood.name = "wood / oak";
    wood.alpha_mode = AlphaMode::mask;
    wood.alpha_cutoff = 0.4;
    use(wood, Channel::diffuse, diffuse);
    use(wood, Channel::specular, specular);
    use(wood, Channel::gloss, gloss);
    use(wood, Channel::alpha, alpha);
    gold.name = "gold";
    gold.alpha_mode = AlphaMode::opaque;
    gold.measured = MeasuredF0{"gold", "", "", {}};
    use(gold, Channel::gloss, gloss);
    leaf.name = "leaf";
    leaf.alpha_mode = AlphaMode::blend;
    leaf.diffuse = {0.1, 0.4, 0.2};
    use(leaf, Channel::alpha, alpha);
    use(leaf, Channel::occlusion, alpha);
    leaf.occlusion = 0.5;
    plate.name = "plate";
    plate.emission = {4, 2, 0};
    plate.alpha_mode = AlphaMode::opaque;
    use(plate, Channel::specular, mixed);
    use(plate, Channel::emission, diffuse);
    materials = {wood, gold, leaf, plate};
    Project project;
    project.materials = materials;
    REQUIRE(resolve(project, library).empty());
    materials = project.materials;
  }
  void use(ProjectMaterial& m, Channel channel, const Image8& image) {
    const std::string file = folder.file(m.name.substr(0, 4) + "_" + std::string(name(channel)) + ".png");
    spit(file, png_bytes(image, {}));
    m.texture(channel) = ImageSource{file, "", ""};
  }
  std::vector<Changes> write(ExportForm form, const std::string& file) const {
    return export_materials(materials, library, form, Fit::clamp, picture_door(), folder.file(file));
  }
  Image8 picture(const std::string& file) const { return picture_of({folder.file(file), "", file}); }
};

Vec3 linear_texel(const Image8& image, int x, int y) {
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = srgb_decode(image.at(x, y)[c] / 255.0);
  return out;
}

}  // namespace

TEST_CASE("textures of a glTF export give back diffuse, F0, roughness and opacity of every texel") {
  const TexturedMaterials from;
  std::vector<std::string> files;
  for (const ExportForm form : {ExportForm::gltf, ExportForm::glb}) {
    const std::string file = form == ExportForm::gltf ? "out.gltf" : "out.glb";
    (void)from.write(form, file);
    files.push_back(from.folder.file(file));
    const GltfScene scene = read_gltf(files.back(), {});
    ReadPictures pictures(scene);
    REQUIRE(scene.materials.size() == 4);
    CHECK(contains(read_file(files.back()), "\"emissiveFactor\": [1, 0.5, 0]"));
    const GltfMaterial& wood = scene.materials[0];
    CHECK(wood.alpha_mode == AlphaMode::mask);
    CHECK(wood.alpha_cutoff == 0.4);
    REQUIRE((wood.base_color_texture && wood.specular_color_texture && wood.metallic_roughness_texture));
    const Image8 &base = pictures(wood.base_color_texture->image),
                 &f0 = pictures(wood.specular_color_texture->image),
                 &rough = pictures(wood.metallic_roughness_texture->image);
    for (int y = 0; y < texture_side; ++y)
      for (int x = 0; x < texture_side; ++x) {
        const DiffuseSpecular seen = converted(
            {linear_texel(base, x, y), dielectric_f0(wood.ior, wood.specular, linear_texel(f0, x, y))},
            DiffuseConvention::reduced_when_shading, DiffuseConvention::as_it_is);
        for (std::size_t c = 0; c < 3; ++c) {
          CHECK(srgb_u8(seen.f0[c]) == from.specular.at(x, y)[c]);
          CHECK(std::abs(srgb_u8(seen.diffuse[c]) - from.diffuse.at(x, y)[c]) <= 1);
        }
        CHECK(base.at(x, y)[3] == from.alpha.at(x, y)[0]);
        CHECK(rough.at(x, y)[1] == std::lround(255 * roughness_of_gloss(from.gloss.at(x, y)[0] / 255.0)));
      }
    const GltfMaterial& gold = scene.materials[1];
    CHECK(gold.metallic == 1);
    CHECK(gold.base_color[0] == 1);
    CHECK(!gold.base_color_texture);
    REQUIRE(gold.metallic_roughness_texture);
    CHECK(pictures(gold.metallic_roughness_texture->image).at(0, 0)[2] == 255);
    const GltfMaterial& leaf = scene.materials[2];
    CHECK(leaf.alpha_mode == AlphaMode::blend);
    REQUIRE(leaf.base_color_texture);
    CHECK(pictures(leaf.base_color_texture->image).at(1, 2)[0] == 255);
    CHECK(pictures(leaf.base_color_texture->image).at(1, 2)[3] == from.alpha.at(1, 2)[0]);
    CHECK(leaf.base_color[1] == Approx(0.4 / 0.96));
    const GltfMaterial& plate = scene.materials[3];
    REQUIRE(plate.specular_color_texture);
    CHECK(pictures(plate.specular_color_texture->image) == from.mixed);
    CHECK(plate.base_color == std::array<double, 4>{0, 0, 0, 1});
    REQUIRE((plate.emissive_texture && leaf.occlusion_texture && !gold.emissive_texture));
    CHECK(pictures(plate.emissive_texture->image) == from.diffuse);
    CHECK(contains(*scene.json, "\"emissiveStrength\": 4"));
    CHECK(pictures(leaf.occlusion_texture->image).at(1, 2)[0] == std::lround(0.5 * from.alpha.at(1, 2)[0]));
  }
  const auto messages = gltf_messages(from.folder.path(), files);
  if (!messages) WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
  CHECK(messages.value_or("") == "");
}

TEST_CASE("textures of a MaterialX export lie beside it under relative names") {
  const TexturedMaterials from;
  const std::vector<Changes> changes = from.write(ExportForm::material_x, "out.mtlx");
  const std::string text = slurp(from.folder.file("out.mtlx"));
  for (const char* name : {"out_wood___oak_base_color.png", "out_wood___oak_base_metalness.png",
                           "out_wood___oak_specular_roughness.png", "out_wood___oak_geometry_opacity.png",
                           "out_gold_specular_roughness.png", "out_leaf_geometry_opacity.png",
                           "out_plate_base_metalness.png", "out_plate_emission_color.png"}) {
    CHECK(contains(text, "value=\"" + std::string(name) + "\""));
    CHECK(std::filesystem::exists(from.folder.file(name)));
  }
  CHECK(!contains(text, from.folder.path()));
  const Image8 rough = from.picture("out_gold_specular_roughness.png");
  const Image8 opacity = from.picture("out_wood___oak_geometry_opacity.png");
  const Image8 blend = from.picture("out_leaf_geometry_opacity.png");
  const Image8 base = from.picture("out_plate_base_color.png"),
               metalness = from.picture("out_plate_base_metalness.png");
  REQUIRE((rough.channels == 1 && opacity.channels == 1 && base.channels == 3 && metalness.channels == 1));
  for (int y = 0; y < texture_side; ++y)
    for (int x = 0; x < texture_side; ++x) {
      const int alpha = from.alpha.at(x, y)[0];
      CHECK(rough.at(x, y)[0] == std::lround(255 * roughness_of_gloss(from.gloss.at(x, y)[0] / 255.0)));
      CHECK(opacity.at(x, y)[0] == (alpha >= 102 ? 255 : 0));
      CHECK(blend.at(x, y)[0] == alpha);
    }
  // The first row is a metal, whose F0 is its base colour.
  for (int x = 0; x < texture_side; ++x) {
    CHECK(metalness.at(x, 0)[0] == 255);
    for (std::size_t c = 0; c < 3; ++c) CHECK(base.at(x, 0)[c] == from.mixed.at(x, 0)[c]);
  }
  // Emission {4, 2, 0}: the luminance is 4, and the picture takes the colour.
  CHECK(contains(text, "<input name=\"emission_luminance\" type=\"float\" value=\"4\" />"));
  const Image8 emission = from.picture("out_plate_emission_color.png");
  CHECK(emission.at(1, 1)[0] == from.diffuse.at(1, 1)[0]);
  CHECK(emission.at(1, 1)[1] == srgb_u8(srgb_decode(from.diffuse.at(1, 1)[1] / 255.0) / 2));
  CHECK(emission.at(1, 1)[2] == 0);
  // Wood is none.
  const Image8 wood = from.picture("out_wood___oak_base_metalness.png");
  for (int i = 0; i < texture_side * texture_side; ++i) CHECK(wood.values[static_cast<std::size_t>(i)] < 128);
  // What one index of refraction cannot hold is told, in the file too.
  REQUIRE(changes.size() == 4);
  CHECK(std::any_of(changes[0].begin(), changes[0].end(),
                    [](const Change& each) { return each.field == "F0" && each.action == "nearest"; }));
  CHECK(contains(text, "(nearest, "));
}

TEST_CASE("no picture of another file is replaced, and the same export again adds none") {
  const TexturedMaterials from;
  std::vector<ProjectMaterial> one{from.materials[0]};
  const auto write = [&] {
    (void)export_materials(one, from.library, ExportForm::material_x, Fit::clamp, picture_door(),
                           from.folder.file("wood.mtlx"));
  };
  const auto files = [&] {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(from.folder.path())) ++count;
    return count;
  };
  spit(from.folder.file("wood_base_color.png"), "the picture of somebody else");
  write();
  CHECK(slurp(from.folder.file("wood_base_color.png")) == "the picture of somebody else");
  CHECK(contains(slurp(from.folder.file("wood.mtlx")), "value=\"wood_base_color_2.png\""));
  const std::size_t before = files();
  write();
  CHECK(files() == before);
  // A picture that cannot be read leaves the document as it was.
  const std::string text = slurp(from.folder.file("wood.mtlx"));
  one[0].texture(Channel::gloss)->path = from.folder.file("missing.png");
  CHECK(contains(error_of(write), "missing.png"));
  CHECK(slurp(from.folder.file("wood.mtlx")) == text);
}

TEST_CASE("a measured metal with a diffuse texture keeps both colours, and a clear body is not clear") {
  const TexturedMaterials from;
  std::vector<ProjectMaterial> both{from.materials[1], ProjectMaterial{}};
  both[1].name = "water";
  both[1].measured = MeasuredF0{"water", "", "", {}};
  for (ProjectMaterial& each : both)
    each.texture(Channel::diffuse) = from.materials[0].texture(Channel::diffuse);
  (void)export_materials(both, from.library, ExportForm::glb, Fit::clamp, picture_door(),
                         from.folder.file("both.glb"));
  const GltfScene scene = read_gltf(from.folder.file("both.glb"), {});
  for (const GltfMaterial& each : scene.materials) {
    CHECK(each.metallic == 0);
    CHECK(each.base_color_texture);
  }
  const Vec3 gold = dielectric_f0(scene.materials[0].ior, scene.materials[0].specular,
                                  {scene.materials[0].specular_color[0], scene.materials[0].specular_color[1],
                                   scene.materials[0].specular_color[2]});
  CHECK(gold[0] == Approx(0.99));
  CHECK(gold[2] == Approx(from.materials[1].specular.b).margin(1e-9));
  CHECK(!contains(*scene.json, "transmission"));
}
