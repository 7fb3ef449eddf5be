// SPDX-License-Identifier: Apache-2.0
// What compression has changed of textures that the pictures they were made of lie beside (ETK019).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/image/blocks/encode.h"
#include "core/image/files/png.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/image/block_files.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A DDS file of a picture: BC7, BC5 or BC4 by the encoder of core, or BC1 with one colour a block, which is coarse.
std::string dds_of_picture(const Image8& picture, std::string_view format_name) {
  const BlockFormat& format = *block_format_named(format_name);
  std::vector<BlockSource> blocks;
  std::string flat;
  for (int top = 0; top < picture.height; top += 4)
    for (int left = 0; left < picture.width; left += 4) {
      BlockSource& block = blocks.emplace_back();
      for (int i = 0; i < 16; ++i) {
        const auto texel =
            picture.at(std::min(picture.width - 1, left + i % 4), std::min(picture.height - 1, top + i / 4));
        block.texels[static_cast<std::size_t>(i)] =
            four_channels(texel.data(), static_cast<std::size_t>(picture.channels), std::uint8_t{255});
      }
      const auto& first = block.texels[0];
      const unsigned colour = first[0] / 8u << 11 | first[1] / 4u << 5 | first[2] / 8u;
      for (const unsigned part : {colour, colour, 0u, 0u}) bytes_le::append(flat, part, 2);
    }
  std::string bytes(format.block_bytes * blocks.size(), '\0');
  if (format.code == BlockCode::bc1)
    bytes = flat;
  else
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): blocks as bytes
    encode_blocks(blocks, {format.code, {1, 1, 1, 1}, 3}, reinterpret_cast<std::uint8_t*>(bytes.data()));
  return dds_of({picture.width, picture.height, {bytes}}, "", format.dxgi);
}

// A picture without edges, whose third channel is blue enough for a normal map.
Image8 gradients(int side, int channels) {
  Image8 out(side, side, channels);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < channels; ++c)
        out.at(x, y)[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(c == 2 ? 250 : 110 + (c % 2 == 0 ? x : y) * 32 / side);
  return out;
}

class Folder {
 public:
  void picture(const std::string& name, const Image8& picture) { save_png(folder_.file(name), picture); }
  void dds(const std::string& name, const Image8& picture, std::string_view format) {
    spit(folder_.file(name), dds_of_picture(picture, format));
  }
  void cut(const std::string& name) {
    const std::string bytes = slurp(folder_.file(name));
    spit(folder_.file(name), bytes.substr(0, bytes.size() / 2));
  }

  ValidationReport report(const Settings& settings = {}) const {
    ValidationRequest request;
    request.inputs.paths = {folder_.path()};
    request.config.root = folder_.path();
    request.config.settings = settings;
    request.run.door = picture_door();
    return validate(std::move(request));
  }

 private:
  TempFolder folder_;
};

std::vector<Finding> losses(const ValidationReport& report) {
  std::vector<Finding> out;
  for (const CheckedFile& file : report.files)
    std::ranges::copy_if(file.findings, std::back_inserter(out),
                         [](const Finding& finding) { return finding.rule == "ETK019"; });
  return out;
}

}  // namespace

TEST_CASE("blocks of pictures without edges have lost nothing that a rule tells") {
  Folder folder;
  for (const std::string name : {"a_diffuse", "a_specular", "b_basecolor", "b_orm"}) {
    folder.picture(name + ".png", gradients(64, name == "a_specular" ? 4 : 3));
    folder.dds(name + ".dds", gradients(64, name == "a_specular" ? 4 : 3), "BC7");
  }
  folder.picture("b_normal.png", gradients(64, 3));
  folder.dds("b_normal.dds", gradients(64, 3), "BC5");
  CHECK(losses(folder.report()).empty());
}

