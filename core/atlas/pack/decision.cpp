// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/decision.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "core/atlas/pack/gltf_pack.h"
#include "core/atlas/pack/pack.h"
#include "core/atlas/sources/apply_variants.h"
#include "core/atlas/sources/pictures.h"
#include "core/image/mips.h"

namespace etak {

// Every material that uses the texels of `owner`.
template <class Act>
void PackDecision::users(std::size_t owner, Act act) const {
  for (std::size_t j = 0; j < left_out_.fates.size(); ++j)
    if (left_out_.fates[j].texels && left_out_.fates[j].owner == owner)
      act(inputs_.materials[j], left_out_.fates[j]);
}

void PackDecision::decide(const AtlasLayout* previous) {
  std::vector<MaterialFacts> facts;
  for (const PackInput& m : inputs_.materials) facts.push_back(m.facts);
  left_out_ = leave_out(facts, options_.leave_out);
  regions_ = regions_needed();
  for (Region& region : regions_) region.shrink = resolution(region).shrink;
  for (Region& region : regions_)
    if (region.levels > 0) region.levels = std::max(1, region.levels - region.shrink);
  std::vector<std::string> names;
  for (const PackInput& m : inputs_.materials) names.push_back(m.name);
  plan_ = plan_pages(regions_, names, plan_options(), previous);
}

std::vector<Region> PackDecision::regions_needed() const {
  std::vector<Region> out;
  for (std::size_t i = 0; i < left_out_.fates.size(); ++i) {
    const MaterialFate& fate = left_out_.fates[i];
    if (!fate.texels || fate.owner != i) continue;
    std::array<bool, 2> in{false, false};
    int levels = 1;
    bool own_page = false;
    users(i, [&](const PackInput& m, const MaterialFate& user) {
      own_page = own_page || m.own_page;
      for (std::size_t t = 0; t < 2; ++t) in[t] = in[t] || user.varies[t];
      levels = levels == 0 || m.facts.levels == 0 ? 0 : std::max(levels, m.facts.levels);
    });
    if (options_.leave_out.keep.contains("textures")) in = {true, true};
    if (options_.leave_out.keep.contains("mips")) levels = 0;
    for (const PixelBox& box : fate.boxes) out.push_back({i, box, in, own_page, levels, 0});
  }
  // The only picture of a scene keeps its sampler, and so its other side beyond each edge.
  if (scene_ != nullptr && out.size() == 1) {
    const PackInput& m = inputs_.materials[out[0].material];
    if (out[0].box == PixelBox{0, 0, m.width, m.height} && reads_around(out[0])) out[0].own_page = true;
  }
  return out;
}

const Resolution& PackDecision::resolution(const Region& region) {
  const PackInput& m = inputs_.materials[region.material];
  const PixelBox& box = region.box;
  int unseen = 15;
  bool mask = false;
  users(region.material, [&](const PackInput& user, const MaterialFate&) {
    unseen = std::min(unseen, user.facts.unseen);
    mask = mask || user.alpha_mode == AlphaMode::mask;
  });
  const auto [found, fresh] = resolutions_.try_emplace(
      std::array{static_cast<int>(region.material), box.x, box.y, box.width, box.height, unseen, int{mask}});
  const bool asked = options_.leave_out.max_error || unseen > 0;
  if (!fresh || !asked || options_.leave_out.keep.contains("resolution")) return found->second;
  std::vector<std::string> ignored;
  const MaterialPair pair = load_pair(m, ignored);
  MipOptions mips;
  mips.levels = options_.leave_out.max_error ? 0 : unseen + 1;
  if (mask) mips.alpha_cutoff = m.alpha_cutoff;
  const MipPair chain = region_chain(part_of(pair.diffuse_alpha, box), part_of(pair.specular_gloss, box),
                                     mips, inputs_.gloss, options_.run.threads);
  const bool whole = box == PixelBox{0, 0, m.width, m.height};
  found->second = resolution_of(chain, mask, whole ? m.wrap : WrapBoth{Wrap::clamp, Wrap::clamp}, unseen,
                                options_.leave_out.max_error, options_.run.threads);
  return found->second;
}

int PackDecision::levels() const {
  if (options_.layout.mips) return *options_.layout.mips;
  if (options_.leave_out.variants && !mips_are_read(*options_.leave_out.variants, inputs_)) return 1;
  const auto& formats = options_.output.write.formats;
  const bool container = std::any_of(formats.begin(), formats.end(), [](const std::string& format) {
    return format == "ktx2" || format == "dds";
  });
  return container ? 0 : 1;
}

// Whether bilinear filtering in the box reads what lies beyond the picture's edge, on its other side.
bool PackDecision::reads_around(const Region& region) const {
  const PackInput& m = inputs_.materials[region.material];
  const PixelBox& box = region.box;
  return (m.wrap[0] != Wrap::clamp && (box.x == 0 || box.x + box.width == m.width)) ||
         (m.wrap[1] != Wrap::clamp && (box.y == 0 || box.y + box.height == m.height));
}

PlanOptions PackDecision::plan_options() const {
  PlanOptions out;
  out.rects.form = options_.layout.form.value_or(PageForm::mixed);
  out.rects.side = options_.layout.page;
  out.rects.largest_side = options_.layout.page;
  out.rects.rotate = options_.layout.rotate;
  out.rects.effort = options_.layout.effort;
  out.rects.max_seconds = options_.layout.max_seconds;
  out.rects.threads = options_.run.threads;
  out.levels = levels();
  out.gutter = options_.layout.gutter;
  out.split_textures = !options_.leave_out.keep.contains("textures");
  out.most_extra_area = options_.layout.most_extra_area;
  if (scene_) {
    // Viewers make the mips that samplers ask for by themselves, and UVs cannot be inset without shrinking
    // the picture.
    out.may_inset = false;
    out.bare_alone = regions_.size() != 1 || !reads_around(regions_[0]);
    out.free_first = !options_.layout.form;
    out.least_gutter = 1;
    out.levels = scene_->sampled_levels(out.levels);
  }
  return out;
}

int PackDecision::offered_levels(int p) const {
  const PlannedPage& page = plan_.pages[static_cast<std::size_t>(p)];
  const int full = full_mip_levels(page.width, page.height), wanted = levels();
  return wanted == 0 ? full : std::min(wanted, full);
}

int PackDecision::page_levels(int p) const {
  const int offered = offered_levels(p);
  if (options_.leave_out.keep.contains("mips")) return offered;
  int read = 1;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (plan_.places[r].page != p) continue;
    const int own = full_mip_levels(regions_[r].width(), regions_[r].height());
    read = std::max(read, regions_[r].levels == 0 ? own : std::min(own, regions_[r].levels));
  }
  return std::min(offered, read);
}

