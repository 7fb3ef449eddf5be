// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/project/project_pictures.h"
#include "tests/core/atlas/blocks_support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int kept_side = 8;

// A material whose channels have pictures where the bits of `textured` are set.
ProjectMaterial pictured(const TempFolder& folder, unsigned textured) {
  ProjectMaterial out;
  out.name = "m";
  for (const Channel channel : all_channels) {
    if ((textured >> static_cast<unsigned>(channel) & 1U) == 0) continue;
    const std::string file = folder.file(std::string(name(channel)) + ".png");
    const bool grey = !is_color(channel);
    save_png(file, noise(kept_side, kept_side, grey ? 1 : 3, 5 + static_cast<unsigned>(channel)));
    out.texture(channel) = ImageSource{file, "", ""};
  }
  return out;
}

PictureReading reading() {
  return {std::nullopt, picture_door(), {}, {}};
}

// Leaves a file as old and as large as it is, but no picture any more: whoever reads it finds out.
void spoil(const std::string& file) {
  const auto age = std::filesystem::last_write_time(file);
  spit(file, std::string(std::filesystem::file_size(file), 'x'));
  std::filesystem::last_write_time(file, age);
}

MaterialPair kept_pair(KeptPictures& kept, const ProjectMaterial& m) {
  MaterialPair out;
  kept.use(m, built_in_library(), picture_door(), 0, [&](MaterialPair& pair) { out = pair; });
  return out;
}

bool same_pair(const MaterialPair& a, const MaterialPair& b) {
  return a.diffuse_alpha.values == b.diffuse_alpha.values &&
         a.specular_gloss.values == b.specular_gloss.values && a.diffuse_alpha.width == b.diffuse_alpha.width;
}

}  // namespace

TEST_CASE("kept pictures give the pair of changed numbers, byte for byte, and read no file") {
  for (unsigned textured = 1; textured < 16; ++textured)
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
      INFO("channels " << textured << ", mode " << name(mode));
      const TempFolder folder;
      ProjectMaterial m = pictured(folder, textured);
      m.alpha_mode = mode;
      ProjectMaterial other = m;
      other.diffuse = {0.1, 0.4, 0.7};
      other.specular = {0.5, 0.3, 0.2};
      other.gloss = Gloss::of_roughness(0.4);
      other.alpha = 0.3;
      const MaterialPair expected = pictures_of(other, built_in_library(), {});
      KeptPictures kept;
      CHECK(same_pair(kept_pair(kept, m), pictures_of(m, built_in_library(), {})));
      for (const auto& texture : m.textures)
        if (texture) spoil(texture->path);
      CHECK(same_pair(kept_pair(kept, other), expected));
      // What the one who uses them does to channels without pictures, the next one does not see.
      kept.use(other, built_in_library(), {}, 0, [&](MaterialPair& pair) {
        if (m.texture(Channel::gloss)) return;
        for (std::size_t i = 3; i < pair.specular_gloss.values.size(); i += 4)
          pair.specular_gloss.values[i] = 1;
      });
      CHECK(same_pair(kept_pair(kept, other), expected));
    }
}

TEST_CASE("pictures are read again where a file, the mode or another material asks for it") {
  const TempFolder folder;
  ProjectMaterial m = pictured(folder, 0b0101);
  KeptPictures kept;
  (void)kept_pair(kept, m);
  const std::string gloss = m.texture(Channel::gloss)->path;
  save_png(gloss, noise(kept_side, kept_side, 1, 77));
  std::filesystem::last_write_time(gloss, std::filesystem::last_write_time(gloss) + std::chrono::seconds(9));
  CHECK(same_pair(kept_pair(kept, m), pictures_of(m, built_in_library(), {})));
  m.texture(Channel::gloss).reset();
  CHECK(same_pair(kept_pair(kept, m), pictures_of(m, built_in_library(), {})));
  spoil(m.texture(Channel::diffuse)->path);
  m.alpha_mode = AlphaMode::mask;
  CHECK(!error_of([&] { (void)kept_pair(kept, m); }).empty());
}