TEST_CASE("what blocks cannot hold of a picture beside them is told once, in the units of shading") {
  Folder folder;
  const Image8 rough = noise(64, 64, 4, 3);
  folder.picture("a_diffuse.png", noise(64, 64, 3, 1));
  folder.dds("a_diffuse.dds", noise(64, 64, 3, 1), "BC1");
  folder.picture("a_specular.png", rough);
  folder.dds("a_specular.dds", rough, "BC7");
  folder.picture("b_basecolor.png", gradients(64, 3));
  folder.dds("b_basecolor.dds", gradients(64, 3), "BC7");
  folder.picture("b_metallic.png", gradients(64, 1));
  folder.picture("b_roughness.png", noise(64, 64, 1, 2));
  folder.dds("b_roughness.dds", gradients(64, 1), "BC4");  // of a picture that was painted over since
  folder.picture("b_normal.png", noise(64, 64, 3, 4));
  folder.dds("b_normal.dds", noise(64, 64, 3, 4), "BC1");
  const std::vector<Finding> found = losses(folder.report());
  std::vector<std::pair<std::string, std::string>> told;
  for (const Finding& each : found) {
    CHECK(each.severity == Severity::warning);
    CHECK(contains(each.message, each.file.substr(0, each.file.size() - 3) + "png"));
    told.emplace_back(each.file, each.limit);
  }
  std::ranges::sort(told);
  CHECK(told == std::vector<std::pair<std::string, std::string>>{{"a_diffuse.dds", "5 dE"},
                                                                 {"a_specular.dds", "5 dE"},
                                                                 {"a_specular.dds", "50 %"},
                                                                 {"b_normal.dds", "5 degrees"},
                                                                 {"b_roughness.dds", "50 %"}});
  Settings settings;
  settings.rules["ETK019"].parameters["colour"] = 100;
  CHECK(losses(folder.report(settings)).size() == 3);
}

TEST_CASE("a texture alone in its format is compared, whichever of the two is judged") {
  // Of two roughness files one is judged, and of KTX2 and JPEG or PNG that is not the one in blocks.
  for (const std::string source : {"b_roughness.png", "b_roughness.bmp"}) {
    Folder folder;
    folder.picture("b_basecolor.png", gradients(64, 3));
    folder.picture(source, noise(64, 64, 1, 2));
    folder.dds("b_roughness.dds", gradients(64, 1), "BC4");
    const std::vector<Finding> found = losses(folder.report());
    REQUIRE(found.size() == 1);
    CHECK(found[0].file == "b_roughness.dds");
    CHECK(contains(found[0].message, source));
  }
}

TEST_CASE("gloss is compared where both files have it, and pictures of other sizes are not") {
  Folder folder;
  const Image8 with = noise(64, 64, 4, 3);
  folder.picture("a_f0.png", gradients(64, 3));
  Image8 same(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      std::copy_n(gradients(64, 3).at(x, y).data(), 3, same.at(x, y).data());
      same.at(x, y)[3] = with.at(x, y)[3];
    }
  folder.dds("a_f0.dds", same, "BC7");
  folder.picture("c_f0.png", noise(60, 64, 3, 1));
  folder.dds("c_f0.dds", noise(64, 64, 3, 1), "BC1");
  CHECK(losses(folder.report()).empty());
}

TEST_CASE("what encoders make of colours that alpha hides is no loss") {
  Image8 hidden = noise(64, 64, 4, 3);
  for (std::size_t i = 3; i < hidden.values.size(); i += 4) hidden.values[i] = 0;
  Image8 black(64, 64, 4);
  for (int visible = 0; visible < 2; ++visible) {
    Folder folder;
    if (visible == 1)
      for (std::size_t i = 3; i < hidden.values.size(); i += 64) hidden.values[i] = 255;
    folder.picture("a_diffuse.png", hidden);
    folder.dds("a_diffuse.dds", black, "BC7");
    folder.picture("a_specular.png", gradients(64, 4));
    CHECK(losses(folder.report()).size() == static_cast<std::size_t>(visible));
  }
}

TEST_CASE("a file that cannot be read is told once, and is no reason against the one beside it") {
  for (const std::string broken : {"a_f0.png", "a_f0.dds"}) {
    CAPTURE(broken);
    Folder folder;
    folder.picture("a_f0.png", noise(64, 64, 3, 1));
    folder.dds("a_f0.dds", noise(64, 64, 3, 1), "BC1");
    folder.cut(broken);
    const ValidationReport report = folder.report();
    CHECK(losses(report).empty());
    std::size_t unreadable = 0;
    for (const CheckedFile& file : report.files)
      for (const Finding& finding : file.findings)
        if (finding.rule == "ETK001") {
          ++unreadable;
          CHECK(finding.file == broken);
        }
    CHECK(unreadable == 1);
  }
}
