// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/compose.h"

#include <algorithm>
#include <optional>

#include "core/atlas/sources/strip_reader.h"
#include "core/atlas/texels/place_outline.h"
#include "core/atlas/texels/place_texels.h"
#include "core/atlas/texels/resolution.h"
#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"
#include "core/image/dilate.h"
#include "core/image/mips.h"

namespace etak {

struct Composer::Streamed {
  std::array<FileBytes, 2> own_files;
  std::optional<StripReader> reader;
  ContentHash hash;
};

Composer::Composer(const std::vector<PackInput>& materials, const std::vector<Region>& regions,
                   const PackingPlan& plan, const ComposeOptions& options)
    : materials_(materials), regions_(regions), plan_(plan), options_(options), files_(options.threads) {}

Composer::~Composer() = default;

PlannedPlace Composer::place_in(const PagePixels& pixels, std::size_t region) const {
  PlannedPlace out = plan_.places[region];
  out.y -= pixels.top();
  out.cell.y -= pixels.top();
  return out;
}

bool Composer::in_file_order(std::size_t region) const {
  const PackInput& m = materials_[regions_[region].material];
  return !m.convert && m.is_whole(regions_[region].box) && regions_[region].shrink == 0 &&
         !plan_.places[region].rotated;
}

void Composer::stream(const Task& task, PagePixels& pixels, unsigned worker) {
  const PlannedPlace at = place_in(pixels, task.region);
  const std::size_t owner = regions_[task.region].material, t = index_of(task.texture);
  const PackInput& m = materials_[owner];
  const PixelsView8 page = pixels.view(task.texture);
  const int begin = std::max(0, at.y), end = std::min(page.height, at.y + m.height);
  if (begin >= end) return;
  std::unique_ptr<Streamed>& open = open_[task.region][t];
  if (!open) {
    // A region that is read in one go uses the worker's memory for its files, as the next region will.
    const bool at_once = begin == at.y && end == at.y + m.height;
    open = std::make_unique<Streamed>();
    open->reader.emplace(m, task.texture, at_once ? files_[worker] : open->own_files);
  }
  const PixelsView8 out = page.part({at.x, begin, m.width, end - begin});
  Learned& learned = halves_[owner][t];
  const auto width = static_cast<std::size_t>(m.width);
  open->reader->read(out, [&](int first, int count) {
    for (int y = first; y < first + count; ++y) {
      add_texels(learned.range, task.texture, out.row(y), width);
      open->hash.add(out.row(y), 4 * width);
    }
  });
  if (end < at.y + m.height) return;
  learned.clamped[t] += open->reader->clamped();
  learned.hash[t] = open->hash.value();
  learned.seen[t] = true;
  open.reset();
}

void Composer::place(const Task& task, PagePixels& pixels, const Image8& picture, Learned& learned) {
  const PlannedPlace at = place_in(pixels, task.region);
  const PixelsView8 page = pixels.view(task.texture);
  if (!materials_[regions_[task.region].material].facts.learned) {
    const ConstPixelsView8 all = etak::view(picture);
    ContentHash hash;
    for (int y = 0; y < all.height; ++y) {
      add_texels(learned.range, task.texture, all.row(y), static_cast<std::size_t>(all.width));
      hash.add(all.row(y), all.stride);
    }
    learned.hash[index_of(task.texture)] = hash.value();
    learned.seen[index_of(task.texture)] = true;
  }
  const Region& region = regions_[task.region];
  const PackInput& m = materials_[region.material];
  if (region.shrink > 0) {
    const MaterialPair stored = stored_pair(pair_of(region.material), region, m, options_.gloss);
    return copy_texels(etak::view(stored.of(task.texture)), {0, 0, region.width(), region.height()}, page,
                       at.x, at.y, at.rotated);
  }
  place_picture(picture, region.box, m.wrap, at, page);
}

const MaterialPair& Composer::pair_of(std::size_t material) {
  Cached* cached = nullptr;
  {
    const std::lock_guard lock(pairs_lock_);
    cached = &pairs_[material];
  }
  cached->once.call([&] {
    std::vector<std::string> ignored;  // told when the material was first looked at
    cached->pair = load_pair(materials_[material], ignored);
  });
  return cached->pair;
}

const Image8* Composer::normals_for(std::size_t material, int levels) {
  const PackInput& m = materials_[material];
  if (levels < 2 || !m.has_normals()) return nullptr;
  Cached* cached = nullptr;
  {
    const std::lock_guard lock(pairs_lock_);
    cached = &pairs_[material];
  }
  cached->normals_once.call([&] { cached->normals = normals_of(m, {0, 0, m.width, m.height}); });
  return &cached->normals;
}

std::size_t Composer::end_of_outline(std::size_t region) const {
  std::size_t end = region + 1;
  while (regions_[region].outline != 0 && end < regions_.size() &&
         regions_[end].outline == regions_[region].outline)
    ++end;
  return end;
}

void Composer::begin_page(int page) {
  halves_.assign(materials_.size(), {});
  open_.clear();
  open_.resize(regions_.size());
  clean_ = plan_.clean_levels(page);
}

void Composer::region_texels(std::size_t region, Texture texture, PagePixels& pixels, unsigned worker) {
  if (in_file_order(region)) return stream({region, texture}, pixels, worker);
  const std::size_t owner = regions_[region].material;
  place({region, texture}, pixels, pair_of(owner).of(texture), halves_[owner][index_of(texture)]);
}

void Composer::learn(std::vector<Learned>& learned) const {
  for (std::size_t i = 0; i < halves_.size(); ++i) {
    for (std::size_t t = 0; t < 2; ++t) {
      const Learned& half = halves_[i][t];
      if (!half.seen[t]) continue;
      learned[i].range.add(half.range);
      learned[i].hash[t] = half.hash[t];
      learned[i].seen[t] = true;
      learned[i].clamped[t] = half.clamped[t];
    }
  }
}

void Composer::texels(int page, PagePixels& pixels, std::vector<Learned>& learned,
                      const std::function<void()>& region_done) {
  begin_page(page);
  // The pieces of an outline have texels in common, which one thread writes: its first piece stands for all.
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < regions_.size(); i = end_of_outline(i))
    for (const Texture texture : both_textures)
      if (plan_.places[i].page == page && plan_.pages[static_cast<std::size_t>(page)].has[index_of(texture)])
        tasks.push_back({i, texture});
  // The largest first, so that none is left for the end.
  std::stable_sort(tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) {
    const PixelBox &first = regions_[a.region].box, &second = regions_[b.region].box;
    return std::int64_t{first.width} * first.height > std::int64_t{second.width} * second.height;
  });
  parallel_chunks(tasks.size(), options_.threads, 1, [&](std::size_t begin, std::size_t, unsigned worker) {
    const Task& first = tasks[begin];
    for (std::size_t i = first.region, end = end_of_outline(i); i < end; ++i) {
      region_texels(i, first.texture, pixels, worker);
      if (region_done) region_done();
    }
  });
  learn(learned);
  pairs_.clear();
  for (auto& files : files_) files = {};
}

