// SPDX-License-Identifier: Apache-2.0
#include "core/pack/decision.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "core/atlas/sources/apply_variants.h"
#include "core/atlas/sources/pictures.h"
#include "core/atlas/texels/place_outline.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/image/mips.h"
#include "core/image/texture_bytes.h"
#include "core/pack/pack.h"
#include "core/pack/scene/gltf_pack.h"

namespace etak {
namespace {

// Mips that the settings ask for; 0: all.
int levels_asked(const PackOptions& options, const PackInputs& inputs) {
  if (options.layout.mips) return *options.layout.mips;
  if (options.leave_out.variants && !mips_are_read(*options.leave_out.variants, inputs)) return 1;
  return writes_containers(options.output.write) ? 0 : 1;
}

// Mips that samplers may read, 0: all: those that the settings ask for, and those that viewers make of a scene's pages.
int levels_sampled(const PackOptions& options, const PackSource& source) {
  const int asked = levels_asked(options, source.inputs);
  return source.scene ? source.scene->sampled_levels(asked) : asked;
}

LeaveOut left_out_of(const PackSource& source, const PackOptions& options, const PackDecision& way) {
  std::vector<MaterialFacts> facts;
  for (const PackInput& m : source.inputs.materials) facts.push_back(m.facts);
  LeaveOutOptions what = options.leave_out;
  what.islands = way.islands;
  what.outlines = way.outlines;
  if (way.whole) what.keep.insert("crop");
  what.levels = levels_sampled(options, source);
  what.gutter = way.gutter;
  // Parts that materials share, and parts that are numbers, were left out before.
  if (source.one_page) what.keep.insert({"equal", "alpha", "constant", "grey"});
  return leave_out(facts, what);
}

// For each material the materials that use its texels.
using Users = std::vector<std::vector<std::size_t>>;

Users users_by_owner(const std::vector<MaterialFate>& fates) {
  Users out(fates.size());
  for (std::size_t i = 0; i < fates.size(); ++i)
    if (fates[i].texels) out[fates[i].owner].push_back(i);
  return out;
}

// Whether bilinear filtering in the box reads what lies beyond the picture's edge, on its other side.
bool reads_around(const PackInput& m, const PixelBox& box) {
  return (m.wrap[0] != Wrap::clamp && (box.x == 0 || box.x + box.width == m.width)) ||
         (m.wrap[1] != Wrap::clamp && (box.y == 0 || box.y + box.height == m.height));
}

// The regions at the full size of their boxes.
std::vector<Region> regions_needed(const PackOptions& options, const PackSource& source,
                                   const PackDecision& way, const Users& users) {
  const std::vector<MaterialFate>& fates = way.left_out.fates;
  std::vector<Region> out;
  for (std::size_t i = 0; i < fates.size(); ++i) {
    const MaterialFate& fate = fates[i];
    if (!fate.texels || fate.owner != i) continue;
    std::array<bool, 2> in{false, false};
    int levels = 1;
    bool own_page = way.whole;
    for (const std::size_t user : users[i]) {
      const PackInput& m = source.inputs.materials[user];
      own_page = own_page || m.own_page;
      for (std::size_t t = 0; t < 2; ++t) in[t] = in[t] || fates[user].varies[t];
      levels = levels == 0 || m.facts.levels == 0 ? 0 : std::max(levels, m.facts.levels);
    }
    if (options.leave_out.keep.contains("textures") || source.one_page) in = {true, true};
    if (options.leave_out.keep.contains("mips")) levels = 0;
    for (const PicturePart& part : fate.kept)
      out.push_back({i, part.box, in, own_page, levels, 0, part.texels});
  }
  // The only picture of a scene keeps its sampler, and so its other side beyond each edge.
  if (source.scene && out.size() == 1) {
    const PackInput& m = source.inputs.materials[out[0].material];
    if (m.is_whole(out[0].box) && reads_around(m, out[0].box)) out[0].own_page = true;
  }
  return out;
}

// The pair of a material, and what is asked of the texels of a region.
struct ResolutionJob {
  const PackInput& material;
  const MaterialPair& pair;
  const PixelBox& box;
  bool mask;
  int unseen;  // halvings that nobody comes near enough to see
  const PackOptions& options;
  GlossForm gloss;

