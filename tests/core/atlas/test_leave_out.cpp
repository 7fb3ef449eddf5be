// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <random>

#include "core/atlas/defines.h"
#include "core/atlas/leave_out.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// All channels vary from 0 to 255 but those named constant.
MaterialFacts facts(const std::string& name, int side,
                    const std::vector<std::pair<std::size_t, int>>& constant = {}) {
  MaterialFacts f;
  f.name = f.source = name;
  f.width = f.height = side;
  f.crop = {0, 0, side, side};
  f.learned = true;
  f.range.least.fill(0);
  f.range.most.fill(255);
  f.range.grey = false;
  for (const auto& [channel, code] : constant)
    f.range.least[channel] = f.range.most[channel] = static_cast<std::uint8_t>(code);
  static std::uint64_t unique = 0;
  f.color_hash = {++unique, 0};
  f.specular_hash = {unique, 1};
  return f;
}

const LeaveOutLine* line(const LeaveOut& out, const std::string& what) {
  for (const LeaveOutLine& each : out.lines)
    if (each.what == what) return &each;
  return nullptr;
}

}  // namespace

TEST_CASE("a scene that needs everything loses nothing") {
  const LeaveOut out = leave_out({facts("a", 16), facts("b", 8)}, {});
  CHECK(out.lines.empty());
  CHECK(out.before == out.after);
  CHECK(out.before.texels == 2 * (256 + 64));
  CHECK(out.before.channel_texels == 8 * (256 + 64));
}

TEST_CASE("what is not reached, not seen or the same everywhere goes, each with its texels") {
  std::vector<MaterialFacts> m{
      facts("opaque", 16, {{3, 255}, {4, 56}, {5, 56}, {6, 56}}), facts("unused", 32),
      facts("flat", 8, {{0, 9}, {1, 9}, {2, 9}, {3, 255}, {4, 1}, {5, 2}, {6, 3}, {7, 4}})};
  m[0].opaque = true;
  m[0].crop = {4, 4, 8, 8};
  m[1].reached = false;
  const LeaveOut out = leave_out(m, {});
  CHECK(line(out, "unreached")->texels == 2 * 32 * 32);
  CHECK(line(out, "alpha")->channel_texels == 256);
  CHECK(line(out, "constant")->texels == 2 * 64);
  CHECK(line(out, "constant")->channel_texels == 3 * 256 + 8 * 64);
  CHECK(line(out, "crop")->texels == 2 * (256 - 64));
  CHECK(out.after.texels == 2 * 64);
  CHECK(out.after.channel_texels == 4 * 64);
  CHECK(out.fates[0].constant[4] == 56);
  CHECK_FALSE(out.fates[2].texels);
  CHECK(out.fates[2].constant[7] == 4);
}

TEST_CASE("keep switches each line off") {
  std::vector<MaterialFacts> m{facts("a", 16, {{3, 255}}), facts("b", 16)};
  m[0].opaque = true;
  m[0].crop = {0, 0, 4, 4};
  m[1].reached = false;
  for (const std::string_view what : leave_out_names) {
    LeaveOutOptions options;
    options.keep = {std::string(what)};
    CHECK(line(leave_out(m, options), std::string(what)) == nullptr);
  }
  LeaveOutOptions all;
  all.keep = parse_keep({"all"});
  CHECK(leave_out(m, all).lines.empty());
  CHECK(contains(error_of([] { (void)parse_keep({"gutter"}); }), "keep: gutter; expected unreached, equal"));
}

TEST_CASE("an opaque material uses the texels of one that needs alpha, not the other way round") {
  std::vector<MaterialFacts> m{facts("opaque", 16), facts("blend", 16), facts("other alpha", 16)};
  m[0].opaque = true;
  for (MaterialFacts& each : m) each.color_hash = {7, 7}, each.specular_hash = {8, 8};
  m[1].alpha_hash = {1, 1};
  m[2].alpha_hash = {2, 2};
  m[0].crop = {0, 0, 4, 4};
  m[1].crop = {8, 8, 4, 4};
  const LeaveOut out = leave_out(m, {});
  CHECK(out.fates[0].owner == 1);
  CHECK(out.fates[1].owner == 1);
  CHECK(out.fates[2].owner == 2);
  CHECK(out.fates[1].kept == std::vector<PicturePart>{{{0, 0, 12, 12}}});
}

