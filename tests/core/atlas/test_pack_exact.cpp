// SPDX-License-Identifier: Apache-2.0
// A form is called exact only where it is, and what no form can hold stays as it was.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/scene/packed_meshes.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"
#include "tests/core/validate/scene_verdicts.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::string_view pictures =
    R"("images":[{"uri":"a.png"},{"uri":"b.png"}],"textures":[{"source":0},{"source":1}],)";
const std::string base = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
const std::string paint = replaced(base, R"({"base)", R"({"metallicFactor":0,"base)");

// Writes a scene of squares whose pictures a.png (sRGB noise) and b.png are beside it.
//   further   behind the 92 bytes of the unit square
std::string write_square(const TempFolder& folder, std::string json, const std::string& further = "") {
  save_png(folder.file("a.png"), noise(32, 32, 3, 1));
  save_png(folder.file("b.png"), noise(32, 32, 3, 2));
  spit(folder.file("quad.bin"), unit_quad() + further);
  spit(folder.file("s.gltf"), replaced(std::move(json), R"("byteLength":92)",
                                       R"("byteLength":)" + std::to_string(92 + further.size())));
  return folder.file("s.gltf");
}

PackResult packed(const TempFolder& folder, GltfForm form, bool smallest = false) {
  PackOptions options;
  options.output.forms = {form};
  options.output.smallest_form = smallest;
  options.output.overwrite = true;
  return pack_scene(folder.file("s.gltf"), folder.file("out"), false, options);
}

bool is_exact(const PackResult& result, GltfForm form) {
  return std::ranges::find(result.forms, form, &FormCost::form)->exact;
}

GltfForm written_form(const PackResult& result) {
  return std::ranges::find(result.forms, true, &FormCost::written)->form;
}

bool is_told(const PackResult& result, std::string_view what) {
  return std::ranges::any_of(result.remarks,
                             [&](const std::string& remark) { return contains(remark, what); });
}

// What the first triangle of a use finds at a corner of base colour, or of diffuse, under its factor.
std::array<double, 3> base_at(const GltfScene& scene, std::size_t use, std::size_t corner) {
  const GltfMaterial& m = scene.materials[static_cast<std::size_t>(scene.uses[use].material)];
  const auto& texture = m.specular_glossiness ? m.diffuse_texture : m.base_color_texture;
  const auto& factor = m.specular_glossiness ? m.diffuse : m.base_color;
  REQUIRE(texture);
  ReadPictures files(scene);
  const auto texel =
      lookup(files(texture->image), *texture, scene.uses[use].uv[texture->uv_set][0][corner], Filter::light);
  return {texel[0] * factor[0], texel[1] * factor[1], texel[2] * factor[2]};
}

void check_same_base(const TempFolder& folder, std::size_t use) {
  const GltfScene before = read_gltf(folder.file("s.gltf"), {}),
                  after = read_gltf(folder.file("out/scene.gltf"), {});
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto was = base_at(before, use, corner), is = base_at(after, use, corner);
    for (std::size_t c = 0; c < 3; ++c) CHECK(is[c] == Approx(was[c]).margin(1));
  }
}

constexpr std::array forms{GltfForm::specular_ior, GltfForm::specular_glossiness, GltfForm::metal_rough};

}  // namespace

TEST_CASE("an unlit material keeps its base colour in every form") {
  const TempFolder folder;
  write_square(folder, quad_json(R"([{"extensions":{"KHR_materials_unlit":{}},)" + base + "}]",
                                 R"("extensionsUsed":["KHR_materials_unlit"],)" + std::string(pictures)));
  for (const GltfForm form : forms) {
    CHECK(is_exact(packed(folder, form), form));
    check_same_base(folder, 0);
    CHECK(read_gltf(folder.file("out/scene.gltf"), {}).materials[0].unlit);
  }
  packed(folder, GltfForm::specular_ior, true);
  check_same_base(folder, 0);
}

