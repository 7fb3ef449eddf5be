// SPDX-License-Identifier: Apache-2.0
// What belongs together and what of it counts: split metal-rough sets, the texels a scene reads, and numbers
// that an atlas holds in place of texels.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "core/base/bytes/base64.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/validate/files/layout_targets.h"
#include "core/validate/files/load.h"
#include "core/validate/files/metal_rough.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

void save(const std::string& path, const Image8& image) {
  spit(path, png_bytes({{image.width, image.height, image.channels, 8},
                        image.values.data(),
                        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels)},
                       {}));
}

bool has(const CheckedFile& file, std::string_view rule) {
  return std::ranges::find(file.findings, rule, &Finding::rule) != file.findings.end();
}

std::string said(const CheckedFile& file) {
  std::string out;
  for (const Finding& f : file.findings)
    if (f.rule > "ETK100") out += f.rule + " " + f.tile + " " + f.message + "\n";
  return out;
}

Image8 flat(int width, int height, const std::vector<std::uint8_t>& codes) {
  Image8 out(width, height, static_cast<int>(codes.size()));
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = codes[i % codes.size()];
  return out;
}

// A quad over the left half of its texture, whose base colour is a dielectric's, but for a square of metal
// with F0 in the forbidden zone at column `x`.
std::string half_used_scene(const TempFolder& folder, int x, const char* alpha_mode) {
  Image8 color = flat(64, 64, {140, 120, 100, 255}), metal_rough = flat(64, 64, {0, 128, 0});
  for (int row = 20; row < 44; ++row)
    for (int column = x; column < x + 24; ++column) {
      const auto texel = color.at(column, row);
      std::fill(texel.begin(), texel.begin() + 3, std::uint8_t{150});  // F0 0.305
      metal_rough.at(column, row)[2] = 255;
    }
  save(folder.file("color.png"), color);
  save(folder.file("mr.png"), metal_rough);
  const std::array<float, 20> numbers{0, 0, 0,     1, 0, 0, 0,     1, 0, 1, 1, 0,  // positions
                                      0, 0, 0.48f, 0, 0, 1, 0.48f, 1};             // UVs
  std::string buffer(sizeof numbers, '\0');
  std::memcpy(buffer.data(), numbers.data(), buffer.size());
  const std::array<std::uint16_t, 6> corners{0, 1, 2, 2, 1, 3};
  std::string indices(sizeof corners, '\0');
  std::memcpy(indices.data(), corners.data(), indices.size());
  buffer += indices;
  const std::string path = folder.file("scene.gltf");
  spit(path, R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
    "materials": [{"name": "half", "alphaMode": ")" +
                 std::string(alpha_mode) + R"(", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
      "metallicRoughnessTexture": {"index": 1}}}],
    "textures": [{"source": 0}, {"source": 1}], "images": [{"uri": "color.png"}, {"uri": "mr.png"}],
    "buffers": [{"byteLength": )" +
                 std::to_string(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
                 base64(buffer) + R"("}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
      {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
  return path;
}

CheckedFile check_file(FileRole role, const std::string& path) {
  CheckTarget target;
  target.files = {{role, path, "scene.gltf", false}};
  return checked(target, {});
}

}  // namespace

TEST_CASE("metallic and roughness in files of their own are judged as one metal-rough file is") {
  const TempFolder folder;
  const int side = 96;
  Image8 color = flat(side, side, {150, 150, 150, 255}), both = flat(side, side, {0, 100, 0});
  Image8 metallic = flat(side, side, {0}), roughness = flat(side, side, {100});
  Random random(3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::uint8_t rough = static_cast<std::uint8_t>(80 + random.below(40));
      both.at(x, y)[1] = roughness.at(x, y)[0] = rough;
      if (x >= 20 && x < 60 && y >= 20 && y < 60) both.at(x, y)[2] = metallic.at(x, y)[0] = 255;
    }
  save(folder.file("color.png"), color);
  save(folder.file("both.png"), both);
  save(folder.file("metallic.png"), metallic);
  save(folder.file("roughness.png"), roughness);
  const auto target = [&](std::vector<std::pair<FileRole, std::string>> files) {
    CheckTarget out;
    out.files.push_back({FileRole::base_color, folder.file("color.png"), "color.png", false});
    for (const auto& [role, name] : files) out.files.push_back({role, folder.file(name), name, false});
    return out;
  };
  const CheckedFile one = checked(target({{FileRole::metal_rough, "both.png"}}), {});
  const CheckedFile split =
      checked(target({{FileRole::metallic, "metallic.png"}, {FileRole::roughness, "roughness.png"}}), {});
  INFO(said(one) << "---\n" << said(split));
  CHECK(has(one, "ETK101"));
  CHECK(said(split) == said(one));
  CHECK(split.counts == one.counts);
  // Half the size says the same of the mask: the texel under the centre is taken.
  Image8 small(side / 2, side / 2, 1);
  for (int y = 0; y < side / 2; ++y)
    for (int x = 0; x < side / 2; ++x) small.at(x, y)[0] = metallic.at(2 * x, 2 * y)[0];
  save(folder.file("metallic.png"), small);
  const CheckedFile mixed =
      checked(target({{FileRole::metallic, "metallic.png"}, {FileRole::roughness, "roughness.png"}}), {});
  CHECK(said(mixed) == said(one));
}

TEST_CASE("packed pictures are read by their channels, and smoothness is turned round") {
  const TempFolder folder;
  const int side = 96;
  Image8 color = flat(side, side, {150, 150, 150, 255}), gltf = flat(side, side, {255, 100, 0});
  Random random(5);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      gltf.at(x, y)[1] = static_cast<std::uint8_t>(80 + random.below(40));
      if (x >= 20 && x < 60 && y >= 20 && y < 60) gltf.at(x, y)[2] = 255;
    }
  save(folder.file("color.png"), color);
  save(folder.file("gltf.png"), gltf);
  const auto judged = [&](const std::vector<TargetFile>& parts) {
    CheckTarget target;
    target.files = {{FileRole::base_color, folder.file("color.png"), "color.png", false}};
    target.files.insert(target.files.end(), parts.begin(), parts.end());
    return checked(target, {});
  };
  const CheckedFile plain =
      judged({{FileRole::metal_rough, folder.file("gltf.png"), "packed.png", false, "orm-"}});
  CHECK(has(plain, "ETK101"));
  for (const std::string letters : {"-rm-", "rmo-", "mro-", "rom-", "mo-s", "m--s", "s--m"}) {
    Image8 packed(side, side, 4);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (std::size_t c = 0; c < 4; ++c) {
          const auto from = gltf.at(x, y);
          packed.at(x, y)[c] = letters[c] == 'm'   ? from[2]
                               : letters[c] == 'r' ? from[1]
                               : letters[c] == 's' ? static_cast<std::uint8_t>(255 - from[1])
                                                   : std::uint8_t{37};
        }
    save(folder.file("packed.png"), packed);
    const CheckedFile file =
        judged({{FileRole::metal_rough, folder.file("packed.png"), "packed.png", false, letters}});
    INFO(letters << "\n" << said(file));
    // The other channels are constant, which is a finding where one of them is said to be occlusion.
    const bool has_occlusion = letters.find('o') != letters.npos;
    CHECK(said(file) ==
          said(plain) + (has_occlusion ? "ETK711  every texel that was looked at is code 37\n" : ""));
    CHECK(file.counts == plain.counts);
  }
  // A gloss file beside a packed one that has metallic alone.
  Image8 gloss(side, side, 1), metallic(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      gloss.at(x, y)[0] = static_cast<std::uint8_t>(255 - gltf.at(x, y)[1]);
      metallic.at(x, y)[0] = gltf.at(x, y)[2];
    }
  save(folder.file("gloss.png"), gloss);
  save(folder.file("metallic.png"), metallic);
  CHECK(judged({{FileRole::metallic, folder.file("metallic.png"), "metallic.png", false},
                {FileRole::gloss, folder.file("gloss.png"), "gloss.png", false}})
            .counts == plain.counts);
}

