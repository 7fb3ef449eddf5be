// SPDX-License-Identifier: Apache-2.0
#include "core/pack/table.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "core/atlas/defines.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/pack/one_page.h"
#include "core/pack/pack.h"
#include "core/scene/uv_transform.h"

namespace etak {
namespace {

// The first of the regions that hold a material's texels: regions are in the order of their materials.
std::size_t first_region_of(const std::vector<Region>& regions, std::size_t owner) {
  const auto before = [](const Region& region, std::size_t material) { return region.material < material; };
  return static_cast<std::size_t>(std::lower_bound(regions.begin(), regions.end(), owner, before) -
                                  regions.begin());
}

void add_rects(const PackInput& m, std::size_t owner, const PackDecision& decision, AtlasLayout& out) {
  const PackingPlan& plan = decision.plan;
  const std::vector<Region>& regions = decision.regions;
  const std::size_t first = first_region_of(regions, owner);
  int island = 0;
  for (std::size_t r = first; r < regions.size() && regions[r].material == owner; ++r) {
    const PixelBox& box = regions[r].box;
    const PlannedPlace& at = plan.places[r];
    AtlasRect rect;
    rect.name = m.name;
    // The pieces of an outline are one island.
    if (r > first && (regions[r].outline == 0 || regions[r].outline != regions[r - 1].outline)) ++island;
    rect.island = island;
    rect.page = at.page;
    const PixelBox on_page = box_on_page(regions[r], at);
    rect.x = on_page.x;
    rect.y = on_page.y;
    rect.width = on_page.width;
    rect.height = on_page.height;
    rect.rotated = at.rotated;
    rect.crop = box;
    rect.source_width = m.width;
    rect.source_height = m.height;
    rect.gutter = at.gutter;
    rect.mips = at.clean_levels;
    rect.inset = plan.inset ? 0.5 * (1 << (at.clean_levels - 1)) : 0;
    constexpr WrapBoth clamped{Wrap::clamp, Wrap::clamp};
    rect.repeats = regions[r].own_page && m.wrap_of(box) != clamped;
    rect.source_gutter = at.gutter > 0 && !(m.is_whole(box) && m.wrap == clamped);
    out.rects.push_back(rect);
  }
}

// The regions of a material whose parts lie apart: parts of one place have one region.
void add_part_rects(const PackInput& m, const std::array<PartPlace, channel_parts.size()>& places,
                    const PackSource& source, const PackDecision& decision, AtlasLayout& out) {
  const std::size_t first = out.rects.size();
  for (std::size_t part = 0; part < places.size(); ++part) {
    const auto [sheet, texel] = places[part];
    const PackInput& held = source.inputs.materials[sheet];
    AtlasLayout one;
    add_rects(held, sheet, decision, one);
    AtlasRect rect = one.rects.at(0);
    rect.name = m.name;
    rect.holds = {};
    if (texel) {
      const int column = *texel % held.width, row = *texel / held.width;
      rect.x += rect.rotated ? rect.width - 1 - row : column;
      rect.y += rect.rotated ? column : row;
      rect.width = rect.height = 1;
      rect.rotated = rect.repeats = rect.source_gutter = false;
      rect.gutter = 0, rect.mips = 1, rect.inset = 0.5;
      rect.crop = {0, 0, m.width, m.height};
      rect.source_width = m.width, rect.source_height = m.height;
    }
    const auto same = [&](AtlasRect other) {
      other.holds = {};
      return other == rect;
    };
    auto at = std::find_if(out.rects.begin() + static_cast<std::ptrdiff_t>(first), out.rects.end(), same);
    if (at == out.rects.end()) at = out.rects.insert(at, rect);
    at->holds[part] = true;
  }
}

std::uint64_t texels_of(int width, int height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

void account_resolution(const PackInputs& inputs, const PackDecision& decision, PackResult& report) {
  LeaveOutLine line;
  line.what = "resolution";
  double worst = 0, seen = 0;
  for (std::size_t r = 0; r < decision.parts.size(); ++r) {
    const Region& region = decision.needed.regions[r];
    if (region.shrink == 0) continue;
    const Resolution& found = decision.resolutions[r];
    const PixelBox& box = region.box;
    const std::uint64_t gone = decision.parts[r].area() - region.area();
    ++line.materials;
    line.texels += 2 * gone;
    line.channel_texels += report.left_out.fates[region.material].channels * gone;
    line.error = std::max(line.error, found.whole.codes);
    worst = std::max(worst, found.whole.delta_e);
    seen = std::max(seen, found.seen.delta_e);
    report.reduced.push_back({inputs.materials[region.material].name, box.width, box.height, region.width(),
                              region.height(), found.seen.delta_e, found.whole.delta_e, found.whole.codes});
  }
  if (line.materials == 0) return;
  line.bytes = 4 * line.texels;
  line.detail = std::to_string(line.materials) + " regions, up to dE " + number(worst, 3) +
                " from the full size and " + number(seen, 3) + " from what is seen";
  report.left_out.after.texels -= line.texels;
  report.left_out.after.channel_texels -= line.channel_texels;
  report.left_out.lines.push_back(std::move(line));
}

// Levels are no texels of level 0: their bytes alone are counted.
void account_mips(const PackDecision& decision, PackResult& report) {
  LeaveOutLine line;
  line.what = "mips";
  int levels = 0;
  for (std::size_t p = 0; p < decision.plan.pages.size(); ++p) {
    const PlannedPage& page = decision.plan.pages[p];
    const auto textures = static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
    for (int l = decision.levels[p].kept; l < decision.levels[p].offered; ++l, ++levels)
      line.bytes += 4 * textures * texels_of(std::max(1, page.width >> l), std::max(1, page.height >> l));
  }
  if (levels == 0) return;
  line.detail = std::to_string(levels) + " levels that nothing reads";
  report.left_out.lines.push_back(std::move(line));
}

std::array<int, 4> array_of(const PixelBox& box) {
  return {box.x, box.y, box.width, box.height};
}

UvTransform transform_of(const PackInput& in, const Region& region, const PlannedPlace& at,
                         const PlannedPage& page) {
  PlacedBox out;
  out.box = array_of(region.box);
  out.texture_width = in.width;
  out.texture_height = in.height;
  out.place = array_of(box_on_page(region, at));
  out.rotated = at.rotated;
  out.page_width = page.width;
  out.page_height = page.height;
  return region_transform(out);
}

}  // namespace

AtlasLayout layout_table(const PackOptions& options, const PackSource& source, const PackDecision& decision) {
  const PackInputs& inputs = source.inputs;
  const PackingPlan& plan = decision.plan;
  AtlasLayout out;
  out.gloss = inputs.gloss;
  out.diffuse_reduced = source.scene != nullptr;
  for (int p = 0; p < static_cast<int>(plan.pages.size()); ++p) {
    const PlannedPage& page = plan.pages[static_cast<std::size_t>(p)];
    const int levels = decision.levels[static_cast<std::size_t>(p)].kept;
    AtlasPage row{page.width, page.height, {}};
    out.levels = std::max(out.levels, levels);
    for (const Texture texture : both_textures)
      if (page.has[static_cast<std::size_t>(texture)])
        row.files[static_cast<std::size_t>(texture)] =
            page_files(p, texture, levels, options.output.write.formats);
    out.pages.push_back(std::move(row));
  }
  const std::vector<PackInput>& materials = source.materials();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const PackInput& m = materials[i];
    if (source.one_page && !m.facts.reached) continue;
    // One page for all materials gives every part by a texel, but for an alpha that is full.
    MaterialFate fate = source.one_page ? MaterialFate{} : decision.left_out.fates[i];
    const ChannelRange& range = m.facts.range;
    if (source.one_page && range.constant(alpha_channel) && range.most[alpha_channel] == 255)
      fate.constant[alpha_channel] = 255;
    if (!m.facts.reached && !fate.texels) continue;
    AtlasMaterialRow row{m.name, fate.texels, m.alpha_mode, m.alpha_cutoff, fate.constant, {}, {}};
    row.layers = m.color[static_cast<std::size_t>(Texture::specular_gloss)].layers;
    for (std::size_t c = 0; c < channel_count && m.facts.floats; ++c)
      if (fate.constant[c]) row.value[c] = c == alpha_channel && m.facts.opaque ? 1 : m.facts.exact[c];
    row.defines = material_defines(fate, m.alpha_mode);
    if (const MaterialVariant* variant =
            options.leave_out.variants ? options.leave_out.variants->find(m.name) : nullptr)
      row.defines.insert(row.defines.end(), variant->defines.begin(), variant->defines.end());
    out.materials.push_back(std::move(row));
    if (source.one_page)
      add_part_rects(m, source.one_page->places[i], source, decision, out);
    else if (fate.texels)
      add_rects(m, fate.owner, decision, out);
  }
  return out;
}

BoxesOnPage boxes_of(const PackInput& in, std::size_t owner, const PackDecision& decision) {
  BoxesOnPage out;
  const auto& [regions, places] = decision.needed;
  for (std::size_t r = first_region_of(regions, owner); r < regions.size() && regions[r].material == owner;
       ++r) {
    const PlannedPlace& at = places[r];
    const PlannedPage& page = decision.plan.pages[static_cast<std::size_t>(at.page)];
    if (out.page >= 0 && out.page != at.page)
      throw Error::at(in.name, "its islands lie on several pages, which one material cannot read",
                      "a larger " + setting("page") + ", or no " + setting("islands"));
    out.page = at.page;
    out.own_page = regions[r].own_page;
    // The box that holds a triangle is looked for in texels of level 0.
    out.boxes.push_back({array_of(regions[r].box), transform_of(in, regions[r], at, page),
                         regions[r].texels.empty() ? RowRuns{} : decision.parts[r].texels});
  }
  return out;
}

void account(const PackInputs& inputs, const PackDecision& decision, PackResult& report) {
  std::uint64_t cells = 0, regions = 0, single = 0;
  std::size_t singles = 0;
  for (std::size_t r = 0; r < decision.needed.regions.size(); ++r) {
    const PlannedPlace& place = decision.needed.places[r];
    const PlannedPage& page = decision.plan.pages[static_cast<std::size_t>(place.page)];
    const auto textures = static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
    const std::uint64_t area = decision.needed.regions[r].area();
    regions += textures * area;
    cells += textures * (place.cell_texels > 0 ? place.cell_texels : place.cell.area());
    if (textures == 1) single += area, ++singles;
  }
  report.region_texels = regions;
  report.gutter_texels = cells - regions;
  report.waste_texels = decision.plan.page_texels() - cells;
  account_resolution(inputs, decision, report);
  account_mips(decision, report);
  if (singles == 0) return;
  report.left_out.lines.push_back({"textures", std::to_string(singles) + " regions need one texture only",
                                   singles, single, 0, 4 * single, 0});
  report.left_out.after.texels -= single;
}

void account_of_parts(const OnePage& of, const PackDecision& decision, PackResult& report) {
  LeaveOut& told = report.left_out;
  std::vector<LeaveOutLine> lines = of.lines;
  // Sharing takes texels. A number takes none, since others may share what is beside it.
  const std::uint64_t fewer = of.before.texels - std::min(of.before.texels, told.before.texels);
  for (LeaveOutLine& line : lines)
    if (line.what == "equal") line.texels = fewer, line.bytes = 4 * fewer;
  told.lines.insert(told.lines.begin(), lines.begin(), lines.end());
  told.before = of.before;
  told.after.channel_texels = 0;
  for (const Region& region : decision.regions)
    told.after.channel_texels += of.channels[region.material] * texels_of(region.width(), region.height());
}

}  // namespace etak
