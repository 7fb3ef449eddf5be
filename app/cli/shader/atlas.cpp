// SPDX-License-Identifier: Apache-2.0
#include "app/cli/shader/atlas.h"

#include <algorithm>

#include "core/atlas/layout.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"

namespace etak::cli {
namespace {

const AtlasMaterialRow& material_named(const AtlasLayout& layout, const std::string& file,
                                       const std::string& name) {
  const auto& all = layout.materials;
  std::string names;
  for (const AtlasMaterialRow& row : all) {
    if (row.name == name || (name.empty() && all.size() == 1)) return row;
    if (names.size() < 200) names += (names.empty() ? "" : ", ") + row.name;
  }
  if (name.empty())
    throw Error::at("--layout", file + " holds " + std::to_string(all.size()) + " materials",
                    "--material with one of " + names);
  throw Error::at("--material", printable(name), "one of " + names);
}

// What the texture's gloss code stands for, as Schueler's g.
double schueler_gloss(double value, GlossForm form) {
  return std::clamp(converted_gloss(value, form, GlossForm::schueler), 0.0, 1.0);
}

// "f0=0.04", or "f0=1,0.8,0.3" for channels that differ; the codes are sRGB's.
std::string color_text(const char* name, const AtlasMaterialRow& row, std::size_t first) {
  std::string out = std::string(name) + '=';
  for (std::size_t c = 0; c < 3; ++c)
    out += (c == 0 ? "" : ",") + number(srgb_decode(*row.constant[first + c] / 255.0), 9);
  return out;
}

bool is_constant(const AtlasMaterialRow& row, std::size_t first) {
  return row.constant[first] && row.constant[first + 1] && row.constant[first + 2];
}

}  // namespace

AtlasShader atlas_shader(const std::string& layout_file, const std::string& name) {
  const AtlasLayout layout = parse_layout(read_file(layout_file), layout_file);
  const AtlasMaterialRow& row = material_named(layout, layout_file, name);
  AtlasShader out;
  out.use = texture_use(row.defines);
  out.use.cutoff = row.alpha_cutoff;
  out.use.gloss_form = layout.gloss == GlossForm::schueler    ? TextureUse::Gloss::schueler
                       : layout.gloss == GlossForm::roughness ? TextureUse::Gloss::roughness
                                                              : TextureUse::Gloss::one_minus_roughness;
  if (is_constant(row, specular_channel)) out.subject.push_back(color_text("f0", row, specular_channel));
  if (is_constant(row, 0)) out.subject.push_back(color_text("diffuse", row, 0));
  if (row.constant[gloss_channel])
    out.subject.push_back("gloss=" +
                          number(schueler_gloss(*row.constant[gloss_channel] / 255.0, layout.gloss), 9));
  if (row.constant[alpha_channel])
    out.subject.push_back("opacity=" + number(*row.constant[alpha_channel] / 255.0, 9));
  if (out.subject.empty()) out.subject.push_back("f0=0.04");  // fetched: never read
  const auto rect = std::find_if(layout.rects.begin(), layout.rects.end(),
                                 [&](const AtlasRect& each) { return each.name == row.name; });
  if (rect == layout.rects.end()) return out;
  const AtlasPage& page = layout.pages[static_cast<std::size_t>(rect->page)];
  out.use.region = {static_cast<double>(rect->x) / page.width, static_cast<double>(rect->y) / page.height,
                    static_cast<double>(rect->width) / page.width,
                    static_cast<double>(rect->height) / page.height};
  out.use.rotated = rect->rotated;
  return out;
}

TextureUse defined_use(const std::string& file) {
  const std::string text = read_file(file);
  std::vector<std::string> defines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with("#define ")) line.erase(0, 8);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
    if (!line.empty()) defines.push_back(std::move(line));
  }
  return texture_use(defines);
}

}  // namespace etak::cli