TEST_CASE("gloss or roughness in a file of its own is judged as the fourth channel of specular is") {
  const TempFolder folder;
  const int side = 96;
  Image8 diffuse = flat(side, side, {120, 110, 100, 255}), both = flat(side, side, {56, 56, 56, 0}),
         specular = flat(side, side, {56, 56, 56}), gloss(side, side, 1), roughness(side, side, 1);
  Random random(9);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x >= 20 && x < 60 && y >= 20 && y < 60)
        for (std::size_t c = 0; c < 3; ++c) both.at(x, y)[c] = specular.at(x, y)[c] = 150;
      const auto code = static_cast<std::uint8_t>(80 + random.below(90));
      both.at(x, y)[3] = gloss.at(x, y)[0] = code;
      roughness.at(x, y)[0] = static_cast<std::uint8_t>(255 - code);
    }
  for (const auto& [name, image] : {std::pair("diffuse.png", &diffuse),
                                    {"both.png", &both},
                                    {"specular.png", &specular},
                                    {"gloss.png", &gloss},
                                    {"roughness.png", &roughness}})
    save(folder.file(name), *image);
  const auto judged = [&](const char* second, std::vector<TargetFile> third) {
    CheckTarget target;
    target.files = {{FileRole::diffuse_alpha, folder.file("diffuse.png"), "diffuse.png", false},
                    {FileRole::specular_gloss, folder.file(second), "specular.png", false}};
    target.files.insert(target.files.end(), third.begin(), third.end());
    return checked(target, {});
  };
  const CheckedFile pair = judged("both.png", {});
  CHECK(has(pair, "ETK101"));
  for (const auto& [role, name] :
       {std::pair(FileRole::gloss, "gloss.png"), std::pair(FileRole::roughness, "roughness.png")}) {
    const CheckedFile split = judged("specular.png", {{role, folder.file(name), name, false}});
    INFO(name << "\n" << said(split) << "---\n" << said(pair));
    CHECK(said(split) == said(pair));
    CHECK(split.counts == pair.counts);
    CHECK_FALSE(has(split, "ETK004"));
    CHECK_FALSE(has(split, "ETK002"));
  }
}

