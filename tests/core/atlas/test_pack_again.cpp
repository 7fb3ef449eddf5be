// SPDX-License-Identifier: Apache-2.0
// Packing what was packed before: equal bytes, what may be replaced, what is done anew and what stays.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "core/pack/pack.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

TEST_CASE("the bytes do not depend on the manifest's order or on threads") {
  const TempFolder folder;
  std::vector<std::string> entries;
  for (int i = 0; i < 9; ++i) {
    const std::string name = "m" + std::to_string(i);
    add_noise_material(folder, name, 20 + 7 * (i % 4), 30 + 5 * (i % 3), static_cast<unsigned>(100 + 10 * i));
    entries.push_back(manifest_entry(name));
  }
  PackOptions options;
  options.layout.mips = 4;
  (void)pack_text(folder, manifest_of(entries), options);
  std::vector<std::string> before;
  for (const std::string& name : files_in(folder.file("out")))
    if (name != "layout.json") before.push_back(slurp(folder.file("out/" + name)));
  const std::vector<AtlasRect> rects = packed_layout(folder).rects;
  std::reverse(entries.begin(), entries.end());
  options.run.threads = 4;
  (void)pack_text(folder, manifest_of(entries), options);
  std::vector<std::string> after;
  for (const std::string& name : files_in(folder.file("out")))
    if (name != "layout.json") after.push_back(slurp(folder.file("out/" + name)));
  CHECK(before == after);
  CHECK(rects == packed_layout(folder).rects);
}

TEST_CASE("files of nobody's atlas are not replaced without leave; those of an earlier atlas are") {
  const TempFolder folder;
  add_noise_material(folder, "a", 8, 8, 1);
  fs::create_directory(folder.file("out"));
  spit(folder.file("out/page0_diffuse_alpha.png"), "mine");
  spit(folder.file("out/notes.txt"), "kept");
  CHECK(contains(packing_fault(folder, manifest_of({manifest_entry("a")})),
                 "exists already and is of no earlier atlas"));
  CHECK(slurp(folder.file("out/page0_diffuse_alpha.png")) == "mine");
  PackOptions options;
  options.output.overwrite = true;
  (void)pack_text(folder, manifest_of({manifest_entry("a")}), options);
  options.output.overwrite = false;
  options.layout.mips = 3;
  (void)pack_text(folder, manifest_of({manifest_entry("a")}), options);
  CHECK(files_in(folder.file("out")).size() == 8);
  options.layout.mips = 1;
  (void)pack_text(folder, manifest_of({manifest_entry("a")}), options);
  CHECK(files_in(folder.file("out")) == std::vector<std::string>{"layout.json", "notes.txt",
                                                                 "page0_diffuse_alpha.png",
                                                                 "page0_specular_gloss.png"});
}

TEST_CASE("-u does nothing until an input or an option changes") {
  const TempFolder folder;
  add_noise_material(folder, "a", 8, 8, 1);
  PackOptions options;
  options.output.update = true;
  CHECK_FALSE(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  CHECK(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  save_png(folder.file("a_gloss.png"), noise(8, 8, 1, 77));
  CHECK_FALSE(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  options.layout.mips = 2;
  CHECK_FALSE(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  fs::remove(folder.file("out/page0_diffuse_alpha.png"));
  CHECK_FALSE(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  CHECK(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
}

TEST_CASE("-u packs again where a number has changed in any of its digits") {
  const TempFolder folder;
  add_noise_material(folder, "a", 8, 8, 1);
  PackOptions options;
  options.output.update = true;
  for (const double error : {4e-8, 2e-7, 4e-7, 0.1, std::nextafter(0.1, 1)}) {
    INFO(error);
    options.leave_out.max_error = error;
    CHECK_FALSE(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
    CHECK(pack_text(folder, manifest_of({manifest_entry("a")}), options).up_to_date);
  }
}

TEST_CASE("a dry run reports and writes nothing") {
  const TempFolder folder;
  add_noise_material(folder, "a", 8, 8, 1);
  PackOptions options;
  options.output.dry_run = true;
  CHECK(pack_text(folder, manifest_of({manifest_entry("a")}), options).regions == 1);
  CHECK_FALSE(fs::exists(folder.file("out")));
}

TEST_CASE("with the previous layout given, regions that did not change stay where they were") {
  const TempFolder folder;
  std::vector<std::string> entries;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "m" + std::to_string(i);
    add_noise_material(folder, name, 20 + 3 * i, 60 - 4 * i, static_cast<unsigned>(100 + 10 * i));
    entries.push_back(manifest_entry(name));
  }
  (void)pack_text(folder, manifest_of(entries));
  const AtlasLayout old = packed_layout(folder);
  fs::copy_file(folder.file("out/layout.json"), folder.file("previous.json"));
  entries.erase(entries.begin() + 5);
  PackOptions options;
  options.layout.previous = folder.file("previous.json");
  const PackResult report = pack_text(folder, manifest_of(entries), options);
  const AtlasLayout now = packed_layout(folder);
  CHECK(report.kept_previous);
  CHECK(report.moved == 0);
  for (const AtlasRect& rect : now.rects)
    CHECK(std::find(old.rects.begin(), old.rects.end(), rect) != old.rects.end());
}
