// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/page_format.h"

#include <algorithm>
#include <set>

#include "core/atlas/outputs.h"

namespace etak {

bool has_constant_f0(const MaterialFate& fate) {
  return std::all_of(fate.constant.begin() + specular_channel, fate.constant.begin() + gloss_channel,
                     [](const auto& code) { return code.has_value(); });
}

const BlockFormat* fitting_format(const PackDecision& decision, int page) {
  std::set<std::size_t> owners;
  for (std::size_t r = 0; r < decision.regions.size(); ++r)
    if (decision.plan.places[r].page == page && decision.regions[r].in[index_of(Texture::specular_gloss)])
      owners.insert(decision.regions[r].material);
  bool constant = true, grey = true;
  for (const MaterialFate& fate : decision.left_out.fates) {
    if (!fate.texels || !owners.contains(fate.owner)) continue;
    constant = constant && has_constant_f0(fate);
    grey = grey && (fate.grey || has_constant_f0(fate));
  }
  return constant ? block_format_named("BC4") : grey ? block_format_named("BC5") : nullptr;
}

void tell_channels(const std::vector<BlockLevel>& levels, AtlasLayout& layout) {
  for (const BlockLevel& level : levels) {
    if (level.level != 0 || (level.format != "BC4" && level.format != "BC5")) continue;
    const bool gloss_alone = level.format == "BC4";
    AtlasPage& page = layout.pages[static_cast<std::size_t>(level.page)];
    page.in_blocks =
        gloss_alone ? std::vector<std::string>{"gloss"} : std::vector<std::string>{"specular", "gloss"};
    if (!page.first_in_blocks()) continue;
    for (AtlasMaterialRow& row : layout.materials) {
      const auto reads = [&](const AtlasRect& rect) {
        return rect.page == level.page && rect.name == row.name;
      };
      const auto fetched = [&](const char* define) { return std::ranges::count(row.defines, define) > 0; };
      if (std::ranges::any_of(layout.rects, reads) &&
          (fetched("ETAK_GLOSS_TEXTURE") || fetched("ETAK_SPECULAR_TEXTURE")))
        row.defines.push_back(gloss_alone ? "ETAK_GLOSS_IN_RED" : "ETAK_F0_GLOSS_IN_RED_GREEN");
    }
  }
}

}  // namespace etak