TEST_CASE("a metal-rough set read in strips says what the whole says, for any number of threads") {
  const TempFolder folder;
  const int width = 2048, height = 150;  // three strips, the last one shorter
  Image8 color = flat(width, height, {0, 0, 0}), metallic = flat(width, height, {0}),
         roughness = flat(width, height, {0});
  Random random(11);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool zone = x >= 1200 && x < 1300 && y >= 50 && y < 140;
      set_rgb(color.at(x, y), zone ? std::array{150, 150, 150} : std::array{120 + random.below(9), 100, 90});
      metallic.at(x, y)[0] = zone ? 255 : 0;
      roughness.at(x, y)[0] = static_cast<std::uint8_t>(90 + random.below(30));
    }
  save(folder.file("color.png"), color);
  save(folder.file("metallic.png"), metallic);
  save(folder.file("roughness.png"), roughness);
  CheckTarget target;
  target.files = {{FileRole::base_color, folder.file("color.png"), "color.png", false},
                  {FileRole::metallic, folder.file("metallic.png"), "metallic.png", false},
                  {FileRole::roughness, folder.file("roughness.png"), "roughness.png", false}};
  const PictureDoor door = picture_door();
  CHECK(MetalRoughSet(target, door).rows().b != nullptr);
  const Pictures loaded = load_pictures(target, door);
  CheckTarget weighed = target;
  weighed.manifest.specular_weighs_diffuse = true;
  const CheckedFile whole = check_pictures(weighed, loaded, {});
  CHECK(has(whole, "ETK101"));
  for (const unsigned threads : {1u, 3u}) {
    const CheckedFile strips = checked(target, {}, threads);
    CHECK(strips.counts == whole.counts);
    CHECK(strips.plateau_px == whole.plateau_px);
    for (const std::string_view rule : {"ETK101", "ETK102", "ETK302", "ETK406"})
      CHECK(has(strips, rule) == has(whole, rule));
  }
  // What ends too early is unreadable, whichever of the three asks first.
  const std::string bytes = slurp(folder.file("metallic.png"));
  spit(folder.file("metallic.png"), bytes.substr(0, bytes.size() / 2));
  for (const unsigned threads : {1u, 3u}) {
    const CheckedFile broken = checked(target, {}, threads);
    CHECK(broken.unreadable);
    CHECK(has(broken, "ETK001"));
  }
}

TEST_CASE("texels that no triangle reads give no finding") {
  for (const char* mode : {"OPAQUE", "MASK", "BLEND"}) {
    const TempFolder folder;
    const CheckedFile used = check_file(FileRole::scene, half_used_scene(folder, 4, mode));
    INFO(mode << "\n" << said(used));
    CHECK(has(used, "ETK101"));
    const CheckedFile unused = check_file(FileRole::scene, half_used_scene(folder, 36, mode));
    INFO(said(unused));
    CHECK_FALSE(has(unused, "ETK101"));
    CHECK_FALSE(has(unused, "ETK102"));
    CHECK_FALSE(has(unused, "ETK502"));
    CHECK_FALSE(unused.unreadable);
  }
}