TEST_CASE("what a clamping sampler reads beyond its texture's edge is the edge on the page too") {
  const TempFolder folder;
  const std::string sampler = R"("samplers":[{"wrapS":33071,"wrapT":33071}],)";
  write_square(folder,
               quad_json("[{" + paint + "}]", sampler + replaced(std::string(pictures), R"({"source":0})",
                                                                 R"({"source":0,"sampler":0})")));
  spit(folder.file("quad.bin"), quad_buffer({0.5f, 0.25f, 1.5f, 0.25f, 1.5f, 0.5f, 0.5f, 0.5f}));
  for (const GltfForm form : forms) {
    packed(folder, form);
    check_same_base(folder, 0);
  }
}

TEST_CASE("a dark metal, dielectric or half of each of one colour is the same in metal-rough form") {
  const auto written = [](const std::string& factors) {
    const TempFolder folder;
    write_square(folder,
                 quad_json(R"([{"pbrMetallicRoughness":{)" + factors + R"("baseColorTexture":{"index":0}}}])",
                           std::string(pictures)));
    Image8 dark(32, 32, 3);
    for (std::size_t i = 0; i < dark.values.size(); ++i)
      dark.values[i] = std::array<std::uint8_t, 3>{30, 20, 25}[i % 3];
    dark.at(0, 0)[0] = 200;  // nothing reads it
    save_png(folder.file("a.png"), dark);
    spit(folder.file("quad.bin"), quad_buffer({0.5f, 0.5f, 0.75f, 0.5f, 0.75f, 0.75f, 0.5f, 0.75f}));
    CHECK(is_exact(packed(folder, GltfForm::metal_rough), GltfForm::metal_rough));
    return read_gltf(folder.file("out/scene.gltf"), {}).materials[0];
  };
  const GltfMaterial metal = written("");
  CHECK(metal.metallic == Approx(1));
  CHECK(255 * srgb_encode(metal.base_color[0]) == Approx(30).margin(0.6));
  // Vertex colours multiply them: that both together say the same F0 is not enough.
  const GltfMaterial half = written(R"("metallicFactor":0.5,)");
  CHECK(half.metallic == Approx(0.5));
  CHECK(255 * srgb_encode(half.base_color[1]) == Approx(20).margin(0.01));
  const GltfMaterial paint = written(R"("metallicFactor":0,)");
  CHECK(paint.metallic == 0);
  CHECK(255 * srgb_encode(paint.base_color[1]) == Approx(20).margin(0.6));
}

TEST_CASE("no colour of an unlit material is judged as F0 of a metal") {
  const auto rules_of = [](const std::string& extensions) {
    const TempFolder folder;
    write_square(folder, quad_json("[{" + extensions + base + "}]", std::string(pictures)));
    Image8 dark = noise(32, 32, 3, 1);
    for (auto& code : dark.values) code = static_cast<std::uint8_t>(80 + code % 20);
    save_png(folder.file("a.png"), dark);
    std::set<std::string> out;
    for (const auto& [rule, severity, material] : told(said_of(folder.file("s.gltf"))))
      if (rule.starts_with("ETK1")) out.insert(rule);
    return out;
  };
  CHECK(!rules_of("").empty());
  CHECK(rules_of(R"("extensions":{"KHR_materials_unlit":{}},)").empty());
}

TEST_CASE("F0 of metal under vertex colours is exact in metal-rough form alone") {
  const auto with = [](const std::vector<float>& colors) {
    const TempFolder folder;
    std::string json = quad_json(R"([{)" + base + "}]", std::string(pictures));
    json = replaced(json, R"("TEXCOORD_0":1)", R"("TEXCOORD_0":1,"COLOR_0":3)");
    json = replaced(
        json, R"("count":6,"type":"SCALAR"})",
        R"("count":6,"type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":4,"type":"VEC3"})");
    json = replaced(
        json, R"("byteLength":12,"target":34963})",
        R"("byteLength":12,"target":34963},{"buffer":0,"byteOffset":92,"byteLength":48,"target":34962})");
    write_square(folder, json, bytes_of(colors));
    return packed(folder, GltfForm::specular_ior, true);
  };
  const PackResult tinted = with({1, 1, 1, 1, 0.5f, 1, 1, 1, 1, 0.25f, 1, 1});
  CHECK(!is_exact(tinted, GltfForm::specular_ior));
  CHECK(!is_exact(tinted, GltfForm::specular_glossiness));
  CHECK(is_exact(tinted, GltfForm::metal_rough));
  CHECK(written_form(tinted) == GltfForm::metal_rough);
  CHECK(is_told(tinted, "F0 of metal, which vertex colours no longer multiply, differs by up to"));
  const PackResult white = with(std::vector<float>(12, 1));
  CHECK(is_exact(white, GltfForm::specular_ior));
}

