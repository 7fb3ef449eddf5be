// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/text.h"
#include "core/pages/atlas_page.h"

namespace etak {
namespace {

// Plans of all pages have the same width, so that text and lines have the same size in all of them.
constexpr double shown_width = 640;
constexpr double largest_text = 22, smallest_text = 7;
// Width of a letter as a share of the text size.
constexpr double letter_share = 0.56;

// Hues in steps of the golden angle, so that neighbours in the list of materials differ strongly.
std::string fill_of(std::size_t index) {
  return "hsl(" + std::to_string(index * 137 % 360) + " 45% 62%)";
}

}  // namespace

std::string layout_svg(const AtlasLayout& layout, int page) {
  const AtlasPage& sheet = layout.pages[static_cast<std::size_t>(page)];
  const double scale = shown_width / sheet.width;
  const double height = sheet.height * scale;
  std::map<std::string, std::size_t> colors;  // by material
  for (const AtlasMaterialRow& material : layout.materials) colors.try_emplace(material.name, colors.size());
  std::string out;
  append(out, "<svg class=\"layout\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ",
         fixed(shown_width, 0), ' ', fixed(height, 2), "\" role=\"img\" aria-label=\"Regions of page ",
         std::to_string(page),
         "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" "
         "fill=\"#3a3a3a\"/>\n");
  // Materials that share texels have a rectangle each at the same place: one is drawn, with all the names.
  std::map<std::pair<int, int>, std::string> names;
  for (const AtlasRect& rect : layout.rects) {
    if (rect.page != page) continue;
    std::string& all = names[{rect.x, rect.y}];
    if (!all.empty()) all += ", ";
    all += rect.name;
    if (rect.island > 0) all += '#' + std::to_string(rect.island);
  }
  for (const AtlasRect& rect : layout.rects) {
    if (rect.page != page) continue;
    const auto name = names.find({rect.x, rect.y});
    if (name == names.end()) continue;  // drawn before, for a material that shares the texels
    const auto box = [&](double grow) {
      const double left = std::max(0.0, rect.x - grow), top = std::max(0.0, rect.y - grow);
      const double right = std::min<double>(sheet.width, rect.x + rect.width + grow);
      const double bottom = std::min<double>(sheet.height, rect.y + rect.height + grow);
      return "x=\"" + fixed(left * scale, 2) + "\" y=\"" + fixed(top * scale, 2) + "\" width=\"" +
             fixed((right - left) * scale, 2) + "\" height=\"" + fixed((bottom - top) * scale, 2) + "\"";
    };
    const std::string fill = fill_of(colors[rect.name]);
    append(out, "<g><title>", escape_html(name->second), ": ", std::to_string(rect.width), " x ",
           std::to_string(rect.height), " at ", std::to_string(rect.x), ", ", std::to_string(rect.y),
           ", gutter ", std::to_string(rect.gutter), rect.rotated ? ", turned" : "", "</title>");
    if (rect.gutter > 0) append(out, "<rect ", box(rect.gutter), " fill=\"", fill, "\" opacity=\"0.4\"/>");
    append(out, "<rect ", box(0), " fill=\"", fill, "\" stroke=\"#111\" stroke-width=\"0.7\"/>");
    const double letters = std::max<double>(1, static_cast<double>(display_width(name->second)));
    const double size = std::min(
        {largest_text, 0.8 * rect.height * scale, 0.94 * rect.width * scale / (letter_share * letters)});
    if (size >= smallest_text)
      append(out, "<text x=\"", fixed((rect.x + 0.5 * rect.width) * scale, 2), "\" y=\"",
             fixed((rect.y + 0.5 * rect.height) * scale + 0.35 * size, 2), "\" font-size=\"", fixed(size, 1),
             "\" text-anchor=\"middle\" fill=\"#111\">", escape_html(name->second), "</text>");
    out += "</g>\n";
    names.erase(name);
  }
  return out + "</svg>\n";
}

}  // namespace etak
