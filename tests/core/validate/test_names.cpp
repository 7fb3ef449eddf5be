// SPDX-License-Identifier: Apache-2.0
// What names of pictures tell, by the conventions of studios.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>

#include "core/names/names.h"
#include "core/names/picture_sets.h"
#include "core/validate/find/picture_namer.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

// A namespace of its own, because the names of roles are common words.
namespace picture_names {
namespace {

struct NameRow {
  const char* file;
  const char* set;
  FileRole role;
  Convention convention;
  const char* channels = "";
  const char* parts = "";  // resolution, format, tile, lod
  GreenAxis green = GreenAxis::unsaid;
};

const NameReader& reader() {
  static const NameReader out{{}};
  return out;
}

std::string parts_of_name(const ParsedName& name) {
  std::string out;
  for (const std::string* part : {&name.resolution, &name.format, &name.tile, &name.lod})
    if (!part->empty()) out += (out.empty() ? "" : " ") + *part;
  return out;
}

using enum FileRole;
constexpr Convention ph = Convention::poly_haven, acg = Convention::ambient_cg, ue = Convention::unreal,
                     un = Convention::unity, sp = Convention::substance, qx = Convention::quixel,
                     co = Convention::common;

// The names of six conventions of which 14 of 18 were skipped.
const NameRow found_names[] = {
    {"brick_wall_diff_4k.jpg", "brick_wall", base_color, ph, "", "4k"},
    {"brick_wall_rough_4k.jpg", "brick_wall", roughness, ph, "", "4k"},
    {"brick_wall_arm_4k.jpg", "brick_wall", metal_rough, ph, "orm-", "4k"},
    {"brick_wall_nor_gl_4k.exr", "brick_wall", normal, ph, "", "4k", GreenAxis::opengl},
    {"Metal032_4K-PNG_Color.png", "Metal032", base_color, acg, "", "4k png"},
    {"Metal032_4K-PNG_Roughness.png", "Metal032", roughness, acg, "", "4k png"},
    {"Metal032_4K-PNG_Metalness.png", "Metal032", metallic, acg, "", "4k png"},
    {"Metal032_4K-PNG_NormalDX.png", "Metal032", normal, acg, "", "4k png", GreenAxis::directx},
    {"T_Wall_BC.png", "T_Wall", base_color, ue},
    {"T_Wall_D.tga", "T_Wall", base_color, ue},
    {"T_Wall_N.png", "T_Wall", normal, ue, "", "", GreenAxis::directx},
    {"T_Wall_ORM.png", "T_Wall", metal_rough, ue, "orm-"},
    {"T_Wall_M.png", "T_Wall", metallic, ue},
    {"Wall_BaseMap.png", "Wall", base_color, un},
    {"Wall_MaskMap.png", "Wall", metal_rough, un, "mo-s"},
    {"Wall_AlbedoTransparency.png", "Wall", base_color, un},
    {"Wall_MetallicSmoothness.png", "Wall", metal_rough, un, "m--s"},
    {"tjmnfd0_4K_Albedo.jpg", "tjmnfd0", base_color, qx, "", "4k"},
};

const NameRow more_names[] = {
    {"rusty_metal_02_metal_2k.png", "rusty_metal_02", metallic, ph, "", "2k"},
    {"floor_disp_1k.png", "floor", height, ph, "", "1k"},
    {"floor_ao_1k.png", "floor", occlusion, ph, "", "1k"},
    {"fabric_col_1_2k.jpg", "fabric", base_color, ph, "", "2k"},
    {"fabric_nor_dx_2k.png", "fabric", normal, ph, "", "2k", GreenAxis::directx},
    {"floor_spec_1k.png", "floor", specular_gloss, ph, "", "1k"},
    {"Wood049_1K-JPG_AmbientOcclusion.jpg", "Wood049", occlusion, acg, "", "1k jpg"},
    {"Wood049_1K-JPG_Displacement.jpg", "Wood049", height, acg, "", "1k jpg"},
    {"Wood049_1K-JPG_NormalGL.jpg", "Wood049", normal, acg, "", "1k jpg", GreenAxis::opengl},
    {"Leaf_2K-PNG_Opacity.png", "Leaf", opacity, acg, "", "2k png"},
    {"Lava_2K-PNG_Emission.png", "Lava", emissive, acg, "", "2k png"},
    {"T_Rock_RMA.png", "T_Rock", metal_rough, ue, "rmo-"},
    {"T_Rock_MRA.png", "T_Rock", metal_rough, ue, "mro-"},
    {"T_Rock_R.png", "T_Rock", roughness, ue},
    {"T_Rock_AO.png", "T_Rock", occlusion, ue},
    {"T_Rock_E.png", "T_Rock", emissive, ue},
    {"T_Rock_H.png", "T_Rock", height, ue},
    {"T_Rock_S.png", "T_Rock", specular_gloss, ue},
    {"T_Rock_C.png", "T_Rock", base_color, ue},
    {"T_Rock_A.png", "T_Rock", base_color, ue},
    {"T_Rock_LOD1_BaseColor.png", "T_Rock", base_color, ue, "", "lod1"},
    {"T_Rock_ORDp_2K.png", "T_Rock", metal_rough, ue, "orh-", "2k"},
    {"Wall_BaseColorMap.png", "Wall", base_color, un},
    {"Wall_SpecularSmoothness.png", "Wall", specular_gloss, un},
    {"Wall_NormalMap.png", "Wall", normal, un, "", "", GreenAxis::opengl},
    {"Wall_MetallicGlossMap.tga", "Wall", metal_rough, un, "m--s"},
    {"Helmet_Base_Color.png", "Helmet", base_color, sp},
    {"Helmet_Metallic.png", "Helmet", metallic, sp},
    {"Helmet_OcclusionRoughnessMetallic.png", "Helmet", metal_rough, sp, "orm-"},
    {"Helmet_Normal_OpenGL.png", "Helmet", normal, sp, "", "", GreenAxis::opengl},
    {"Helmet_Normal_DirectX.png", "Helmet", normal, sp, "", "", GreenAxis::directx},
    {"Helmet_Ambient_occlusion.png", "Helmet", occlusion, sp},
    {"Helmet_Glossiness.png", "Helmet", gloss, sp},
    {"Helmet_Height.1002.exr", "Helmet", height, sp, "", "1002"},
    {"Helmet_BaseColor_1001.png", "Helmet", base_color, sp, "", "1001"},
    {"Helmet_1011_Roughness.png", "Helmet", roughness, sp, "", "1011"},
    {"tjmnfd0_2K_Gloss.jpg", "tjmnfd0", gloss, qx, "", "2k"},
    {"tjmnfd0_2K_Metalness.jpg", "tjmnfd0", metallic, qx, "", "2k"},
    {"tjmnfd0_2K_Cavity.jpg", "tjmnfd0", other, qx, "", "2k"},
    {"tjmnfd0_2K_Normal_LOD0.jpg", "tjmnfd0", normal, qx, "", "2k lod0"},
    {"tjmnfd0_8K_Displacement.exr", "tjmnfd0", height, qx, "", "8k"},
    {"bamboo-wood-albedo.png", "bamboo-wood", base_color, co},
    {"bamboo-wood-normal-ogl.png", "bamboo-wood", normal, co, "", "", GreenAxis::opengl},
    {"wood planks albedo.png", "wood planks", base_color, co},
    {"wood_orm.png", "wood", metal_rough, co, "orm-"},
    {"wood_metallicRoughness.png", "wood", metal_rough, co},
    {"wood_emission.png", "wood", emissive, co},
    {"crate_diffuse_alpha.png", "crate", diffuse_alpha, co},
    {"crate_specular_gloss_u1_v2.png", "crate", specular_gloss, co, "", "u1_v2"},
    {"crate_roughness_1024x1024_16bit.png", "crate", roughness, co, "", "1024x1024"},
    {"rusty_metal_roughness.png", "rusty_metal", roughness, co},
};

void check_names(std::span<const NameRow> rows) {
  for (const NameRow& row : rows) {
    INFO(row.file);
    const auto parsed = reader().read(row.file);
    REQUIRE(parsed);
    CHECK(parsed->set == row.set);
    CHECK(name(parsed->role) == name(row.role));
    CHECK(name(parsed->convention) == name(row.convention));
    CHECK(parsed->channels == row.channels);
    CHECK(parts_of_name(*parsed) == row.parts);
    CHECK(parsed->green == row.green);
    CHECK(parsed->sure);
  }
}

// The sets that files of one folder form: "FILE FILE!MISSING; ..." in the order of sets, and what is unknown.
std::string sets_text(std::vector<std::string> files) {
  std::vector<NamedPicture> pictures;
  std::string unknown;
  for (const std::string& file : files) {
    auto parsed = reader().read(file);
    if (!parsed) {
      unknown += " ?" + file;
      continue;
    }
    NamedPicture& picture = pictures.emplace_back();
    picture.path = file;
    picture.name = std::move(*parsed);
  }
  std::ranges::stable_sort(pictures, {}, [](const NamedPicture& p) { return p.name.role; });
  std::string out;
  for (const PictureSet& set : sets_of(pictures)) {
    if (!out.empty()) out += "; ";
    for (const NamedPicture* member : set.members)
      out += (member == set.members.front() ? "" : " ") + std::string(name(member->name.role)) + '=' +
             member->path.substr(0, member->path.rfind('.'));
    if (!set.missing.empty()) out += " !" + set.missing;
  }
  for (const NamedPicture& picture : pictures)
    if (picture.as == ListedAs::unknown) unknown += " ?" + picture.path;
  return out + unknown;
}

}  // namespace

TEST_CASE("the 18 names of six conventions tell set, role, packing and parts") {
  CHECK(std::size(found_names) == 18);
  check_names(found_names);
}

TEST_CASE("names of Poly Haven, ambientCG, Unreal, Unity, Substance, Quixel and others are known") {
  CHECK(std::size(more_names) >= 30);
  check_names(more_names);
}

TEST_CASE("words that have other meanings too are no proof alone") {
  for (const char* file : {"band_d.png", "photo_r.png", "logo_color.png", "sheet_metal.png",
                           "soldier_arm.png", "albedo.png", "t_wall_d.png", "letter_a.png"}) {
    INFO(file);
    const auto parsed = reader().read(file);
    REQUIRE(parsed);
    CHECK_FALSE(parsed->sure);
  }
  for (const char* file :
       {"band.png", "crate_2k.png", "readme.png", "pic_1001.png", "", ".png", "_", "T_.png"})
    CHECK_FALSE(reader().read(file));
}

TEST_CASE(
    "a table's word stands for one thing in each convention, and every channel is a letter that is known") {
  std::vector<std::pair<Convention, std::string>> seen;
  for (const NameWord& row : name_words()) {
    for (std::string_view rest = row.words; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const std::string word(rest.substr(0, end));
      INFO(word);
      CHECK(normal_ending(word) == word);
      CHECK(std::ranges::find(seen, std::pair(row.convention, word)) == seen.end());
      seen.emplace_back(row.convention, word);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    CHECK((row.channels.empty() || row.channels.size() == 4));
    for (const char letter : row.channels) CHECK(channel_letter(channel_word(letter)) == letter);
  }
}

TEST_CASE("the files of each convention form the set that is judged") {
  CHECK(sets_text({"w_diff_4k.png", "w_arm_4k.png", "w_nor_gl_4k.png"}) ==
        "base-color=w_diff_4k metal-rough=w_arm_4k; normal=w_nor_gl_4k");
  CHECK(sets_text({"w_diff_4k.png", "w_rough_4k.png", "w_disp_4k.png"}) ==
        "base-color=w_diff_4k roughness=w_rough_4k");
  CHECK(sets_text({"T_w_BC.png", "T_w_ORM.png", "T_w_N.png"}) ==
        "base-color=T_w_BC metal-rough=T_w_ORM; normal=T_w_N");
  CHECK(sets_text({"T_w_D.png", "T_w_A.png", "T_w_R.png", "T_w_M.png"}) ==
        "base-color=T_w_D metallic=T_w_M roughness=T_w_R");
  CHECK(sets_text({"w_AlbedoTransparency.png", "w_MetallicSmoothness.png"}) ==
        "base-color=w_AlbedoTransparency metal-rough=w_MetallicSmoothness");
  CHECK(sets_text({"w_AlbedoTransparency.png", "w_SpecularSmoothness.png"}) ==
        "diffuse=w_AlbedoTransparency specular=w_SpecularSmoothness");
  CHECK(sets_text({"w_Diffuse.png", "w_Specular.png", "w_Glossiness.png"}) ==
        "diffuse=w_Diffuse specular=w_Specular gloss=w_Glossiness");
  CHECK(
      sets_text({"w_2K_Albedo.jpg", "w_2K_Diffuse.jpg", "w_2K_Specular.jpg", "w_2K_Gloss.jpg",
                 "w_2K_Metalness.jpg"}) ==
      "base-color=w_2K_Albedo metallic=w_2K_Metalness gloss=w_2K_Gloss; diffuse=w_2K_Diffuse specular=w_2K_Specular");
  CHECK(sets_text({"w_diff.png", "w_spec.png"}) == "diffuse=w_diff specular=w_spec");
  CHECK(sets_text({"w_color.png", "w_rough.png", "w_metal.png"}) ==
        "base-color=w_color metallic=w_metal roughness=w_rough");
  CHECK(sets_text({"albedo.png", "roughness.png"}) == "base-color=albedo roughness=roughness");
  CHECK(sets_text({"w_d.tga", "w_n.tga", "w_s.tga"}) == "diffuse=w_d specular=w_s; normal=w_n");
  // Colour variants share the rest.
  CHECK(sets_text({"w_col_1_2k.png", "w_col_2_2k.png", "w_rough_2k.png"}) ==
        "base-color=w_col_1_2k roughness=w_rough_2k; base-color=w_col_2_2k roughness=w_rough_2k");
  // Two resolutions are two sets; one resolution for each file is one.
  CHECK(sets_text({"w_diff_1k.png", "w_rough_1k.png", "w_diff_2k.png", "w_rough_2k.png"}) ==
        "base-color=w_diff_1k roughness=w_rough_1k; base-color=w_diff_2k roughness=w_rough_2k");
  CHECK(sets_text({"w_diff_2k.png", "w_rough_1k.png"}) == "base-color=w_diff_2k roughness=w_rough_1k");
}

TEST_CASE("what lacks its companion is said, and nothing is invented for it") {
  CHECK(sets_text({"T_w_ORM.png"}) == "metal-rough=T_w_ORM !metal-rough without the base colour");
  CHECK(
      sets_text({"w_BaseColor.png", "w_Normal.png"}) ==
      "base-color=w_BaseColor !a base colour without roughness and metallic, single or packed; normal=w_Normal");
  CHECK(
      sets_text({"T_w_BC.png", "T_w_R.png"}) ==
      "base-color=T_w_BC roughness=T_w_R !base colour and roughness without metallic, which names of Unreal always bring");
  // T_w_M is metallic beside T_w_R only: else masks in an order that nobody tells.
  CHECK(sets_text({"T_w_BC.png", "T_w_M.png"}) ==
        "base-color=T_w_BC !a base colour without roughness and metallic, single or packed");
  CHECK(sets_text({"w_roughness.png", "w_metallic.png"}) ==
        "metallic=w_metallic roughness=w_roughness !metallic, roughness without the base colour");
  // Maps need nobody, but for height, which is held against normals.
  CHECK(sets_text({"w_normal.png", "w_height.png", "w_ao.png"}) ==
        "normal=w_normal height=w_height occlusion=w_ao");
  CHECK(sets_text({"w_height.png", "w_opacity.png"}).empty());
  CHECK(sets_text({"band_d.png", "band_n.png"}) == " ?band_d.png ?band_n.png");
  CHECK(sets_text({"letter_a.png", "letter_r.png"}) == " ?letter_a.png ?letter_r.png");
  CHECK(sets_text({"logo_color.png"}) == " ?logo_color.png");
}

// How many of the hundred patterns are read and put together as they are meant. Paths are those of the list, so
// that the name of a folder counts as it does in a run.
struct PatternsRead {
  int lines = 0, whole = 0;
  std::string wrong;
};

PatternsRead read_patterns() {
  PatternsRead out;
  std::ifstream file(source_folder() + "/tests/data/names/patterns.txt");
  REQUIRE(file);
  const ValidateConfig config;
  PictureNamer namer(config, reader());
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    ++out.lines;
    std::map<std::string, std::vector<NamedPicture>> keys;
    std::map<std::string, std::string> expected;
    std::string unread;
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(" | ", begin), line.size());
      const std::string part = line.substr(begin, end - begin);
      const std::string path = part.substr(part.find('=') + 1);
      expected[path] = part.substr(0, part.find('='));
      if (auto picture = namer.named(path))
        keys[picture->key].push_back(std::move(*picture));
      else
        unread += " ?" + path;
      begin = end + 3;
    }
    std::map<std::string, std::string> found;
    for (auto& [key, pictures] : keys) {
      std::ranges::stable_sort(pictures, {}, [](const NamedPicture& p) { return p.name.role; });
      for (const PictureSet& set : sets_of(pictures))
        for (const NamedPicture* member : set.members)
          if (set.missing.empty()) found[member->path] = name(member->name.role);
    }
    if (found == expected && unread.empty())
      ++out.whole;
    else
      out.wrong += line + unread + '\n';
  }
  return out;
}

