// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "core/pack/pack.h"
#include "core/scene/gltf.h"
#include "core/scene/gltf_convert.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::array<double, 3> codes_of_linear(const std::array<double, 3>& linear) {
  std::array<double, 3> out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = 255 * srgb_encode(linear[c]);
  return out;
}

// What a triangle's corner looks like: diffuse, alpha, F0 and roughness in codes.
struct Look {
  std::array<double, 8> codes{};
};

Look look_of(const GltfMaterial& m, const MaterialPair& pair, const std::array<float, 2>& uv, Filter filter) {
  Look out;
  const GltfTexture* lead = leading_texture(m);
  const GltfTexture any = lead ? *lead : GltfTexture{};
  const auto a = lookup(pair.diffuse_alpha, any, uv, filter),
             b = lookup(pair.specular_gloss, any, uv, filter);
  for (std::size_t c = 0; c < 4; ++c) out.codes[c] = a[c], out.codes[4 + c] = b[c];
  if (m.alpha_mode == AlphaMode::opaque) out.codes[3] = 255;
  out.codes[7] = 255 - out.codes[7];
  return out;
}

// The same from the packed scene, whose material reads several page pictures with factors.
Look packed_look(const GltfMaterial& m, ReadPictures& pictures, const std::array<float, 2>& uv,
                 Filter filter) {
  Look out;
  const auto base = codes_of_linear({m.base_color[0], m.base_color[1], m.base_color[2]});
  const auto f0 = codes_of_linear({m.specular_color[0], m.specular_color[1], m.specular_color[2]});
  for (std::size_t c = 0; c < 3; ++c) out.codes[c] = base[c], out.codes[4 + c] = f0[c];
  out.codes[3] = m.alpha_mode == AlphaMode::opaque ? 255 : 255 * m.base_color[3];
  out.codes[7] = 255 * m.roughness;
  if (m.base_color_texture) {
    const auto a = lookup(pictures(m.base_color_texture->image), *m.base_color_texture, uv, filter);
    for (std::size_t c = 0; c < 3; ++c) out.codes[c] = a[c];
    if (m.alpha_mode != AlphaMode::opaque) out.codes[3] = a[3];
  }
  if (m.specular_color_texture) {
    const auto b = lookup(pictures(m.specular_color_texture->image), *m.specular_color_texture, uv, filter);
    for (std::size_t c = 0; c < 3; ++c) out.codes[4 + c] = b[c];
  }
  if (m.metallic_roughness_texture) {
    const Image8& rough = pictures(m.metallic_roughness_texture->image);
    // Of a grey picture the one channel is green as well.
    const std::size_t green = rough.channels < 3 ? 0 : 1;
    out.codes[7] = lookup(rough, *m.metallic_roughness_texture, uv, Filter::codes)[green];
  }
  return out;
}

double most_codes(const Look& x, const Look& y) {
  double worst = 0;
  for (std::size_t c = 0; c < 8; ++c) worst = std::max(worst, std::abs(x.codes[c] - y.codes[c]));
  return worst;
}

// CIEDE2000 of both colours; alpha and roughness in percent.
double most_delta_e(const Look& x, const Look& y) {
  double worst = 0;
  for (const std::size_t first : {0u, 4u}) {
    const auto lab = [&](const Look& look) {
      const auto linear = [&](std::size_t c) { return srgb_decode(look.codes[first + c] / 255); };
      return to_lab(LinearRgb{linear(0), linear(1), linear(2)});
    };
    worst = std::max(
        {worst, delta_e2000(lab(x), lab(y)), 100 * std::abs(x.codes[first + 3] - y.codes[first + 3]) / 255});
  }
  return worst;
}