bool PackDecision::learn(const std::vector<Learned>& learned) {
  for (std::size_t i = 0; i < learned.size(); ++i) {
    const Learned& from = learned[i];
    MaterialFacts& to = inputs_.materials[i].facts;
    if (to.learned || !from.seen[0] || !from.seen[1]) continue;
    to.learned = true;
    to.range = from.range;
    to.color_hash = from.hash[0];
    to.specular_hash = from.hash[1];
  }
  // The same files read in the same way were read once.
  std::map<std::string, const MaterialFacts*> known;
  for (const PackInput& m : inputs_.materials)
    if (m.facts.learned) known.try_emplace(m.facts.source, &m.facts);
  std::vector<MaterialFacts> facts;
  for (PackInput& m : inputs_.materials) {
    if (const auto same = known.find(m.facts.source); !m.facts.learned && same != known.end()) {
      m.facts.learned = true;
      m.facts.range = same->second->range;
      m.facts.color_hash = same->second->color_hash;
      m.facts.specular_hash = same->second->specular_hash;
    }
    facts.push_back(m.facts);
  }
  left_out_ = leave_out(facts, options_.leave_out);
  const std::vector<Region> now = regions_needed();
  return now.size() != regions_.size() ||
         !std::equal(now.begin(), now.end(), regions_.begin(), [](const Region& a, const Region& b) {
           return std::tie(a.material, a.box, a.in, a.own_page) ==
                  std::tie(b.material, b.box, b.in, b.own_page);
         });
}

}  // namespace etak
