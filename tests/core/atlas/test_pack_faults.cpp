// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/pack/pack.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

TEST_CASE("bad inputs are told in one line, and what was there before stays") {
  const TempFolder folder;
  add_noise_material(folder, "a", 16, 16, 1);
  (void)pack_text(folder, manifest_of({manifest_entry("a")}));
  const std::string before = slurp(folder.file("out/layout.json"));
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string text = manifest_entry("a");
    text.replace(text.find(from), from.size(), to);
    return packing_fault(folder, manifest_of({text}));
  };
  CHECK(contains(broken("a_diffuse.png", "missing.png"), "missing.png"));
  CHECK(contains(broken("\"a_gloss.png\"", R"({"image": "a_gloss.png", "channels": "a"})"),
                 "has 1 channels; expected at least 4"));
  CHECK(contains(broken("\"a_specular.png\"", "\"goldd\""), "no material of the library is called goldd"));
  CHECK(contains(broken("\"a_diffuse.png\"", "\"gold\""), "gold has n and k"));
  CHECK(contains(broken("\"a_diffuse.png\"", R"({"image": "a_diffuse.png", "space": "acescg"})"),
                 "/diffuse/space"));
  save_png(folder.file("b.png"), noise(16, 15, 3, 1));
  CHECK(contains(broken("a_diffuse.png", "b.png"), "is 16 x 16; expected 16 x 15"));
  std::string sized = manifest_entry("a");
  sized.insert(sized.size() - 1, ", \"width\": 17");
  CHECK(contains(packing_fault(folder, manifest_of({sized})), "is 16 x 16; expected 17 x 16"));
  const std::string whole = slurp(folder.file("a_diffuse.png"));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{20}, std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
    spit(folder.file("a_diffuse.png"), whole.substr(0, size));
    PackOptions options;
    options.input.pictures.door.header = [](const std::string& path) -> PictureHeader {
      throw Error::at(path, "is no picture");
    };
    options.input.pictures.door.file = [](const std::string& path) -> Picture {
      throw Error::at(path, "is no picture");
    };
    CHECK(contains(packing_fault(folder, manifest_of({manifest_entry("a")}), options), "a_diffuse.png"));
  }
  spit(folder.file("a_diffuse.png"), whole);
  PackOptions small;
  small.layout.page = 8;
  CHECK_FALSE(packing_fault(folder, manifest_of({manifest_entry("a")}), small).empty());
  CHECK(slurp(folder.file("out/layout.json")) == before);
  CHECK(files_in(folder.path()).size() == 7);  // four pictures, b.png, m.json, out: nothing half-made is left
}

TEST_CASE("a NaN in a float picture is refused, and values out of range are counted") {
  const TempFolder folder;
  add_noise_material(folder, "a", 4, 4, 1);
  std::string text = manifest_entry("a");
  text.replace(text.find("a_diffuse.png"), 13, "a_diffuse.exr");
  spit(folder.file("a_diffuse.exr"), "what the door below reads");
  Image floats(4, 4, 3, 0.5f);
  PackOptions options;
  options.input.pictures.door.header = [&](const std::string&) { return header_of(floats); };
  options.input.pictures.door.file = [&](const std::string&) { return Picture{header_of(floats), floats}; };
  CHECK(pack_text(folder, manifest_of({text}), options).remarks.empty());
  const Image8 page = load_png(folder.file("out/page0_diffuse_alpha.png"));
  const AtlasLayout layout = packed_layout(folder);
  CHECK(texel_of(page, layout.rects.at(0), 0, 0)[0] == srgb_u8(0.5));
  floats.values[5] = 2;
  CHECK(contains(pack_text(folder, manifest_of({text}), options).remarks.at(0), "diffuse_alpha"));
  floats.values[5] = std::numeric_limits<float>::quiet_NaN();
  CHECK(contains(packing_fault(folder, manifest_of({text}), options), "no finite number"));
}

TEST_CASE("a picture that is exported anew while the atlas is made is told, and nothing is written") {
  const TempFolder folder;
  add_noise_material(folder, "a", 32, 32, 1);
  const std::string picture = folder.file("a_diffuse.png");
  fs::last_write_time(picture, fs::file_time_type{});
  PackOptions options;
  bool change = true;
  // Called when the pixels of a page are whole, and so after the picture was read.
  options.check.page = [&](const AtlasLayout&, int page, const PagePixels&) {
    if (change && page == 0) save_png(picture, noise(32, 32, 3, 77));
    return true;
  };
  CHECK(packing_fault(folder, manifest_of({manifest_entry("a")}), options) ==
        picture + ": changed while the atlas was made; expected a file that stays as it is");
  CHECK_FALSE(fs::exists(folder.file("out")));
  change = false;
  CHECK(packing_fault(folder, manifest_of({manifest_entry("a")}), options).empty());
}
