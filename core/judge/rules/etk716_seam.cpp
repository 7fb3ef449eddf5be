// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk716_seam{
    .id = "ETK716",
    .slug = "seam",
    .title = "A texture that tiles has a seam",
    .severity = Severity::warning,
    .needs = {Need::edges},
    .parameters =
        {{"times", 0, 0, "times",
          "the step over the edge is larger than any inside of the picture; 0: not judged; 1.5 finds seams"}},
    .source = "The agreement of the project that its textures tile, in etak.toml",
    .what =
        "From one edge to the opposite one the mean step of a picture is more than `times` times the largest mean step between two neighbouring columns (rows) inside of it, and more than 2 codes. Of a glTF scene, pictures whose UVs repeat are judged; of files all are. Silent without `times`.",
    .why = "Where the texture is laid beside itself, a line is seen from far away.",
    .example = "A photo cut to a square without blending its edges.",
    .fix = "Blend opposite edges into each other, or make the texture anew as a tile.",
    .check = [](RuleCheck& check) {
      constexpr double least = 2;  // codes: what noise and rounding make
      const double times = check.parameter("times");
      // The sides of pages are the choice of their packer.
      if (times <= 0 || !check.target.manifest.tiles.empty() || check.target.manifest.packed) return;
      constexpr std::array sides{"left and right", "top and bottom"};
      for (const PictureLook& look : check.evidence.looks)
        for (std::size_t axis = 0; look.steps && axis < 2; ++axis) {
          const double across = look.steps->across[axis], inside = look.steps->inside[axis];
          if (across <= std::max(least, times * inside)) continue;
          Finding& finding = check.report();
          finding.file = look.label;
          finding.value = number(across, 3) + " codes";
          finding.limit = number(inside, 3) + " codes inside";
          finding.message = std::string("the ") + sides[axis] +
                            " edges do not continue each other: a step of " + finding.value +
                            ", where neighbours inside differ by at most " + number(inside, 3);
        }
    }};

}  // namespace etak
