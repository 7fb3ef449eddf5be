// SPDX-License-Identifier: Apache-2.0
#include "core/base/bytes/base64.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/image/files/png.h"
#include "core/pages/atlas_page.h"

namespace etak {
namespace {

std::string difference_text(double value) {
  return value < 1000 ? number(value, 3) : grouped(static_cast<std::uint64_t>(value));
}

// A percentile and the largest.
std::string cells(double usual, double largest) {
  std::string out;
  append(out, "<td class=\"num\">", difference_text(usual), "</td><td class=\"num\">",
         difference_text(largest), "</td>");
  return out;
}

// One texture: what it takes with all levels, and what is changed of its materials on level 0.
std::string texture_rows(const std::vector<BlockLevel>& blocks, const BlockLevel& first) {
  std::uint64_t bytes = 0;
  std::string tail;
  for (const BlockLevel& each : blocks) {
    if (each.page != first.page || each.texture != first.texture) continue;
    bytes += each.bytes;
    if (each.tail && tail.empty()) tail = "; RGBA8 from level " + std::to_string(each.level) + " on";
  }
  std::string out;
  append(out, "<tbody class=\"texture\"><tr><th colspan=\"9\">page ", std::to_string(first.page), ' ',
         name(first.texture), ": ", first.format, first.fourth_apart ? " + R8, " : ", ",
         number(8 * static_cast<double>(first.bytes) / static_cast<double>(first.texels), 3),
         " bits a texel, ", grouped(bytes), " bytes with its mips", tail,
         first.fallback ? "; errors are those of " + first.tried + ", which was not kept" : "",
         "</th></tr></tbody>\n<tbody>\n");
  for (const BlockMaterial& m : first.materials) {
    append(out, "<tr><th>", escape_html(m.id), "</th>", cells(m.colour_p99, m.colour_largest),
           cells(m.fourth_p99, m.fourth_largest));
    if (m.shaded)
      append(out, cells(m.shaded->p99, m.shaded->largest), "<td class=\"num\">", number(m.shaded->flip, 2),
             "</td>");
    else
      append(out, "<td colspan=\"3\">", first.fallback ? "exact" : "not told", "</td>");
    append(out, m.met ? "<td>kept</td>" : "<td class=\"inside\">missed</td>", "</tr>\n");
  }
  return out + "</tbody>\n";
}

std::string figure(const BlockPicture& picture) {
  std::string out = "<figure>";
  for (const auto& [what, image] : {std::pair{"exact", &picture.exact},
                                    {"from blocks", &picture.held},
                                    {"difference", &picture.difference}})
    append(out, "<img alt=\"", escape_html(picture.material), ", ", what, "\" title=\"", what,
           "\" src=\"data:image/png;base64,", base64(png_bytes(*image, {})), "\">\n");
  append(out, "<figcaption><b>", escape_html(picture.material), "</b>: dE ", number(picture.shaded.p99, 3),
         ", FLIP ", number(picture.shaded.flip, 2),
         ". Exact, from blocks, difference: ", std::to_string(picture.exact.width), " x ",
         std::to_string(picture.exact.height), " texels at ", std::to_string(picture.x), ", ",
         std::to_string(picture.y), " of page ", std::to_string(picture.page), ", seen ",
         number(picture.degrees, 3), " degrees from the normal.</figcaption></figure>\n");
  return out;
}

}  // namespace

std::string blocks_section(const std::vector<BlockLevel>& blocks, const std::vector<BlockPicture>& pictures) {
  std::string out =
      "<section id=\"blocks\"><h2>What compression changed</h2>\n<p>Of the texels that each material reads on level 0: "
      "dE2000 of the diffuse colour or of F0, percent of coverage or of the gloss exponent, and dE2000 and FLIP of what it "
      "looks like with both textures under three lights. 99 % of its texels change by no more than the first number, none by "
      "more than the second.</p>\n<div class=\"scroll\"><table class=\"data summary\"><thead><tr><th>material</th>"
      "<th>dE</th><th>largest</th><th>percent</th><th>largest</th><th>dE under light</th><th>largest</th><th>FLIP</th>"
      "<th>budget, level 0</th></tr></thead>\n";
  for (const BlockLevel& each : blocks)
    if (each.level == 0) out += texture_rows(blocks, each);
  out += "</table></div>\n";
  if (!pictures.empty()) {
    append(
        out,
        "<h3>Where it shows</h3>\n<p>The materials that look most changed, where they do. The difference is white where "
        "dE2000 is ",
        number(white_difference, 2),
        " or more, and black where nothing changed.</p>\n<div class=\"parts\">\n");
    for (const BlockPicture& each : pictures) out += figure(each);
    out += "</div>\n";
  }
  return out + "</section>\n";
}

}  // namespace etak