TEST_CASE("materials are equal when they are so in all that varies, and keep their own numbers") {
  const auto f0 = [](int code) {
    return std::vector<std::pair<std::size_t, int>>{{4, code}, {5, code}, {6, code}, {7, 36}};
  };
  std::vector<MaterialFacts> m{facts("stone", 16, f0(56)), facts("stone again", 16, f0(44)),
                               facts("wet stone", 16), facts("wet stone again", 16), facts("other", 16)};
  for (MaterialFacts& each : m) each.opaque = true, each.color_hash = {7, 7};
  m[2].specular_hash = m[3].specular_hash = {8, 8};
  m[4].color_hash = {9, 9};
  const LeaveOut out = leave_out(m, {});
  // Those that vary in both textures hold what the others read.
  for (const std::size_t i : {0u, 1u, 2u, 3u}) CHECK(out.fates[i].owner == 2);
  CHECK(out.fates[4].owner == 4);
  CHECK(line(out, "equal")->materials == 3);
  CHECK(line(out, "equal")->texels == 3 * 2 * 256);
  CHECK(out.fates[0].constant[4] == 56);
  CHECK(out.fates[1].constant[4] == 44);
  CHECK_FALSE(out.fates[2].constant[4]);
  CHECK_FALSE(out.fates[1].varies[1]);
  LeaveOutOptions keep;
  keep.keep = {"constant"};
  const LeaveOut kept = leave_out(m, keep);  // then F0 must be in the texels, and is another one
  CHECK(kept.fates[0].owner == 0);
  CHECK(kept.fates[1].owner == 1);
  CHECK(kept.fates[3].owner == 2);
}

TEST_CASE("a material of one texture does not make a small region of two textures larger than both") {
  std::vector<MaterialFacts> m{facts("part", 16), facts("all", 16, {{4, 56}, {5, 56}, {6, 56}, {7, 36}})};
  for (MaterialFacts& each : m) each.opaque = true, each.color_hash = {7, 7};
  m[0].crop = {0, 0, 4, 4};
  CHECK(leave_out(m, {}).fates[1].owner == 1);
  m[0].crop = {0, 0, 16, 12};
  CHECK(leave_out(m, {}).fates[1].owner == 0);
}

TEST_CASE("islands are taken only where they are fewer texels than the box around them") {
  std::vector<MaterialFacts> m{facts("a", 100)};
  m[0].crop = {0, 0, 100, 100};
  m[0].islands = {{0, 0, 10, 10}, {90, 90, 10, 10}};
  LeaveOutOptions options;
  CHECK(leave_out(m, options).fates[0].kept.size() == 1);
  options.islands = true;
  const LeaveOut out = leave_out(m, options);
  CHECK(out.fates[0].kept.size() == 2);
  CHECK(out.after.texels == 2 * 200);
  m[0].crop = {0, 0, 12, 10};
  m[0].islands = {{0, 0, 10, 10}, {2, 0, 10, 10}};
  CHECK(leave_out(m, options).fates[0].kept.size() == 1);
}

TEST_CASE("the lines of a report add up to what is gone") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<MaterialFacts> m;
    for (int i = 0; i < 6; ++i) {
      MaterialFacts f = facts("m" + std::to_string(i), 4 << (random() % 4));
      for (std::size_t c = 0; c < channel_count; ++c)
        if (random() % 2) f.range.least[c] = f.range.most[c] = 3;
      f.opaque = random() % 2;
      if (f.opaque) f.range.least[3] = f.range.most[3] = 255;
      f.reached = random() % 4 != 0;
      f.learned = random() % 5 != 0;
      if (random() % 3 == 0 && i > 0) {
        f.color_hash = m[0].color_hash, f.specular_hash = m[0].specular_hash, f.source = m[0].source;
        f.width = f.height = m[0].width;
        f.range = m[0].range;
      }
      f.crop = {0, 0, 1 + static_cast<int>(random()) % f.width, f.height};
      if (f.crop.width < 1) f.crop.width = f.width;
      m.push_back(f);
    }
    LeaveOutOptions options;
    options.islands = true;
    const LeaveOut out = leave_out(m, options);
    TexelAccount gone;
    for (const LeaveOutLine& each : out.lines) {
      gone.texels += each.texels;
      gone.channel_texels += each.channel_texels;
      CHECK(each.bytes == 4 * each.texels);
    }
    CHECK(out.before.texels == out.after.texels + gone.texels);
    CHECK(out.before.channel_texels == out.after.channel_texels + gone.channel_texels);
    for (std::size_t i = 0; i < m.size(); ++i)
      if (out.fates[i].texels) {
        const MaterialFate& owner = out.fates[out.fates[i].owner];
        CHECK(owner.owner == out.fates[i].owner);
        CHECK(owner.texels);
      }
  }
}