TEST_CASE("of a hundred ways of naming the files of a set at least 92 are judged whole") {
  const PatternsRead patterns = read_patterns();
  INFO(patterns.wrong);
  CHECK(patterns.lines == 100);
  CHECK(patterns.whole >= 92);
}

TEST_CASE("versions, dates, states and copies stand behind the word and are told") {
  const std::pair<const char*, const char*> versions[] = {
      {"wall_basecolor_v003.png", "v003"},         {"wall_basecolor_2024-01-31.png", "20240131"},
      {"wall_basecolor_FINAL_v2.png", "final_v2"}, {"wall_basecolor (1).png", "copy1"},
      {"wall_basecolor - Kopie.png", "kopie"},     {"wall_basecolor.v2.1001.png", "v2"},
      {"wall_BaseColor_rev02_2k.png", "rev02"},    {"wall_basecolor.png", ""}};
  for (const auto& [file, version] : versions) {
    INFO(file);
    const auto parsed = reader().read(file);
    REQUIRE(parsed);
    CHECK(parsed->set == "wall");
    CHECK(parsed->role == base_color);
    CHECK(parsed->version == version);
  }
}

TEST_CASE("of several versions the newest part is judged, and every colour") {
  CHECK(sets_text({"w_basecolor_v9.png", "w_roughness_v9.png", "w_roughness_v10.png"}) ==
        "base-color=w_basecolor_v9 roughness=w_roughness_v10");
  CHECK(
      sets_text({"w_basecolor_v1.png", "w_basecolor_v2.png", "w_roughness_v1.png"}) ==
      "base-color=w_basecolor_v2 roughness=w_roughness_v1; base-color=w_basecolor_v1 roughness=w_roughness_v1");
  CHECK(sets_text({"w_basecolor.png", "w_roughness - Copy.png", "w_roughness.png"}) ==
        "base-color=w_basecolor roughness=w_roughness");
  CHECK(sets_text({"w_basecolor.png", "w_roughness_v3.png", "w_roughness_final.png"}) ==
        "base-color=w_basecolor roughness=w_roughness_final");
}