TEST_CASE("a material whose UVs morph targets move stays whole, and says so") {
  const TempFolder folder;
  std::string json = quad_json(R"([{"name":"face",)" + base + "}]", std::string(pictures));
  json = replaced(json, R"("indices":2)", R"("indices":2,"targets":[{"TEXCOORD_0":3}])");
  json =
      replaced(json, R"("count":6,"type":"SCALAR"})",
               R"("count":6,"type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":4,"type":"VEC2"})");
  json = replaced(
      json, R"("byteLength":12,"target":34963})",
      R"("byteLength":12,"target":34963},{"buffer":0,"byteOffset":92,"byteLength":32,"target":34962})");
  write_square(folder, json, bytes_of<float>({0.5f, 0.5f, 0.5f, 0, 0, 0, 0, 0.5f}));
  for (const GltfForm form : forms) {
    const PackResult result = packed(folder, form);
    CHECK(is_told(result, "face: morph targets move its UVs; it stays as it is"));
    const GltfScene after = read_gltf(folder.file("out/scene.gltf"), {});
    CHECK(after.materials[0].base_color_texture->transform == UvTransform{});
    CHECK(load_png(folder.file("out/a.png")) == load_png(folder.file("a.png")));
    CHECK(after.uses[0].uv[0] == read_gltf(folder.file("s.gltf"), {}).uses[0].uv[0]);
  }
}

TEST_CASE("levels of detail and meshes of other scenes keep their materials") {
  // Nodes: 0 in the scene, 1 its lower level, 2 in another scene; material 3 is a lower level of material 0.
  const TempFolder folder;
  std::string json = quad_json(R"([{"name":"near","extensions":{"MSFT_lod":{"ids":[3]}},)" + base +
                                   R"(},{"name":"far",)" + base + R"(},{"name":"elsewhere",)" + base +
                                   R"(},{"name":"coarse","pbrMetallicRoughness":{}}])",
                               R"("extensionsUsed":["MSFT_lod"],)" + std::string(pictures));
  json = replaced(json, R"([{"nodes":[0]}],"nodes":[{"mesh":0}])",
                  R"([{"nodes":[0]},{"nodes":[2]}],"nodes":[{"mesh":0,"extensions":{"MSFT_lod":{"ids":[1]}}},
{"mesh":1},{"mesh":2}])");
  const std::string mesh =
      R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]})";
  json = replaced(json, mesh,
                  mesh + "," + replaced(mesh, R"("material":0)", R"("material":1)") + "," +
                      replaced(mesh, R"("material":0)", R"("material":2)"));
  write_square(folder, json);
  const PackResult result = packed(folder, GltfForm::metal_rough);
  CHECK(is_told(result, "elsewhere: is reached by other scenes alone; it stays as it is"));
  CHECK(!is_told(result, "far:"));
  const auto written = nlohmann::json::parse(slurp(folder.file("out/scene.gltf")));
  REQUIRE(written["materials"].size() == 4);
  for (const std::size_t mesh_index : {0u, 1u, 2u}) {
    const auto material = written["meshes"][mesh_index]["primitives"][0]["material"].get<std::size_t>();
    CHECK(written["materials"][material]["name"] == std::array{"near", "far", "elsewhere"}[mesh_index]);
    CHECK(written["materials"][material]["pbrMetallicRoughness"].contains("baseColorTexture"));
  }
  CHECK(written["materials"][0]["extensions"]["MSFT_lod"]["ids"] == std::vector{3});
  // The uses: near, coarse (which has factors alone), far, elsewhere.
  for (const std::size_t use : {0u, 2u, 3u}) check_same_base(folder, use);
  // In a document without its first material, what stands for others has another number.
  GltfScene scene = read_gltf(folder.file("s.gltf"), {});
  scene.material_written[1] = false;
  const auto shifted = nlohmann::json::parse(write_gltf(scene, {}).json);
  CHECK(shifted["materials"][0]["extensions"]["MSFT_lod"]["ids"] == std::vector{2});
}