TEST_CASE("grey F0 that varies is one channel, where all who share the texels have it so") {
  MaterialFacts grey = facts("grey", 16), other = facts("other", 8),
                scalar = facts("scalar", 4, {{4, 9}, {5, 9}, {6, 9}});
  grey.range.grey = scalar.range.grey = true;
  LeaveOut out = leave_out({grey, other, scalar}, {});
  REQUIRE(line(out, "grey") != nullptr);
  CHECK(line(out, "grey")->channel_texels == 2 * 256);
  CHECK(line(out, "grey")->materials == 1);
  CHECK(line(out, "grey")->texels == 0);
  CHECK(out.fates[0].grey);
  CHECK_FALSE(out.fates[1].grey);
  CHECK_FALSE(out.fates[2].grey);  // constant: the line before has it
  CHECK(material_defines(out.fates[0], AlphaMode::opaque) ==
        std::vector<std::string>{"ETAK_DIFFUSE_TEXTURE", "ETAK_SPECULAR_TEXTURE", "ETAK_SCALAR_F0",
                                 "ETAK_GLOSS_TEXTURE"});
  CHECK(material_defines(out.fates[2], AlphaMode::opaque) ==
        std::vector<std::string>{"ETAK_DIFFUSE_TEXTURE", "ETAK_SCALAR_F0", "ETAK_GLOSS_TEXTURE"});
  // One texel that another user reads in colour keeps the channels.
  MaterialFacts user = other;
  user.width = user.height = 16;
  user.crop = grey.crop;
  user.color_hash = grey.color_hash;
  user.specular_hash = grey.specular_hash;
  out = leave_out({grey, user}, {});
  CHECK(line(out, "grey")->channel_texels == 0);
  LeaveOutOptions keep;
  keep.keep = {"grey"};
  CHECK(line(leave_out({grey}, keep), "grey") == nullptr);
}

TEST_CASE(
    "boxes are of whole texels of every mip that their region keeps clean, and never beyond the picture") {
  std::vector<MaterialFacts> m{facts("a", 250), facts("b", 250)};
  m[0].crop = {37, 101, 131, 90};
  const auto crop_with = [&](int levels, std::optional<int> gutter = {}) {
    LeaveOutOptions options;
    options.levels = levels;
    options.gutter = gutter;
    return leave_out(m, options).fates[0].kept[0].box;
  };
  CHECK(crop_with(1) == PixelBox{37, 101, 131, 90});
  // A smaller side of 64 to 127 texels keeps two levels clean.
  CHECK(crop_with(2) == PixelBox{36, 100, 132, 92});
  CHECK(crop_with(0) == PixelBox{36, 100, 132, 92});
  CHECK(crop_with(0, 7) == PixelBox{36, 100, 132, 92});
  CHECK(crop_with(0, 8) == PixelBox{32, 96, 136, 96});
  CHECK(crop_with(3, 8) == PixelBox{36, 100, 132, 92});
  m[0].levels = 1;  // a sampler that reads no mips
  CHECK(crop_with(0, 8) == PixelBox{37, 101, 131, 90});
  m[0].levels = 0;
  m[0].crop = {100, 100, 149, 127};  // growing makes one level more clean, and then reaches the edge
  CHECK(crop_with(0) == PixelBox{100, 100, 150, 128});
  m[0].crop = {0, 0, 250, 250};
  CHECK(crop_with(0) == PixelBox{0, 0, 250, 250});
  // Alone a region needs no gutter and keeps a level more.
  m.pop_back();
  m[0].crop = {37, 101, 131, 90};
  CHECK(crop_with(2) == PixelBox{36, 100, 132, 92});
  CHECK(crop_with(0) == PixelBox{36, 100, 132, 92});
}

TEST_CASE("lines of what was left out name every material") {
  std::vector<MaterialFacts> m;
  for (const char* name : {"a", "b", "c", "d", "e"}) m.push_back(facts(name, 16)), m.back().reached = false;
  const LeaveOut out = leave_out(m, {});
  CHECK(line(out, "unreached")->detail == "a, b, c, d, e");
  CHECK(line(out, "unreached")->parts.size() == 5);
}
