// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/layout_shader.h"

#include <algorithm>

#include "core/color/gloss.h"
#include "core/color/srgb.h"

namespace etak {
namespace {

// The colour of the three channels from `first` on, whose codes are sRGB's.
std::optional<LinearRgb> constant_color(const AtlasMaterialRow& row, std::size_t first) {
  const auto* const code = &row.constant[first];
  if (!code[0] || !code[1] || !code[2]) return std::nullopt;
  return srgb_decode(Srgb8{*code[0], *code[1], *code[2]});
}

}  // namespace

LayoutShader layout_shader(const AtlasLayout& layout, const AtlasMaterialRow& row) {
  LayoutShader out;
  out.use = texture_use(row.defines);
  out.use.cutoff = row.alpha_cutoff;
  out.use.gloss_form = layout.gloss;
  out.f0 = constant_color(row, specular_channel);
  out.diffuse = constant_color(row, 0);
  if (const auto code = row.constant[gloss_channel])
    out.gloss = std::clamp(converted_gloss(*code / 255.0, layout.gloss, GlossForm::schueler), 0.0, 1.0);
  if (const auto code = row.constant[alpha_channel]) out.opacity = *code / 255.0;
  for (std::size_t part = 0; part < channel_parts.size(); ++part) {
    const auto rect = std::ranges::find_if(
        layout.rects, [&](const AtlasRect& each) { return each.name == row.name && each.holds[part]; });
    if (rect == layout.rects.end()) continue;
    const AtlasPage& page = layout.pages[static_cast<std::size_t>(rect->page)];
    // A number in the place of a part is one texel, which is read in its middle.
    const bool number = !rect->holds_all() && rect->width == 1 && rect->height == 1;
    const double x = rect->x + (number ? 0.5 : 0), y = rect->y + (number ? 0.5 : 0);
    out.use.places[part] = {{x / page.width, y / page.height, (number ? 0.0 : rect->width) / page.width,
                             (number ? 0.0 : rect->height) / page.height},
                            rect->rotated};
  }
  return out;
}

}  // namespace etak