TEST_CASE("textures for the viewport hold the channels that have a picture") {
  for (unsigned textured = 0; textured < 16; ++textured) {
    const TempFolder folder;
    ProjectMaterial m = pictured(folder, textured);
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend}) {
      m.alpha_mode = mode;
      const SurfaceTextures seen = surface_textures(m, pictures_of(m, built_in_library(), {}), {}, 64);
      CHECK(seen.has.diffuse == ((textured & 1) != 0));
      CHECK(seen.has.f0 == ((textured & 2) != 0));
      CHECK(seen.has.gloss == ((textured & 4) != 0));
      CHECK(seen.has.opacity == ((textured & 8) != 0 && mode == AlphaMode::blend));
      // A texture that holds nothing is no larger than it must be.
      CHECK(seen.gloss.width == ((textured & 6) != 0 ? kept_side : 1));
    }
  }
}

TEST_CASE(
    "textures in blocks are those that pack() writes within the budget, with halves of their own, and flat ones stay") {
  const TempFolder folder;
  const std::string manifest = manifest_of({blocks_material(folder, "a", 64, 64, 1, 0)});
  const PackResult packed = pack_text(folder, manifest, in_blocks("bc7", {"ktx2"}));
  ProjectMaterial m;
  m.name = "a";
  for (const Channel channel : {Channel::diffuse, Channel::specular, Channel::gloss})
    m.texture(channel) = ImageSource{folder.file("a_" + std::string(name(channel)) + ".png"), "", ""};
  const SurfaceTextures exact = read_surface_textures(m, built_in_library(), {}, 1024).textures;
  const SurfaceInBlocks held = surface_in_blocks(exact, m);
  for (const Texture texture : both_textures) {
    const Image8 page = ktx2_page(folder, std::string(name(texture))).levels[0];
    REQUIRE((page.width == 64 && page.height == 64));
    const Channel colour = texture == Texture::diffuse_alpha ? Channel::diffuse : Channel::specular,
                  fourth = texture == Texture::diffuse_alpha ? Channel::alpha : Channel::gloss;
    const Image8 colours = channel_picture(*held.textures, colour),
                 numbers = channel_picture(*held.textures, fourth);
    std::size_t others = 0;
    for (std::size_t i = 0; i < page.pixel_count(); ++i) {
      others += numbers.values[3 * i] != page.values[4 * i + 3];
      for (std::size_t c = 0; c < 3; ++c) others += colours.values[3 * i + c] != page.values[4 * i + c];
    }
    CHECK(others == 0);
    CHECK(colours != channel_picture(exact, colour));
    const auto is = [&](const BlockLevel& each) { return each.level == 0 && each.texture == texture; };
    const auto there = std::ranges::find_if(packed.blocks, is), here = std::ranges::find_if(held.levels, is);
    CHECK(here->materials[0].colour_p99 == there->materials[0].colour_p99);
    CHECK(here->materials[0].fourth_p99 == there->materials[0].fourth_p99);
    CHECK(here->materials[0].met);
    CHECK(here->bytes == std::size_t{64 * 64});
  }
  // A half is compressed as it is where it is all that there is.
  const SurfaceInBlocks half = surface_in_blocks(*exact.half, m);
  CHECK(held.textures->half->body == half.textures->body);
  CHECK(held.textures->half->half->gloss == half.textures->half->gloss);
  CHECK(held.levels.back().level == 4);
  CHECK(held.levels.back().texels == 16);
  save_png(m.texture(Channel::diffuse)->path, Image8(64, 64, 3, 91));
  m.texture(Channel::specular).reset();
  m.texture(Channel::gloss).reset();
  const SurfaceTextures flat = read_surface_textures(m, built_in_library(), {}, 1024).textures;
  const SurfaceInBlocks same = surface_in_blocks(flat, m);
  CHECK(same.textures->body == flat.body);
  CHECK(same.levels.size() == 5);
}

