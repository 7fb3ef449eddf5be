// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/layout_shader.h"

#include <catch2/catch.hpp>

#include "core/color/srgb.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

AtlasLayout layout_of(AtlasMaterialRow row) {
  AtlasLayout out;
  out.gloss = GlossForm::roughness;
  out.pages = {{200, 100, {}}};
  AtlasRect rect;
  rect.name = row.name;
  rect.x = 50, rect.y = 20, rect.width = 100, rect.height = 40;
  rect.rotated = true;
  out.rects = {rect};
  out.materials = {std::move(row)};
  return out;
}

}  // namespace

TEST_CASE("a shader of an atlas fetches what its defines name and gets what is constant as values") {
  AtlasMaterialRow row;
  row.name = "wood";
  row.alpha_cutoff = 0.25;
  row.defines = {"ETAK_DIFFUSE_TEXTURE", "ETAK_ALPHA_TEST"};
  row.constant[specular_channel] = row.constant[specular_channel + 1] = row.constant[specular_channel + 2] =
      std::uint8_t{56};
  row.constant[gloss_channel] = std::uint8_t{255};
  row.constant[1] = std::uint8_t{7};  // one channel alone makes no colour
  const AtlasLayout layout = layout_of(row);
  const LayoutShader shader = layout_shader(layout, layout.materials[0]);
  CHECK(shader.use.diffuse);
  CHECK_FALSE(shader.use.specular);
  CHECK(shader.use.alpha == TextureUse::Alpha::test);
  CHECK(shader.use.cutoff == 0.25);
  CHECK(shader.use.gloss_form == GlossForm::roughness);
  for (const TextureUse::Place& place : shader.use.places) {
    CHECK(place.region == std::array{0.25, 0.2, 0.5, 0.4});
    CHECK(place.rotated);
  }
  REQUIRE(shader.f0);
  CHECK(shader.f0->g == srgb_decode(56 / 255.0));
  CHECK_FALSE(shader.diffuse);
  CHECK_FALSE(shader.opacity);
  REQUIRE(shader.gloss);
  CHECK(*shader.gloss >= 0);  // of roughness 1: Schueler's g leaves [0, 1] there, and is held
  CHECK(*shader.gloss < 0.1);
}

TEST_CASE("defines are read from a text of one a line, with #define before them or not") {
  const TextureUse use = texture_use("#define ETAK_GLOSS_TEXTURE \r\n\nETAK_ALPHA_TEXTURE\n");
  CHECK(use.gloss);
  CHECK(use.fetch_alpha);
  CHECK_FALSE(use.diffuse);
  CHECK(contains(error_of([] { (void)texture_use("ETAK_OTHER"); }), "ETAK_OTHER: is no define"));
}