void Composer::end_page(int page, PagePixels& pixels, std::vector<Learned>& learned) {
  learn(learned);
  pairs_.clear();
  for (auto& files : files_) files = {};
  pixels.show_whole_levels();
  shared_mips(page, pixels);
}

void Composer::mips(int page, PagePixels& pixels) {
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < regions_.size(); i = end_of_outline(i))
    if (plan_.places[i].page == page) here.push_back(i);
  clean_ = plan_.clean_levels(page);
  parallel_chunks(here.size(), options_.threads, 1,
                  [&](std::size_t begin, std::size_t, unsigned) { region_mips(here[begin], pixels); });
  pairs_.clear();
  shared_mips(page, pixels);
}

// Where nothing has to be turned, cut off or put in the place of a texture that is not there, levels are made
// where they belong.
bool Composer::mips_in_place(std::size_t region, const PlannedPlace& at, int levels,
                             PagePixels& pixels) const {
  const PackInput& m = materials_[regions_[region].material];
  const PixelBox& source = regions_[region].box;
  if (at.rotated || regions_[region].shrink > 0 || m.has_normals() || options_.gloss != GlossForm::schueler)
    return false;
  if (levels > full_mip_levels(source.width, source.height)) return false;
  std::array<std::vector<PixelsView8>, 2> to;
  for (const Texture texture : both_textures)
    for (int l = 0; l < levels; ++l) {
      const PixelsView8 page = pixels.view(texture, l);
      if (page.data == nullptr) return false;
      const int width = std::max(1, source.width >> l), height = std::max(1, source.height >> l);
      const PixelBox part = l == 0 ? PixelBox{at.x, at.y, width, height}
                                   : boxes_at(at, l, width, height, page.width, page.height).part;
      if (part.width != width || part.height != height) return false;
      to[index_of(texture)].push_back(page.part(part));
    }
  if (options_.bleed) bleed_under_alpha(to[0][0], to[1][0]);
  mip_levels(to[0][0], to[1][0], mip_options(m, levels), 1, to[0], to[1]);
  for (const Texture texture : both_textures)
    for (int l = 1; l < levels; ++l) {
      const PixelsView8 page = pixels.view(texture, l);
      const PixelsView8& own = to[index_of(texture)][static_cast<std::size_t>(l)];
      const LevelBoxes boxes = boxes_at(at, l, own.width, own.height, page.width, page.height);
      fill_gutter(page, boxes.part, boxes.cell, m.wrap_of(source), false);
    }
  return true;
}