TEST_CASE("emission and occlusion are a texture of their own, of another size than the packed ones") {
  const TempFolder folder;
  ProjectMaterial m = pictured(folder, 0b110001);
  save_png(m.texture(Channel::emission)->path, noise(3, 2, 3, 9));
  save_png(m.texture(Channel::occlusion)->path, noise(3, 2, 1, 8));
  const MaterialPair pair = pictures_of(m, built_in_library(), {});
  CHECK(pair.diffuse_alpha.width == kept_side);
  const SurfaceTextures seen = surface_textures(m, pair, {}, 64);
  CHECK((seen.has.diffuse && seen.has.emission && seen.has.occlusion && !seen.has.f0));
  CHECK(seen.emission.width == 3);
  CHECK(channel_picture(seen, Channel::emission).at(2, 1)[1] == noise(3, 2, 3, 9).at(2, 1)[1]);
  CHECK(channel_picture(seen, Channel::occlusion).at(2, 1)[1] == noise(3, 2, 1, 8).at(2, 1)[0]);
  // Alone, they are no reason to look for flat areas in a page of one texel.
  m.texture(Channel::diffuse).reset();
  CHECK(!has_packed_textures(m));
  CHECK(pictures_of(m, built_in_library(), {}).diffuse_alpha.width == 16);
}

TEST_CASE(
    "pictures of emission and occlusion keep what pages cannot hold, and refuse what is none of theirs") {
  const TempFolder folder;
  const auto file = [&](const char* name, const Image& image) {
    write_exr(folder.file(name), image, true, true);
    return ImageSource{folder.file(name), "", ""};
  };
  Image picture(2, 1, 3, 0.5F);
  picture.values[4] = 30;
  CHECK(emission_floats(file("e.exr", picture), "m", reading()) == picture);
  const auto refused = [&](float value, bool occlusion) {
    picture.values[3] = value;
    const ImageSource source = file("bad.exr", picture);
    const std::string message = error_of([&] {
      (void)(occlusion ? occlusion_floats(source, "m", reading()) : emission_floats(source, "m", reading()));
    });
    return message.substr(message.rfind('/') + 1);
  };
  CHECK(refused(-1, false) == "bad.exr: holds -1 as emission; expected at least 0");
  CHECK(refused(NAN, false) == "bad.exr: holds a value that is no finite number; expected finite numbers");
  CHECK(refused(1.5F, true) == "bad.exr: holds 1.5 as occlusion; expected 0 to 1");
  // Codes are sRGB, and grey ones stand for three.
  save_png(folder.file("grey.png"), Image8(1, 1, 1, 188));
  const Image grey = emission_floats({folder.file("grey.png"), "", ""}, "m", reading());
  CHECK(grey.channels == 3);
  CHECK(double{grey.values[2]} == Approx(srgb_decode(188 / 255.0)));
  CHECK(double{emission_floats({folder.file("grey.png"), "", "linear"}, "m", reading()).values[0]} ==
        Approx(188 / 255.0));
  CHECK(double{occlusion_floats({folder.file("grey.png"), "", ""}, "m", reading()).values[0]} ==
        Approx(188 / 255.0));
}