  MipOptions mips(int levels) const {
    MipOptions out;
    out.levels = levels;
    if (mask) out.alpha_cutoff = material.alpha_cutoff;
    return out;
  }
  Resolution of(const MipPair& chain, const WrapBoth& wrap, const PixelBox& looked_at) const {
    return resolution_of(chain, {mask, unseen, options.leave_out.max_error}, wrap, looked_at,
                         options.run.threads);
  }
};

// The resolution of a box, by the mips of its own texels.
Resolution resolution_of_box(const ResolutionJob& job) {
  const int levels = job.options.leave_out.max_error ? 0 : job.unseen + 1;
  const MipPair chain =
      region_chain(part_of(job.pair.diffuse_alpha, job.box), part_of(job.pair.specular_gloss, job.box),
                   job.mips(levels), job.gloss, job.options.run.threads);
  return job.of(chain, job.material.wrap_of(job.box), {0, 0, job.box.width, job.box.height});
}

// The resolution of an outline, by the picture's mips, of which filtering reads a texel beyond the box. Only levels whose
// sides are whole halves of the picture's count.
Resolution resolution_of_outline(const ResolutionJob& job) {
  Resolution out;
  const PackInput& m = job.material;
  for (int level = 1; (m.width | m.height) % (1 << level) == 0; ++level) {
    const int step = 1 << level;
    const PixelBox texels = grown(whole_texels(job.box, level), 1);
    const PixelBox from{texels.x * step, texels.y * step, texels.width * step, texels.height * step};
    MipPair chain = region_chain(texels_around(job.pair.diffuse_alpha, from, m.wrap),
                                 texels_around(job.pair.specular_gloss, from, m.wrap), job.mips(level + 1),
                                 job.gloss, job.options.run.threads);
    PixelBox inside = common_part(from, {0, 0, m.width, m.height});
    inside.x -= from.x;
    inside.y -= from.y;
    for (const Texture texture : both_textures) clamp_levels(chain.of(texture), inside, m.wrap);
    const Resolution found = job.of(chain, {Wrap::clamp, Wrap::clamp},
                                    {job.box.x - from.x, job.box.y - from.y, job.box.width, job.box.height});
    if (found.shrink < level) break;
    out = found;
  }
  return out;
}

// How many texels a region is stored with.
Resolution resolution_for(const Region& region, const PackOptions& options, const PackInputs& inputs,
                          const std::vector<std::size_t>& users, FoundResolutions& found) {
  const PackInput& m = inputs.materials[region.material];
  const PixelBox& box = region.box;
  int unseen = 15;
  bool mask = false;
  for (const std::size_t user : users) {
    unseen = std::min(unseen, inputs.materials[user].facts.unseen);
    mask = mask || inputs.materials[user].alpha_mode == AlphaMode::mask;
  }
  const bool asked = options.leave_out.max_error || unseen > 0, outline = !region.texels.empty();
  if (!asked || options.leave_out.keep.contains("resolution")) return {};
  const auto [known, fresh] =
      found.try_emplace(std::array{static_cast<int>(region.material), box.x, box.y, box.width, box.height,
                                   unseen, int{mask}, int{outline}});
  if (!fresh) return known->second;
  std::vector<std::string> ignored;
  const MaterialPair pair = load_pair(m, ignored);
  const ResolutionJob job{m, pair, box, mask, unseen, options, inputs.gloss};
  return known->second = outline ? resolution_of_outline(job) : resolution_of_box(job);
}

// The region as it is stored with so many texels. An outline lies on whole texels of all mips of the picture that it keeps
// clean.
//   plan   of its options the levels and the gutter
Region stored(Region region, const Resolution& resolution, const PackInput& m, const PlanOptions& plan) {
  if (resolution.shrink == 0) return region;
  region.shrink = resolution.shrink;
  if (region.levels > 0) region.levels = std::max(1, region.levels - region.shrink);
  if (region.texels.empty()) return region;
  const int wanted = levels_wanted(plan.levels, region.levels);
  for (PixelBox before{}; !(region.box == before);) {
    before = region.box;
    const int step = 1 << (clean_levels(region.width(), region.height(), wanted, plan.gutter) - 1);
    const auto whole = [&](int& from, int& size, int most) {
      const int texel = step << region.shrink,
                end = std::min(most, (from + size + texel - 1) / texel * texel);
      from = from / texel * texel;
      size = end - from;
    };
    whole(region.box.x, region.box.width, m.width);
    whole(region.box.y, region.box.height, m.height);
  }
  region.texels = at_level(region.texels, region.shrink);
  return region;
}

PlanOptions plan_options(const PackOptions& options, const PackSource& source, const PackDecision& way) {
  const std::vector<Region>& regions = way.parts;
  PlanOptions out;
  out.rects.form = options.layout.form.value_or(PageForm::mixed);
  out.rects.multiple = options.layout.multiple;
  out.rects.side = options.layout.page;
  out.rects.largest_side = options.layout.page;
  out.rects.rotate = options.layout.rotate;
  out.rects.effort = options.layout.effort;
  out.rects.max_seconds = options.layout.max_seconds;
  out.rects.threads = options.run.threads;
  out.levels = levels_sampled(options, source);
  if (const BlockFormat* format = options.output.compress.format; format != nullptr) {
    out.block_side = format->block_width;
    // No page whose sides are powers of two holds whole blocks of 5 or 6 texels alone.
    if (!std::has_single_bit(static_cast<unsigned>(out.block_side)) && !options.layout.form)
      out.rects.form = PageForm::free;
  }
  // A region by itself takes a page of just its size, without gutters, unless they were asked for.
  out.gutter = regions.size() == 1 ? options.layout.gutter : way.gutter;
  out.split_textures = !options.leave_out.keep.contains("textures") && !source.one_page;
  out.most_extra_area = options.layout.most_extra_area;
  if (source.scene) {
    // Viewers make the mips that samplers ask for by themselves, and UVs cannot be inset without shrinking
    // the picture.
    out.may_inset = false;
    out.bare_alone =
        regions.size() != 1 || !reads_around(source.inputs.materials[regions[0].material], regions[0].box);
    out.free_first = !options.layout.form;
    out.least_gutter = 1;
  }
  if (source.one_page) {
    out.rects.form = options.layout.form.value_or(PageForm::free);
    out.free_first = false;
  }
  return out;
}

// The mips of each page.
std::vector<PageLevels> levels_of(const PackOptions& options, const PackInputs& inputs,
                                  const std::vector<Region>& regions, const PackingPlan& plan) {
  std::vector<int> read(plan.pages.size(), options.leave_out.keep.contains("mips") ? 0 : 1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    int& most = read[static_cast<std::size_t>(plan.places[r].page)];
    const int own = full_mip_levels(regions[r].width(), regions[r].height());
    if (most > 0) most = std::max(most, regions[r].levels == 0 ? own : std::min(own, regions[r].levels));
  }
  const int asked = levels_asked(options, inputs);
  std::vector<PageLevels> out;
  for (std::size_t p = 0; p < plan.pages.size(); ++p) {
    const int full = full_mip_levels(plan.pages[p].width, plan.pages[p].height);
    const int offered = asked == 0 ? full : std::min(asked, full);
    out.push_back({offered, read[p] == 0 ? offered : std::min(offered, read[p])});
  }
  return out;
}

using TexelHash = std::array<std::uint64_t, 2>;

void teach(const ChannelRange& range, const TexelHash& color, const TexelHash& specular, MaterialFacts& to) {
  to.learned = true;
  to.range = range;
  to.color_hash = color;
  to.specular_hash = specular;
}

// Materials of one source get equal facts: their files, read in one way, are read once.
void teach_same_sources(PackInputs& inputs) {
  std::map<std::string, const MaterialFacts*> known;
  for (const PackInput& m : inputs.materials)
    if (m.facts.learned) known.try_emplace(m.facts.source, &m.facts);
  for (PackInput& m : inputs.materials) {
    const auto same = known.find(m.facts.source);
    if (m.facts.learned || same == known.end()) continue;
    const MaterialFacts& from = *same->second;
    teach(from.range, from.color_hash, from.specular_hash, m.facts);
  }
}

// Throws Error that tells the size of the one page that would hold the regions.
[[noreturn]] void refuse_page(const std::vector<Region>& regions, const std::vector<std::string>& names,
                              PlanOptions plan) {
  const std::string limit = std::to_string(plan.rects.largest_side);
  std::string needed = "more than " + std::to_string(max_image_side) + " a side";
  plan.rects.side = plan.rects.largest_side = max_image_side;
  try {
    const PlannedPage page = plan_pages(regions, names, plan).pages.at(0);
    needed = std::to_string(page.width) + " x " + std::to_string(page.height);
  } catch (const Error&) {  // no page at all holds them
  }
  throw Error::at(setting("goal"), "one page for all materials takes " + needed,
                  "at most " + limit + " x " + limit + ", a larger " + setting("page") + " or another goal");
}

enum class Way { outlines, islands, crops, whole };

// The texels around each region. Where a page holds no mips, viewers make them, of the whole page: regions mix sooner then.
std::optional<int> gutter_of(const PackOptions& options, const PackSource& source) {
  const bool by_viewers = levels_asked(options, source.inputs) == 1 && levels_sampled(options, source) > 1;
  return options.layout.gutter || !by_viewers ? options.layout.gutter : options.layout.viewers_gutter;
}

PackDecision decided(Way way, const PackOptions& options, const PackSource& source,
                     const AtlasLayout* previous, FoundResolutions& found) {
  PackDecision out;
  out.gutter = gutter_of(options, source);
  out.outlines = way == Way::outlines;
  out.islands = out.outlines || way == Way::islands;
  out.whole = way == Way::whole;
  out.left_out = left_out_of(source, options, out);
  const Users users = users_by_owner(out.left_out.fates);
  out.parts = regions_needed(options, source, out, users);
  PlanOptions plan = plan_options(options, source, out);
  for (const Region& region : out.parts) {
    Resolution resolution = resolution_for(region, options, source.inputs, users[region.material], found);
    // Filtering at a higher level reads beyond the texels that are read at level 0, which are an outline's own.
    if (!region.texels.empty() && plan.gutter == 0) resolution = {};
    Region fewer = stored(region, resolution, source.inputs.materials[region.material], plan);
    if (fewer.area() > region.area()) fewer = region, resolution = {};
    out.resolutions.push_back(resolution);
    out.regions.push_back(std::move(fewer));
  }
  std::vector<std::string> names;
  for (const PackInput& m : source.inputs.materials) names.push_back(m.name);
  try {
    out.plan = plan_pages(out.regions, names, plan, previous);
  } catch (const Error&) {
    if (!source.one_page) throw;
    refuse_page(out.regions, names, plan);
  }
  out.needed.places = out.plan.places;
  out.levels = levels_of(options, source.inputs, out.regions, out.plan);
  PlacedRegions pieces = outline_pieces(out.regions, out.plan);
  out.needed.regions = std::exchange(out.regions, std::move(pieces.regions));
  out.plan.places = std::move(pieces.places);
  out.plan.shapes.clear();
  return out;
}

// Whether some islands of a layout are several rectangles.
bool has_outlines(const AtlasLayout& layout) {
  return std::ranges::adjacent_find(layout.rects, [](const AtlasRect& a, const AtlasRect& b) {
           return a.name == b.name && a.island == b.island && a.holds == b.holds;
         }) != layout.rects.end();
}

// Whether islands may lie in each other's boxes. That is done on one page of any sides, and what lies in boxes stays so.
bool may_outline(const PackOptions& options, const PackSource& source, const AtlasLayout* previous) {
  return options.leave_out.islands && source.scene && !source.one_page &&
         (previous == nullptr || has_outlines(*previous)) &&
         options.layout.form.value_or(PageForm::free) == PageForm::free;
}

// Bytes of the pages' two textures on a GPU.
std::uint64_t gpu_bytes(const PackingPlan& plan) {
  std::uint64_t out = 0;
  for (const PlannedPage& page : plan.pages)
    for (const Texture texture : both_textures)
      if (page.has[index_of(texture)]) out += texture_bytes({page.width, page.height, 4}, true);
  return out;
}

// Adds the way of whole pictures where all others would take more than the textures that they replace.
void add_whole(std::vector<PackDecision>& ways, const PackOptions& options, const PackSource& source,
               FoundResolutions& found) {
  std::uint64_t least = gpu_bytes(ways.front().plan);
  for (const PackDecision& way : ways) least = std::min(least, gpu_bytes(way.plan));
  if (least <= source.scene->replaced_gpu_bytes()) return;
  PackDecision whole = decided(Way::whole, options, source, nullptr, found);
  if (gpu_bytes(whole.plan) < least) ways.push_back(std::move(whole));
}

}  // namespace

bool weighs_files(const PackOptions& options, const PackSource& source) {
  return weighs_disk(options.output.goal) && source.scene && source.scene->writes_scene();
}

std::vector<PackDecision> decide(const PackOptions& options, const PackSource& source,
                                 const AtlasLayout* previous, FoundResolutions& found) {
  std::vector<PackDecision> out;
  if (options.leave_out.islands && source.scene)
    out.push_back(decided(Way::islands, options, source, previous, found));
  if (may_outline(options, source, previous)) try {
      PackDecision outlines = decided(Way::outlines, options, source, previous, found);
      if (previous != nullptr && outlines.plan.kept_previous) {
        // The outlines stay where they are, though boxes that all move might take less.
        out[0] = std::move(outlines);
        return out;
      }
      if (outlines.plan.page_texels() < out[0].plan.page_texels()) out[0] = std::move(outlines);
    } catch (const Error&) {  // outlines take one page, and boxes may take several
    }
  try {
    out.push_back(decided(Way::crops, options, source, previous, found));
  } catch (const Error&) {
    if (out.empty()) throw;
    return out;  // a whole box may fit no page where its islands do
  }
  if (source.scene && !source.one_page && previous == nullptr && !options.layout.form &&
      !options.layout.gutter)
    add_whole(out, options, source, found);
  if (weighs_files(options, source)) return out;
  // Gutters around many islands can take more than what lies between them. Of ways that take the same the last is
  // taken, which changes the least.
  while (out.size() > 1) {
    const bool last = out[1].plan.page_texels() <= out[0].plan.page_texels();
    out.erase(out.begin() + (last ? 0 : 1));
  }
  return out;
}

bool learn(const std::vector<Learned>& learned, const PackOptions& options, PackSource& source,
           PackDecision& decision) {
  PackInputs& inputs = source.inputs;
  for (std::size_t i = 0; i < learned.size(); ++i)
    if (!inputs.materials[i].facts.learned && learned[i].seen[0] && learned[i].seen[1])
      teach(learned[i].range, learned[i].hash[0], learned[i].hash[1], inputs.materials[i].facts);
  teach_same_sources(inputs);
  decision.left_out = left_out_of(source, options, decision);
  const std::vector<Region> now =
      regions_needed(options, source, decision, users_by_owner(decision.left_out.fates));
  const std::vector<Region>& before = decision.parts;
  return std::equal(now.begin(), now.end(), before.begin(), before.end(),
                    [](const Region& a, const Region& b) {
                      return std::tie(a.material, a.box, a.in, a.own_page, a.texels) ==
                             std::tie(b.material, b.box, b.in, b.own_page, b.texels);
                    });
}

}  // namespace etak
