// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/text/text.h"
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

using Colors = std::map<std::string, std::size_t>;  // by material

Colors colors_of(const AtlasLayout& layout) {
  Colors out;
  for (const AtlasMaterialRow& material : layout.materials) out.try_emplace(material.name, out.size());
  return out;
}

// Opens a drawing of `width` x `height` texels.
void append_head(std::string& out, int width, int height, const std::string& label) {
  append(out, "<svg class=\"layout\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ",
         fixed(shown_width, 0), ' ', fixed(height * shown_width / width, 2), "\" role=\"img\" aria-label=\"",
         escape_html(label),
         "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#3a3a3a\"/>\n");
}

// Writes `text` into a region where there is room; all numbers are of the drawing.
void append_name(std::string& out, const std::string& text, double x, double y, double width, double height) {
  const double letters = std::max<double>(1, static_cast<double>(display_width(text)));
  const double size = std::min({largest_text, 0.8 * height, 0.94 * width / (letter_share * letters)});
  if (size >= smallest_text)
    append(out, "<text x=\"", fixed(x + 0.5 * width, 2), "\" y=\"", fixed(y + 0.5 * height + 0.35 * size, 2),
           "\" font-size=\"", fixed(size, 1), "\" text-anchor=\"middle\" fill=\"#111\">", escape_html(text),
           "</text>");
}

std::string size_and_place(int width, int height, int x, int y) {
  return std::to_string(width) + " x " + std::to_string(height) + " at " + std::to_string(x) + ", " +
         std::to_string(y);
}

std::string source_svg(const std::vector<const AtlasRect*>& rects, const std::string& materials,
                       const std::string& fill) {
  const double scale = shown_width / rects.front()->source_width;
  std::string out;
  append_head(out, rects.front()->source_width, rects.front()->source_height,
              "Regions on the picture of " + materials);
  for (const AtlasRect* rect : rects) {
    const PixelBox& box = rect->crop;
    const std::string number = std::to_string(rect->island);
    append(out, "<g><title>region ", number, ": ", size_and_place(box.width, box.height, box.x, box.y),
           " of the picture; page ", std::to_string(rect->page), ", ",
           size_and_place(rect->width, rect->height, rect->x, rect->y), rect->rotated ? ", turned" : "",
           "</title><rect x=\"", fixed(box.x * scale, 2), "\" y=\"", fixed(box.y * scale, 2), "\" width=\"",
           fixed(box.width * scale, 2), "\" height=\"", fixed(box.height * scale, 2), "\" fill=\"", fill,
           "\" fill-opacity=\"0.8\" stroke=\"#111\" stroke-width=\"0.7\"/>");
    append_name(out, number, box.x * scale, box.y * scale, box.width * scale, box.height * scale);
    out += "</g>\n";
  }
  return out + "</svg>\n";
}

}  // namespace

std::vector<SourceMap> source_maps(const AtlasLayout& layout) {
  std::map<std::string, std::vector<const AtlasRect*>> by_material;
  for (const AtlasRect& rect : layout.rects) by_material[rect.name].push_back(&rect);
  // Materials that share texels have the same rectangles under names of their own.
  const auto same = [](const AtlasRect* a, const AtlasRect* b) {
    return a->page == b->page && a->x == b->x && a->y == b->y && a->crop == b->crop;
  };
  struct Shared {
    std::string names;
    std::vector<const AtlasRect*> rects;
  };
  std::vector<Shared> pictures;
  for (const auto& [name, rects] : by_material) {
    const auto whole = [](const AtlasRect* r) {
      return r->crop == PixelBox{0, 0, r->source_width, r->source_height};
    };
    if (std::ranges::all_of(rects, whole)) continue;
    const auto known = std::find_if(pictures.begin(), pictures.end(), [&, &all = rects](const Shared& each) {
      return std::equal(each.rects.begin(), each.rects.end(), all.begin(), all.end(), same);
    });
    if (known == pictures.end())
      pictures.push_back({name, rects});
    else
      known->names += ", " + name;
  }
  const Colors colors = colors_of(layout);
  std::vector<SourceMap> out;
  for (const Shared& each : pictures) {
    const auto color = colors.find(each.rects.front()->name);
    out.push_back(
        {each.names, source_svg(each.rects, each.names, fill_of(color == colors.end() ? 0 : color->second))});
  }
  return out;
}

std::string layout_svg(const AtlasLayout& layout, int page) {
  const AtlasPage& sheet = layout.pages[static_cast<std::size_t>(page)];
  const double scale = shown_width / sheet.width;
  Colors colors = colors_of(layout);
  std::string out;
  append_head(out, sheet.width, sheet.height, "Regions of page " + std::to_string(page));
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
    append(out, "<g><title>", escape_html(name->second), ": ",
           size_and_place(rect.width, rect.height, rect.x, rect.y), ", gutter ", std::to_string(rect.gutter),
           rect.rotated ? ", turned" : "", "</title>");
    if (rect.gutter > 0) append(out, "<rect ", box(rect.gutter), " fill=\"", fill, "\" opacity=\"0.4\"/>");
    append(out, "<rect ", box(0), " fill=\"", fill, "\" stroke=\"#111\" stroke-width=\"0.7\"/>");
    append_name(out, name->second, rect.x * scale, rect.y * scale, rect.width * scale, rect.height * scale);
    out += "</g>\n";
    names.erase(name);
  }
  return out + "</svg>\n";
}

}  // namespace etak