// Largest difference between a scene and its packed form over the corners and centres of triangles.
double worst_difference(const std::string& path, const std::string& packed_path,
                        double (*difference)(const Look&, const Look&) = most_codes,
                        Filter filter = Filter::codes) {
  const GltfScene before = read_gltf(path, {}), after = read_gltf(packed_path, {});
  REQUIRE(before.uses.size() == after.uses.size());
  ReadPictures old_pictures(before), new_pictures(after);
  std::map<int, MaterialPair> pairs;
  double worst = 0;
  for (std::size_t u = 0; u < before.uses.size(); ++u) {
    const GltfUse &from = before.uses[u], &to = after.uses[u];
    const GltfMaterial& m = before.materials[static_cast<std::size_t>(from.material)];
    const GltfMaterial& p = after.materials[static_cast<std::size_t>(to.material)];
    REQUIRE(m.name == p.name);
    auto [pair, fresh] = pairs.try_emplace(from.material);
    std::size_t clamped = 0;
    if (fresh)
      pair->second = scene_material_pair<std::uint8_t>(
          m, [&](int image) -> const Image8& { return old_pictures(image); }, GlossForm::one_minus_roughness,
          false, clamped);
    const GltfTexture *lead = leading_texture(m), *new_lead = leading_texture(p);
    if (lead == nullptr) continue;
    const auto& old_uvs = from.uv[lead->uv_set];
    const auto& new_uvs = to.uv[new_lead == nullptr ? lead->uv_set : new_lead->uv_set];
    REQUIRE(old_uvs.size() == new_uvs.size());
    for (std::size_t t = 0; t < old_uvs.size(); t += std::max<std::size_t>(1, old_uvs.size() / 4000)) {
      const auto middle = [](const std::array<std::array<float, 2>, 3>& uv) {
        return std::array<float, 2>{(uv[0][0] + uv[1][0] + uv[2][0]) / 3,
                                    (uv[0][1] + uv[1][1] + uv[2][1]) / 3};
      };
      for (int k = 0; k < 4; ++k) {
        const auto a = k < 3 ? old_uvs[t][static_cast<std::size_t>(k)] : middle(old_uvs[t]);
        const auto b = k < 3 ? new_uvs[t][static_cast<std::size_t>(k)] : middle(new_uvs[t]);
        worst = std::max(
            worst, difference(look_of(m, pair->second, a, filter), packed_look(p, new_pictures, b, filter)));
      }
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("real scenes keep at most 60 % of two full-size textures, 45 % with islands, and look the same") {
  if (!asset("")) return;
  std::map<std::string, std::uint64_t> page_texels;
  for (const bool islands : {false, true}) {
    TexelAccount before, after;
    for (const std::string& name : real_models) {
      const TempFolder folder;
      const PackResult report = pack_scene(*asset(name), folder.file("out"), islands);
      const std::uint64_t texels = report.region_texels + report.gutter_texels + report.waste_texels;
      if (!islands) page_texels[name] = texels;
      // Gutters and waste included, which is what a page costs: the mixer's islands would take more than its crop.
      CHECK(texels <= page_texels[name]);
      const bool split = std::any_of(report.left_out.lines.begin(), report.left_out.lines.end(),
                                     [](const LeaveOutLine& line) { return line.what == "islands"; });
      CHECK(split == (islands && name != "mixer/Mixer.gltf"));
      if (!islands || split) {
        before.channel_texels += report.left_out.before.channel_texels;
        after.channel_texels += report.left_out.after.channel_texels;
      }
      INFO(name << (islands ? " with islands" : ""));
      CHECK(worst_difference(*asset(name), folder.file("out/scene.gltf")) <= 1);
    }
    const double share =
        static_cast<double>(after.channel_texels) / static_cast<double>(before.channel_texels);
    CHECK(share <= (islands ? 0.45 : 0.60));
  }
}

TEST_CASE("every planted fact of the synthetic scene is found") {
  if (!asset("")) return;
  const TempFolder folder;
  const PackResult report = pack_scene(*asset("synthetic_a/scene.gltf"), folder.file("out"), false);
  const AtlasLayout layout = parse_layout(slurp(folder.file("out/layout.json")), "layout.json");
  const auto row = [&](const std::string& name) {
    const auto found = std::find_if(layout.materials.begin(), layout.materials.end(),
                                    [&](const auto& m) { return m.name == name; });
    REQUIRE(found != layout.materials.end());
    return *found;
  };
  const auto rect = [&](const std::string& name) {
    const auto found =
        std::find_if(layout.rects.begin(), layout.rects.end(), [&](const auto& r) { return r.name == name; });
    REQUIRE(found != layout.rects.end());
    return *found;
  };
  // One material is not reached, two are of one colour, two have the same pixels, one tiles.
  CHECK(std::none_of(layout.materials.begin(), layout.materials.end(),
                     [](const auto& m) { return m.name == "m07"; }));
  CHECK_FALSE(row("m01").texels);
  CHECK_FALSE(row("m02").texels);
  const std::array<int, 8> flat{220, 48, 148, 255, 56, 56, 56, 36};
  for (std::size_t c = 0; c < channel_count; ++c) CHECK(row("m01").constant[c] == flat[c]);
  CHECK(rect("m06").x == rect("m14").x);
  CHECK(rect("m06").y == rect("m14").y);
  CHECK(rect("m16").repeats);
  // What varies and what does not, channel by channel.
  const auto varying = [&](const std::string& name) {
    std::string out;
    const AtlasMaterialRow found = row(name);
    for (std::size_t c = 0; c < channel_count; ++c) out += found.constant[c] ? '-' : "rgbaRGBg"[c];
    return out;
  };
  CHECK(varying("m00") == "rgb----g");
  CHECK(varying("m03") == "rgb-----");
  CHECK(varying("m04") == "rgba---g");
  CHECK(varying("m05") == "----RGBg");
  CHECK(varying("m06") == "rgb-RGBg");
  CHECK(varying("m08") == "----RGBg");
  CHECK(varying("m09") == "rgb----g");
  CHECK(varying("m10") == "rgb-RGBg");
  CHECK(varying("m17") == "rgb----g");
  CHECK(row("m17").constant[4] == 54);
  CHECK(row("m03").constant[7] == 104);
  // Boxes: half of the picture each way, and a quarter by a half; one texel more on each side is filtered.
  // Boxes of 128 texels and more keep three levels clean, and grow outwards to their texels.
  const auto in_fours = [](int from, int size, int planted) {
    return from % 4 == 0 && size % 4 == 0 && size >= planted && size <= planted + 2 + 2 * 3;
  };
  CHECK(in_fours(rect("m11").crop.x, rect("m11").crop.width, 128));
  CHECK(in_fours(rect("m11").crop.y, rect("m11").crop.height, 128));
  CHECK(std::abs(rect("m13").crop.width - 32) <= 2);
  CHECK(std::abs(rect("m13").crop.height - 64) <= 2);
  CHECK(report.left_out.after.texels < report.left_out.before.texels);
  CHECK(worst_difference(*asset("synthetic_a/scene.gltf"), folder.file("out/scene.gltf")) <= 1);
}

TEST_CASE("equal textures of different files, workflows, F0 and tiling are stored once, and look the same") {
  const TempFolder folder;
  const Image8 picture = noise(64, 64, 3, 5);
  save_png(folder.file("a.png"), picture);
  PngOptions small;
  small.level = PngLevel::smallest;
  const std::string other = png_bytes({{64, 64, 3, 8}, picture.values.data(), 192}, small);
  spit(folder.file("b.png"), other);
  spit(folder.file("c.png"), other + "tail that no decoder reads");
  // One quad per UV extent: a quarter of the picture and three periods of it.
  std::string buffer;
  for (const float most : {0.5f, 3.0f})
    for (const float v : {0.f, 0.f, most, 0.f, 0.f, most})
      buffer.append(reinterpret_cast<const char*>(&v), 4);
  buffer.append(36, '\0');
  spit(folder.file("scene.bin"), buffer);
  const auto material = [](const std::string& name, const std::string& rest) {
    return R"({"name": ")" + name + R"(", )" + rest + "}";
  };
  const std::string rough = R"("metallicFactor": 0, "roughnessFactor": 0.85)";
  const std::string materials =
      material("one", R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, )" + rough + "}") + ", " +
      material("ior", R"("extensions": {"KHR_materials_ior": {"ior": 1.4}}, )"
                      R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 1}, )" +
                          rough + "}") +
      ", " +
      material("specular", R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseTexture": )"
                           R"({"index": 2}, "specularFactor": [0.1, 0.2, 0.3], "glossinessFactor": 0.5}})");
  std::string meshes, nodes, roots;
  for (int i = 0; i < 4; ++i) {
    const std::string comma = i == 0 ? "" : ", ", uv = i == 3 ? "2" : "1", m = std::to_string(i % 3);
    meshes += comma + R"({"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": )" + uv +
              R"(}, "material": )" + m + "}]}";
    nodes += comma + R"({"mesh": )" + std::to_string(i) + "}";
    roots += comma + std::to_string(i);
  }
  spit(folder.file("scene.gltf"),
       R"({"asset": {"version": "2.0"}, "scene": 0, "extensionsUsed": ["KHR_materials_ior",
        "KHR_materials_pbrSpecularGlossiness"], "scenes": [{"nodes": [)" +
           roots + R"(]}], "nodes": [)" + nodes + R"(], "meshes": [)" + meshes + R"(], "materials": [)" +
           materials +
           R"(], "images": [{"uri": "a.png"}, {"uri": "b.png"}, {"uri": "c.png"}],
        "textures": [{"source": 0}, {"source": 1}, {"source": 2}],
        "buffers": [{"uri": "scene.bin", "byteLength": 84}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 36}],
        "accessors": [
          {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
          {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"},
          {"bufferView": 0, "byteOffset": 24, "componentType": 5126, "count": 3, "type": "VEC2"}]})");
  for (const bool tiles : {false, true}) {
    if (!tiles) {  // without the one whose UVs tile
      std::string text = slurp(folder.file("scene.gltf"));
      text.replace(text.find("[0, 1, 2, 3]"), 12, "[0, 1, 2]");
      spit(folder.file("three.gltf"), text);
    }
    INFO((tiles ? "tiling" : "one period"));
    const std::string scene = folder.file(tiles ? "scene.gltf" : "three.gltf"),
                      out = folder.file(tiles ? "tiled" : "out");
    const PackResult report = pack_scene(scene, out, false);
    const AtlasLayout layout = parse_layout(slurp(out + "/layout.json"), "layout.json");
    CHECK(report.regions == 1);
    REQUIRE(layout.rects.size() == 3);
    for (const AtlasRect& rect : layout.rects) {
      CHECK(rect.x == layout.rects[0].x);
      CHECK(rect.width == (tiles ? 64 : 34));  // 33 are read, and two of its mips are whole texels
      CHECK(rect.repeats == tiles);
    }
    CHECK(layout.pages[0].files[1].empty());  // F0 and gloss are numbers, each material's own
    CHECK(layout.materials[0].constant[4] == 56);
    CHECK(layout.materials[1].constant[4] != 56);
    CHECK(worst_difference(scene, out + "/scene.gltf") <= 1);
  }
}

TEST_CASE("a scene packed with everything kept keeps everything") {
  if (!asset("")) return;
  const TempFolder folder;
  PackOptions options;
  options.leave_out.keep = parse_keep({"all"});
  const PackResult report =
      pack(*asset("synthetic_a/scene.gltf"), folder.file("out"), options, test::library());
  CHECK(report.left_out.lines.empty());
  CHECK(report.left_out.before == report.left_out.after);
}

TEST_CASE("a real scene with fewer texels looks the same within the bound") {
  if (!asset("")) return;
  const double bound = 20;
  const TempFolder folder;
  PackOptions options;
  options.leave_out.max_error = bound;
  const std::string scene = *asset("tennis_racquet/TennisRacquet.gltf");
  const PackResult report = pack_scene(scene, folder.file("out"), false, options);
  CHECK(report.reduced.size() >= 1);
  for (const ReducedRegion& each : report.reduced) CHECK(each.seen_delta_e <= bound);
  const double worst = worst_difference(scene, folder.file("out/scene.gltf"), most_delta_e, Filter::light);
  CHECK(worst <= bound + 0.05);
  CHECK(worst > 0.5);
}