TEST_CASE("files of one number belong together, and those without one to all that lack their role") {
  CHECK(sets_text({"w_basecolor01.png", "w_roughness01.png", "w_basecolor02.png", "w_roughness02.png"}) ==
        "base-color=w_basecolor01 roughness=w_roughness01; base-color=w_basecolor02 roughness=w_roughness02");
  CHECK(
      sets_text({"w_basecolor_01.png", "w_basecolor_02.png", "w_roughness.png", "w_normal.png"}) ==
      "normal=w_normal; base-color=w_basecolor_01 roughness=w_roughness; base-color=w_basecolor_02 roughness=w_roughness");
  CHECK(sets_text({"w_basecolor.png", "w_basecolor2.png", "w_roughness.png"}) ==
        "base-color=w_basecolor roughness=w_roughness; base-color=w_basecolor2 roughness=w_roughness");
}

TEST_CASE("words of four languages are known with and without their accents") {
  for (const char* file : {"w_rugosité.png", "w_rugosite\xCC\x81.png", "w_RUGOSITÉ.png", "w_Rauheit.png",
                           "w_rugosidad.png", "w_粗さ.png"}) {
    INFO(file);
    const auto parsed = reader().read(file);
    REQUIRE(parsed);
    CHECK(parsed->role == roughness);
    CHECK(parsed->sure);
  }
}

