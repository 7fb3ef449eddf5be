// SPDX-License-Identifier: Apache-2.0
// What the packer decides before a texel is placed: regions, pages, mips and resolutions.
#include "core/pack/decision.h"

#include <catch2/catch.hpp>

#include "core/image/mips.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Materials of pictures of noise, as the packer has read them.
struct NoiseFolder {
  TempFolder folder;
  std::vector<std::string> entries;

  void add(const std::string& name, int width, int height) {
    add_noise_material(folder, name, width, height, static_cast<unsigned>(8 * entries.size() + 1));
    entries.push_back(manifest_entry(name));
  }
  PackSource read(const PackOptions& options) const {
    spit(folder.file("m.json"), manifest_of(entries));
    return read_source(folder.file("m.json"), nullptr, options, built_in_library());
  }
};

PackDecision decided_once(const PackOptions& options, const PackSource& source, FoundResolutions& found) {
  std::vector<PackDecision> ways = decide(options, source, nullptr, found);
  REQUIRE(ways.size() == 1);
  return std::move(ways.front());
}

PackDecision decided_once(const PackOptions& options, const PackSource& source) {
  FoundResolutions found;
  return decided_once(options, source, found);
}

}  // namespace

TEST_CASE("a region by itself takes a free page of just its size and its gutter") {
  NoiseFolder noise;
  noise.add("wood", 24, 16);
  PackOptions options;
  options.layout.form = PageForm::free;
  for (const int gutter : {0, 3}) {
    options.layout.gutter = gutter;
    const PackDecision decision = decided_once(options, noise.read(options));
    REQUIRE(decision.parts.size() == 1);
    CHECK(decision.parts[0].box == PixelBox{0, 0, 24, 16});
    CHECK(decision.plan.places[0].gutter == gutter);
    REQUIRE(decision.plan.pages.size() == 1);
    CHECK(decision.plan.pages[0].width == 24 + 2 * gutter);
    CHECK(decision.plan.pages[0].height == 16 + 2 * gutter);
  }
}

TEST_CASE("regions lie within their pages, and none lies on another") {
  NoiseFolder noise;
  for (int i = 0; i < 12; ++i) noise.add("m" + std::to_string(i), 8 + 5 * (i % 4), 8 + 7 * (i % 3));
  PackOptions options;
  options.layout.page = 32;
  options.layout.rotate = true;
  const PackDecision decision = decided_once(options, noise.read(options));
  CHECK(decision.regions.size() == 12);
  CHECK(decision.plan.pages.size() > 1);
  for (std::size_t r = 0; r < decision.regions.size(); ++r) {
    const PlannedPlace& at = decision.plan.places[r];
    const PixelBox box = box_on_page(decision.regions[r], at);
    const PlannedPage& page = decision.plan.pages[static_cast<std::size_t>(at.page)];
    CHECK(common_part(box, {0, 0, page.width, page.height}) == box);
    for (std::size_t other = 0; other < r; ++other)
      if (decision.plan.places[other].page == at.page)
        CHECK(common_part(box, box_on_page(decision.regions[other], decision.plan.places[other])).area() ==
              0);
  }
}

TEST_CASE("of the mips that are asked for those are kept in which a region has texels of its own") {
  NoiseFolder noise;
  noise.add("large", 16, 16);
  noise.add("small", 8, 4);
  PackOptions options;
  options.layout.mips = 0;
  const PackDecision all = decided_once(options, noise.read(options));
  REQUIRE(all.levels.size() == 1);
  const PlannedPage& page = all.plan.pages[0];
  CHECK(all.levels[0].offered == full_mip_levels(page.width, page.height));
  CHECK(all.levels[0].kept == 5);
  options.layout.mips = 2;
  CHECK(decided_once(options, noise.read(options)).levels[0].kept == 2);
  options.layout.mips = 0;
  options.leave_out.keep = {"mips"};
  const PackDecision kept = decided_once(options, noise.read(options));
  CHECK(kept.levels[0].kept == kept.levels[0].offered);
}

TEST_CASE("a resolution that was found is not looked for again, and shrinks the region as it says") {
  NoiseFolder noise;
  noise.add("wood", 32, 16);
  noise.add("stone", 16, 16);
  PackOptions options;
  options.layout.form = PageForm::free;
  const PackSource source = noise.read(options);
  FoundResolutions found;
  (void)decided_once(options, source, found);
  CHECK(found.empty());  // nothing asks for fewer texels
  options.leave_out.max_error = 0.5;
  const PackDecision whole = decided_once(options, source, found);
  REQUIRE(found.size() == 2);
  for (const Region& region : whole.regions) CHECK(region.shrink == 0);  // of noise every texel counts
  const int wood = source.inputs.materials[0].name == "wood" ? 0 : 1;
  for (auto& [of, resolution] : found)
    if (of[0] == wood) resolution.shrink = 2;
  const PackDecision fewer = decided_once(options, source, found);
  CHECK(found.size() == 2);
  REQUIRE(fewer.regions.size() == 2);
  const Region& small = fewer.regions[fewer.regions[0].material == static_cast<std::size_t>(wood) ? 0 : 1];
  CHECK(small.width() == 8);
  CHECK(small.height() == 4);
  CHECK(fewer.plan.page_texels() < whole.plan.page_texels());
}

TEST_CASE("what texels teach changes a decision where regions go by it, and is told so") {
  NoiseFolder noise;
  noise.add("wood", 16, 16);
  noise.add("stone", 16, 16);
  PackOptions options;
  PackSource source = noise.read(options);
  PackDecision decision = decided_once(options, source);
  const auto taught = [&](std::uint64_t first, std::uint64_t second) {
    std::vector<Learned> out(2);
    for (std::size_t i = 0; i < 2; ++i) {
      out[i].seen = {true, true};
      out[i].hash = {std::array{i == 0 ? first : second, std::uint64_t{1}},
                     std::array{i == 0 ? first : second, std::uint64_t{2}}};
      out[i].range.least.fill(0);
      out[i].range.most.fill(255);
    }
    return out;
  };
  CHECK(learn(taught(5, 6), options, source, decision));
  CHECK(source.inputs.materials[1].facts.learned);
  // Of equal texels one material keeps its region for both.
  PackSource again = noise.read(options);
  CHECK(!learn(taught(5, 5), options, again, decision));
  CHECK(decision.left_out.fates[1].owner == 0);
  CHECK(!weighs_files(options, source));
}