TEST_CASE("a metal-rough set comes out as diffuse, F0 and gloss, by glTF's meaning of its texels") {
  const TempFolder folder;
  ProjectMaterial m;
  m.name = "worn";
  m.diffuse = {0.9, 0.1, 0.1};  // numbers that the set replaces
  Image8 base(2, 1, 3), packed(2, 1, 3);
  base.values = {200, 100, 50, 255, 255, 255};
  packed.values = {255, 128, 0, 0, 64, 255};  // occlusion, roughness, metallic
  save_png(folder.file("base.png"), base);
  save_png(folder.file("orm.png"), packed);
  set_texture(m, Channel::diffuse, ImageSource{folder.file("base.png"), "", ""});
  set_texture(m, Channel::base_color, ImageSource{folder.file("base.png"), "", ""});
  CHECK(!m.texture(Channel::diffuse));  // a base colour takes its place
  set_texture(m, Channel::metallic, ImageSource{folder.file("orm.png"), "b", ""});
  set_texture(m, Channel::roughness, ImageSource{folder.file("orm.png"), "g", ""});
  set_texture(m, Channel::occlusion, ImageSource{folder.file("orm.png"), "r", ""});
  for (const Channel each : {Channel::diffuse, Channel::specular, Channel::gloss}) CHECK(gives(m, each));
  const MaterialPair pair = pictures_of(m, built_in_library(), picture_door());
  const auto linear = [](double code) {
    return code <= 0.04045 * 255 ? code / 255 / 12.92 : std::pow((code / 255 + 0.055) / 1.055, 2.4);
  };
  const auto code = [](double v) {
    return std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055));
  };
  const auto gloss = [](double roughness) {
    return std::lround(255 * std::clamp(std::log2(2 / std::pow(roughness, 4) - 2) / 12, 0.0, 1.0));
  };
  // The first texel is a dielectric, the second a white metal.
  for (int c = 0; c < 3; ++c) {
    CHECK(pair.diffuse_alpha.at(0, 0)[static_cast<std::size_t>(c)] ==
          base.values[static_cast<std::size_t>(c)]);
    CHECK(pair.specular_gloss.at(0, 0)[static_cast<std::size_t>(c)] == code(0.04));
    CHECK(pair.diffuse_alpha.at(1, 0)[static_cast<std::size_t>(c)] == 0);
    CHECK(pair.specular_gloss.at(1, 0)[static_cast<std::size_t>(c)] == code(linear(255)));
  }
  CHECK(pair.specular_gloss.at(0, 0)[3] == gloss(128 / 255.0));
  CHECK(pair.specular_gloss.at(1, 0)[3] == gloss(64 / 255.0));
  // Smoothness is what is left of roughness.
  ProjectMaterial smooth = m;
  set_texture(smooth, Channel::smoothness, ImageSource{folder.file("orm.png"), "g", ""});
  CHECK(!smooth.texture(Channel::roughness));
  CHECK(pictures_of(smooth, built_in_library(), picture_door()).specular_gloss.at(0, 0)[3] ==
        gloss(127 / 255.0));
  // The project keeps all of it, and what the editor draws holds the occlusion of the same file.
  m.green_down = true;
  m.uv_scale = {4, 2.5};
  m.texture(Channel::normal) = ImageSource{folder.file("base.png"), "", ""};
  Project project;
  project.materials = {m};
  const Project back = parse_project(format_project(project, ""), "p.json");
  CHECK(back.materials[0] == m);
  const SurfaceTextures seen = surface_textures(m, pair, picture_door(), 16);
  CHECK((seen.has.diffuse && seen.has.f0 && seen.has.gloss && seen.has.occlusion));
  CHECK(channel_picture(seen, Channel::occlusion).at(1, 0)[0] == 0);
  // DirectX's green points down.
  CHECK(seen.has.normal);
  CHECK(double{seen.normal.at(0, 0)[0]} == Approx(200 / 127.5 - 1));
  CHECK(double{seen.normal.at(0, 0)[1]} == Approx(1 - 100 / 127.5));
  std::string both = format_project(project, "");
  both.replace(both.find("\"occlusion\""), 11, "\"gloss\"");
  CHECK_THROWS_WITH(parse_project(both, "p.json"), Catch::Contains("both \"gloss\" and \"roughness\""));
}

TEST_CASE("a normal map of two channels gets its third component from them") {
  const TempFolder folder;
  Image8 codes(4, 4, 3);
  for (std::size_t i = 0; i < codes.values.size(); i += 3) {
    codes.values[i] = 204;  // 0.6
    codes.values[i + 1] = 128;
  }
  save_png(folder.file("two.png"), codes);
  ProjectMaterial m;
  m.texture(Channel::normal) = ImageSource{folder.file("two.png"), "", ""};
  const Image normal = normal_picture(m, picture_door(), 4);
  CHECK(double{normal.at(1, 1)[0]} == Approx(0.6));
  CHECK(double{normal.at(1, 1)[2]} == Approx(0.8).epsilon(1e-4));
}