TEST_CASE("own endings come before the built-in ones") {
  const std::vector<OwnName> own{
      {"alb", base_color, ""}, {"pbr", metal_rough, "rmo-"}, {"diff", ignored, ""}};
  const NameReader with_own(own);
  const auto packed = with_own.read("wall_PBR_2k.png");
  REQUIRE(packed);
  CHECK(packed->set == "wall");
  CHECK(packed->role == metal_rough);
  CHECK(packed->channels == "rmo-");
  CHECK(packed->convention == Convention::own);
  CHECK(with_own.read("wall-alb.1001.png")->tile == "1001");
  CHECK(with_own.read("wall_diff.png")->role == ignored);
  CHECK(with_own.read("wall_rough.png")->convention == Convention::common);
}

TEST_CASE("a pattern of sets finds set and role wherever they stand, and the longest word for the role") {
  struct Row {
    const char *pattern, *path, *set;
    FileRole role;
    std::size_t from;
  };
  for (const Row& row : {Row{"{set}_{role}_v*", "a/old_wall_base_color_v03.png", "old_wall", base_color, 2},
                         {"{role}~{set}", "roughness~wall.tga", "wall", roughness, 0},
                         {"{role}/{set}", "kit/base_color/wall_a.png", "wall_a", base_color, 4},
                         {"{set}/maps/{role}_*", "x/y/wall/maps/normal_2k.png", "wall", normal, 4},
                         {"{set}.{role}.*", "wall.metallic.png", "wall", metallic, 0}}) {
    INFO(row.pattern << " on " << row.path);
    std::size_t from = 99;
    const auto found = reader().read_by_pattern(row.pattern, row.path, from);
    REQUIRE(found);
    CHECK(found->set == row.set);
    CHECK(found->role == row.role);
    CHECK(from == row.from);
    CHECK(found->sure);
  }
  std::size_t from = 0;
  for (const auto& [pattern, path] : {std::pair{"{set}_{role}", "wall_unknown.png"},
                                      {"{set}/{role}", "roughness.png"},
                                      {"{set}_{role}", "_roughness.png"},
                                      {"{set}_{role}", "wall_rough/x.png"}}) {
    INFO(pattern << " on " << path);
    CHECK(!reader().read_by_pattern(pattern, path, from));
  }
}

}  // namespace picture_names