TEST_CASE("numbers that a layout holds in place of texels are judged like texels") {
  const TempFolder folder;
  Image8 page = flat(64, 64, {120, 110, 100, 255});
  save(folder.file("page0.png"), page);
  const auto layout = [](const char* specular_code) {
    const std::string f0 = std::string("\"specular_r\": ") + specular_code +
                           ", \"specular_g\": " + specular_code + ", \"specular_b\": " + specular_code +
                           ", \"gloss\": 128";
    return R"({"pages": [{"diffuse_alpha": "page0.png", "specular_gloss": null}],
      "rects": [{"name": "wall", "x": 0, "y": 0, "w": 64, "h": 64, "page": 0, "gutter": 0, "mips": 1}],
      "materials": [{"name": "wall", "texels": true, "constant": {)" +
           f0 + R"(}},
        {"name": "door", "texels": false, "constant": {"diffuse_r": 90, "diffuse_g": 80, "diffuse_b": 70, "alpha": 255, )" +
           f0 + "}}]}";
  };
  const auto judged = [&](const char* code) {
    std::vector<CheckedFile> out;
    for (const CheckTarget& target :
         targets_of_layout_text(layout(code), folder.file("layout.json"), "layout.json"))
      out.push_back(checked(target, {}));
    return out;
  };
  const std::vector<CheckedFile> bad = judged("150"), good = judged("56");
  REQUIRE(bad.size() == 2);
  for (const CheckedFile& file : bad) {
    INFO(said(file));
    REQUIRE(has(file, "ETK101"));
    const Finding& zone = *std::ranges::find(file.findings, "ETK101", &Finding::rule);
    CHECK(zone.tile == (file.path == "layout.json" ? "door" : "wall"));
    CHECK(zone.box.has_value() == (zone.tile == "wall"));
  }
  for (const CheckedFile& file : good)
    for (const Finding& finding : file.findings) {
      INFO(finding.rule << ' ' << finding.message);
      CHECK(finding.severity < Severity::warning);
    }
}

TEST_CASE("pictures that a manifest of the packer names are not called unknown") {
  const TempFolder folder;
  save(folder.file("gold_gloss.png"), flat(8, 8, {120}));
  const auto report = [&] {
    ValidationRequest request;
    request.inputs.paths = {folder.path()};
    request.config.root = folder.path();
    request.run.door = picture_door();
    return validate(std::move(request));
  };
  CHECK(report().unknown == std::vector<std::string>{"gold_gloss.png"});
  spit(folder.file("manifest.json"), R"({"schema": "etak-atlas-manifest/1", "materials": [
    {"name": "gold", "diffuse": 0, "specular": "gold", "gloss": {"image": "gold_gloss.png"}}]})");
  CHECK(report().unknown.empty());
  ValidationRequest request;
  request.inputs.paths = {folder.path()};
  request.config.root = folder.path();
  const FileList list = list_files(std::move(request));
  REQUIRE(list.files.size() == 1);
  CHECK(list.files[0].as == ListedAs::not_judged);
}

TEST_CASE("the occlusion that a packed picture is named for is judged like a map of its own") {
  const TempFolder folder;
  Random random(8);
  const int size = 64;
  Image8 color(size, size, 3), open(size, size, 3);
  each_texel(color, [&](auto texel, int, int) {
    const int value = 100 + random.below(60);
    set_rgb(texel, {value, value, value});
  });
  each_texel(open, [&](auto texel, int, int) {
    const int occlusion = 255 - random.below(random.below(4) == 0 ? 200 : 30);
    set_rgb(texel, {occlusion, 120 + random.below(60), 0});
  });
  const auto with = [&](auto occlusion) {
    Image8 out = open;
    each_texel(out, [&](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(occlusion(texel[0])); });
    return out;
  };
  save(folder.file("wall_basecolor.png"), color);
  const auto judged_with = [&](const Image8& packed, const char* name) {
    const std::string path = folder.file(std::string(name) + ".png");
    save(path, packed);
    CheckTarget target;
    target.files = {{FileRole::base_color, folder.file("wall_basecolor.png"), "wall_basecolor.png"},
                    {FileRole::metal_rough, path, "wall_orm.png", false, "orm-"}};
    return checked(target);
  };
  for (const char* rule : {"ETK711", "ETK712"}) CHECK_FALSE(has(judged_with(open, "open"), rule));
  CHECK_FALSE(has(judged_with(with([](int) { return 255; }), "white"), "ETK711"));
  const CheckedFile dark = judged_with(with([](int) { return 0; }), "dark");
  INFO(said(dark));
  REQUIRE(find(dark, "ETK711") != nullptr);
  CHECK(find(dark, "ETK711")->severity == Severity::warning);
  CHECK(find(dark, "ETK711")->file == "wall_orm.png");
  const CheckedFile inverted = judged_with(with([](int code) { return 255 - code; }), "inverted");
  INFO(said(inverted));
  CHECK(has(inverted, "ETK712"));
}