TEST_CASE("specular-glossiness stands beside no other extension, and that is told") {
  const TempFolder folder;
  write_square(folder,
               quad_json(R"([{"name":"car","extensions":{"KHR_materials_clearcoat":{}},)" + base + "}]",
                         R"("extensionsUsed":["KHR_materials_clearcoat"],)" + std::string(pictures)));
  const PackResult result = packed(folder, GltfForm::specular_glossiness);
  CHECK(is_told(result, "car: has extensions beside which specular-glossiness may not stand"));
  const auto written = nlohmann::json::parse(slurp(folder.file("out/scene.gltf")));
  CHECK(written["materials"][0]["extensions"].size() == 1);
  check_same_base(folder, 0);
  if (has_validator()) CHECK(validator_errors(folder.file("out/scene.gltf"), {folder.file("out")}).empty());
}

TEST_CASE("instances change no texture: a scene that requires them is packed and keeps them") {
  const TempFolder folder;
  const std::string copies = R"("EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}})";
  std::string json = quad_json("[{" + base + "}]", R"("extensionsUsed":["EXT_mesh_gpu_instancing"],)"
                                                   R"("extensionsRequired":["EXT_mesh_gpu_instancing"],)" +
                                                       std::string(pictures));
  json = replaced(json, R"([{"mesh":0}])", R"([{"mesh":0,"extensions":{)" + copies + "}}]");
  write_square(folder, json);
  packed(folder, GltfForm::metal_rough);
  check_same_base(folder, 0);
  const auto written = nlohmann::json::parse(slurp(folder.file("out/scene.gltf")));
  CHECK(written["nodes"][0]["extensions"].contains("EXT_mesh_gpu_instancing"));
  CHECK(written["extensionsRequired"][0] == "EXT_mesh_gpu_instancing");
  // Where the triangles themselves are asked for, copies would be missing.
  CHECK(contains(error_of([&] { (void)read_gltf(folder.file("s.gltf"), {.scene = {}, .mesh = true}); }),
                 "EXT_mesh_gpu_instancing"));
}

TEST_CASE("a scene whose meshes are compressed is packed and judged as the uncompressed one is") {
  const TempFolder folder;
  save_png(folder.file("color.png"), noise(64, 32, 3, 7));
  std::map<std::string, std::string> pages;
  Told said;
  for (const auto& [coding, name] :
       {std::pair(MeshCoding::plain, "plain"), std::pair(MeshCoding::meshopt, "meshopt"),
        std::pair(MeshCoding::draco, "draco")}) {
    const MeshScene scene = mesh_scene(coding);
    const std::string file = folder.file(std::string(name) + ".glb"), out = folder.file(name);
    spit(file, glb(scene.json.dump(), scene.buffer));
    const PackResult result = pack_scene(file, out, true, {});
    CHECK(std::ranges::any_of(result.remarks, [](const std::string& remark) {
            return contains(remark, "had compressed are written as");
          }) == (coding != MeshCoding::plain));
    std::map<std::string, std::string> written;
    for (const auto& each : std::filesystem::directory_iterator(out))
      if (each.path().extension() == ".png")
        written[each.path().filename().string()] = slurp(each.path().string());
    if (has_validator()) CHECK(validator_errors(out + "/scene.gltf", {out}) == "");
    if (coding == MeshCoding::plain) {
      pages = written;
      said = told(said_of(file));
      CHECK(!pages.empty());
    }
    CHECK(written == pages);
    CHECK(text_of(told(said_of(file))) == text_of(said));
  }
}
