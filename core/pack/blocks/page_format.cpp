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

namespace {

// The materials that a page holds in one of its textures, with those that share their texels.
std::vector<std::size_t> materials_of(const PackDecision& decision, int page, Texture texture) {
  std::set<std::size_t> owners;
  for (std::size_t r = 0; r < decision.regions.size(); ++r)
    if (decision.plan.places[r].page == page && decision.regions[r].in[index_of(texture)])
      owners.insert(decision.regions[r].material);
  std::vector<std::size_t> out;
  for (std::size_t m = 0; m < decision.left_out.fates.size(); ++m)
    if (const MaterialFate& fate = decision.left_out.fates[m]; fate.texels && owners.contains(fate.owner))
      out.push_back(m);
  return out;
}

// Adds a define to the materials of a page that have one of others.
void add_define(AtlasLayout& layout, int page, std::initializer_list<const char*> with, const char* define) {
  for (AtlasMaterialRow& row : layout.materials) {
    const auto reads = [&](const AtlasRect& rect) { return rect.page == page && rect.name == row.name; };
    const auto has = [&](const char* each) { return std::ranges::count(row.defines, each) > 0; };
    if (std::ranges::any_of(layout.rects, reads) && std::ranges::any_of(with, has))
      row.defines.emplace_back(define);
  }
}

}  // namespace

const BlockFormat* fitting_format(const PackDecision& decision, int page) {
  bool constant = true, grey = true;
  for (const std::size_t m : materials_of(decision, page, Texture::specular_gloss)) {
    const MaterialFate& fate = decision.left_out.fates[m];
    constant = constant && has_constant_f0(fate);
    grey = grey && (fate.grey || has_constant_f0(fate));
  }
  return constant ? block_format_named("BC4") : grey ? block_format_named("BC5") : nullptr;
}

bool reads_fourth(const PackDecision& decision, const std::vector<PackInput>& materials, int page,
                  Texture texture) {
  const bool alpha = texture == Texture::diffuse_alpha;
  return std::ranges::any_of(materials_of(decision, page, texture), [&](std::size_t m) {
    return !decision.left_out.fates[m].constant[alpha ? alpha_channel : gloss_channel] &&
           !(alpha && materials[m].alpha_mode == AlphaMode::opaque);
  });
}

void tell_channels(const std::vector<BlockLevel>& levels, const std::vector<std::string>& formats,
                   AtlasLayout& layout) {
  for (const BlockLevel& level : levels) {
    AtlasPage& page = layout.pages[static_cast<std::size_t>(level.page)];
    const bool diffuse = level.texture == Texture::diffuse_alpha;
    const auto add_files = [&](const auto& beside) {
      for (const std::string& format : formats)
        if (std::string file = beside(page_file(level.page, level.texture, format), level.texture);
            !file.empty())
          page.files[index_of(level.texture)].push_back(std::move(file));
    };
    if (level.tail && !page.tail_apart[index_of(level.texture)]) {
      page.tail_apart[index_of(level.texture)] = true;
      add_files(tail_file_beside);
      if (page.tail_beside_first(level.texture).empty()) continue;
      if (diffuse)
        add_define(layout, level.page, {"ETAK_DIFFUSE_TEXTURE", "ETAK_ALPHA_TEXTURE"},
                   "ETAK_DIFFUSE_ALPHA_TAIL");
      else
        add_define(layout, level.page, {"ETAK_SPECULAR_TEXTURE", "ETAK_GLOSS_TEXTURE"},
                   "ETAK_SPECULAR_GLOSS_TAIL");
    }
    if (level.level != 0 || level.fallback) continue;
    if (level.fourth_apart) {
      page.fourth_apart[index_of(level.texture)] = true;
      add_files(fourth_file_beside);
      if (page.fourth_beside_first(level.texture).empty()) continue;
      if (diffuse)
        add_define(layout, level.page, {"ETAK_ALPHA_TEXTURE"}, "ETAK_ALPHA_APART");
      else
        add_define(layout, level.page, {"ETAK_GLOSS_TEXTURE"}, "ETAK_GLOSS_APART");
    }
    if (level.format != "BC4" && level.format != "BC5") continue;
    const bool gloss_alone = level.format == "BC4";
    page.in_blocks =
        gloss_alone ? std::vector<std::string>{"gloss"} : std::vector<std::string>{"specular", "gloss"};
    if (page.first_in_blocks())
      add_define(layout, level.page, {"ETAK_GLOSS_TEXTURE", "ETAK_SPECULAR_TEXTURE"},
                 gloss_alone ? "ETAK_GLOSS_IN_RED" : "ETAK_F0_GLOSS_IN_RED_GREEN");
  }
}

}  // namespace etak