// Makes the mips of any region, by way of pictures of its own.
void Composer::mips_by_copy(std::size_t region, const PlannedPlace& at, int levels, PagePixels& pixels) {
  const Region& of = regions_[region];
  const PackInput& m = materials_[of.material];
  const PixelBox on_page = box_on_page(of, at);
  std::array<Image8, 2> level_0;
  for (const Texture texture : both_textures)
    level_0[index_of(texture)] = pixels.view(texture).data != nullptr
                                     ? texels_back(pixels.view(texture), on_page, at.rotated)
                                     : missing_texture<std::uint8_t>(texture, of.width(), of.height());
  auto& [a, b] = level_0;
  const bool has_both_textures = pixels.view(Texture::diffuse_alpha).data != nullptr &&
                                 pixels.view(Texture::specular_gloss).data != nullptr;
  if (options_.bleed && bleed_under_alpha(view(a), has_both_textures ? view(b) : PixelsView8{}) > 0)
    for (const Texture texture : both_textures)
      if (pixels.view(texture).data != nullptr)
        copy_texels(view(level_0[index_of(texture)]), {0, 0, of.width(), of.height()}, pixels.view(texture),
                    at.x, at.y, at.rotated);
  MipPair chain;
  if (of.shrink > 0 && m.has_normals() && levels > 1) {
    // The spread of all normals counts, also of those between the texels that are stored.
    const MaterialPair& whole = pair_of(of.material);
    a = part_of(whole.diffuse_alpha, of.box);
    b = part_of(whole.specular_gloss, of.box);
    chain = levels_from(of.shrink, levels, PairPart<std::uint8_t>{m, of.box, a, b}, options_.gloss);
  } else {
    chain = levels_from(0, levels, PairPart<std::uint8_t>{m, of.box, a, b}, options_.gloss);
  }
  place_levels(chain, at, m.wrap_of(of.box), 1, levels,
               [&](Texture texture, int level) { return pixels.view(texture, level); });
}

// Level 0 may have its gutter from the picture already; then only the rounding of the cell is left, unless
// the picture's own edge was bled since.
void Composer::fill_first_gutter(std::size_t region, const PlannedPlace& at, PagePixels& pixels) const {
  const Region& of = regions_[region];
  const PackInput& m = materials_[of.material];
  const bool has_gutter =
      (m.convert || at.rotated) && of.shrink == 0 && !(options_.bleed && m.is_whole(of.box));
  const PixelBox box = box_on_page(of, at), filled = has_gutter ? grown(box, at.gutter) : box;
  const WrapBoth wrap = filled == box ? m.wrap_of(of.box) : WrapBoth{Wrap::clamp, Wrap::clamp};
  for (const Texture texture : both_textures)
    if (const PixelsView8 page = pixels.view(texture); page.data != nullptr)
      fill_gutter(page, filled, at.cell, wrap, at.rotated);
}

void Composer::region_mips(std::size_t region, PagePixels& pixels) {
  const PlannedPlace at = place_in(pixels, region);
  const int levels = std::min(pixels.levels(), clean_);
  const std::size_t owner = regions_[region].material;
  if (has_texels_around(regions_[region], materials_[owner])) {
    // Gutters of level 0 have the picture's texels already, where that is the level that is stored.
    if (levels == 1 && !options_.bleed && regions_[region].outline != 0 && regions_[region].shrink == 0)
      return;
    const std::size_t pieces = end_of_outline(region) - region;
    return place_outline(
        {{&regions_[region], pieces}, {&plan_.places[region], pieces}},
        OutlinePictures<MaterialPair>{materials_[owner], pair_of(owner), normals_for(owner, levels)}, levels,
        options_, [&](Texture texture, int level) { return pixels.view(texture, level); });
  }
  if ((levels > 1 || options_.bleed) && !mips_in_place(region, at, levels, pixels))
    mips_by_copy(region, at, levels, pixels);
  fill_first_gutter(region, at, pixels);
}

void Composer::shared_mips(int page, PagePixels& pixels) const {
  if (pixels.levels() <= clean_ || plan_.pages[static_cast<std::size_t>(page)].width == 0) return;
  make_shared_levels<std::uint8_t>(clean_, pixels.levels(), options_.gloss, options_.threads,
                                   [&](Texture texture, int level) { return pixels.view(texture, level); });
}

}  // namespace etak