TEST_CASE("codes of base colour and metalness become those of the formulas, all of them") {
  const TempFolder folder;
  Image8 base(256, 256, 3), metal(256, 256, 1);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      base.at(x, y)[0] = base.at(x, y)[1] = base.at(x, y)[2] = static_cast<std::uint8_t>(x);
      metal.at(x, y)[0] = static_cast<std::uint8_t>(y);
    }
  save_png(folder.file("base.png"), base);
  save_png(folder.file("metal.png"), metal);
  ProjectMaterial m;
  m.name = "m";
  set_texture(m, Channel::base_color, ImageSource{folder.file("base.png"), "", ""});
  set_texture(m, Channel::metallic, ImageSource{folder.file("metal.png"), "", ""});
  const MaterialPair pair = pictures_of(m, built_in_library(), {});
  std::size_t wrong = 0;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const double c = srgb_decode(x / 255.0), share = y / 255.0;
      wrong += pair.diffuse_alpha.at(x, y)[1] != srgb_u8(c * (1 - share));
      wrong += pair.specular_gloss.at(x, y)[2] != srgb_u8(0.04 + (c - 0.04) * share);
    }
  CHECK(wrong == 0);
}

TEST_CASE("textures for the viewport are the same from files that are decoded once as from the whole pair") {
  const TempFolder folder;
  ProjectMaterial m;
  m.name = "m";
  m.green_down = true;
  const auto set = [&](Channel channel, const char* file, const char* channels) {
    set_texture(m, channel, ImageSource{folder.file(file), channels, ""});
  };
  // Of a size that squares of texels do not divide, and in more bands than there are threads.
  save_png(folder.file("base.png"), noise(301, 517, 4, 1));
  save_png(folder.file("orm.png"), noise(301, 517, 3, 2));
  Image16 normal(77, 130, 3);
  for (std::size_t i = 0; i < normal.values.size(); ++i)
    normal.values[i] = static_cast<std::uint16_t>(7919 * i % 65536);
  spit(folder.file("normal.png"), png_bytes(normal, {}));
  set(Channel::base_color, "base.png", "");
  set(Channel::alpha, "base.png", "a");
  set(Channel::metallic, "orm.png", "b");
  set(Channel::roughness, "orm.png", "g");
  set(Channel::occlusion, "orm.png", "r");
  set(Channel::normal, "normal.png", "");
  DecodedFiles known = decoded_files({folder.file("base.png"), folder.file("orm.png")}, {});
  for (const int side : {600, 128, 50}) {
    const SurfaceTextures whole = surface_textures(m, pictures_of(m, built_in_library(), {}), {}, side);
    for (const DecodedFiles& given : {DecodedFiles(), known}) {
      const SurfacePicturesRead read = read_surface_textures(m, built_in_library(), {}, side, 0, given);
      CHECK((read.width == 301 && read.height == 517));
      CHECK(read.textures.body == whole.body);
      CHECK(read.textures.gloss == whole.gloss);
      CHECK(read.textures.emission == whole.emission);
      CHECK(read.textures.normal == whole.normal);
      CHECK((read.textures.has.opacity && read.textures.has.occlusion && read.textures.has.normal));
      CHECK(std::max(read.textures.body.width, read.textures.body.height) <= side);
    }
  }
  // Components of 16 bits are not rounded to 8.
  const Image whole = surface_textures(m, pictures_of(m, built_in_library(), {}), {}, 600).normal;
  CHECK(double{whole.at(5, 0)[0]} == Approx(2 * (7919 * 15 % 65536) / 65535.0 - 1));
  // A file that has changed is decoded again.
  save_png(folder.file("base.png"), noise(301, 517, 4, 5));
  const auto path = std::filesystem::path(folder.file("base.png"));
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(9));
  CHECK(read_surface_textures(m, built_in_library(), {}, 50, 0, known).textures.body ==
        surface_textures(m, pictures_of(m, built_in_library(), {}), {}, 50).body);
}
