// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/compose.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/atlas/resolution.h"
#include "core/atlas/sources/strip_reader.h"
#include "core/base/error.h"
#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"
#include "core/image/dilate.h"
#include "core/image/mips.h"
#include "core/image/wrap.h"

namespace etak {
namespace {

bool is_whole(const PixelBox& box, const PackInput& m) {
  return box == PixelBox{0, 0, m.width, m.height};
}

// The cell's texels outside of the box, from the box: its edges, or what lies there when it is a whole
// picture that wraps.
void fill_gutter(const PixelsView8& page, const PixelBox& box, const PixelBox& cell, std::array<Wrap, 2> wrap,
                 bool rotated) {
  if (box == cell) return;
  if (rotated) std::swap(wrap[0], wrap[1]);
  if (wrap == std::array{Wrap::clamp, Wrap::clamp}) return replicate_edges(page, box, cell);
  for (int y = cell.y; y < cell.y + cell.height; ++y)
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      const int from_x = box.x + wrapped_texel(x - box.x, box.width, wrap[0]);
      const int from_y = box.y + wrapped_texel(y - box.y, box.height, wrap[1]);
      if (from_x != x || from_y != y) std::memcpy(page.at(x, y), page.at(from_x, from_y), 4);
    }
}

Image8 copy_of(const PixelsView8& page, const PixelBox& box, bool rotated) {
  Image8 out(rotated ? box.height : box.width, rotated ? box.width : box.height, 4);
  for (int y = 0; y < box.height; ++y) {
    if (!rotated) {
      std::memcpy(out.at(0, y).data(), page.at(box.x, box.y + y), 4 * static_cast<std::size_t>(box.width));
      continue;
    }
    for (int x = 0; x < box.width; ++x)
      std::memcpy(out.at(y, box.width - 1 - x).data(), page.at(box.x + x, box.y + y), 4);
  }
  return out;
}

}  // namespace

Image8 normals_of(const PackInput& m, const PixelBox& box) {
  if (m.load_normals) return part_of(m.load_normals(), box);
  FileBytes memory;
  PlaneRows rows(m.normal, memory);
  if (rows.width() != m.width || rows.height() != m.height)
    throw Error::at(m.normal.path,
                    "is " + std::to_string(rows.width()) + " x " + std::to_string(rows.height()),
                    std::to_string(m.width) + " x " + std::to_string(m.height) + ", as " + m.name + " is");
  Image8 out(box.width, box.height, 3);
  const auto pick = rows.pick();
  const auto step = static_cast<std::size_t>(rows.step());
  for (int y = 0; y < box.y + box.height; ++y) {
    const std::uint8_t* row = rows.read(1);
    if (y < box.y) continue;
    for (int x = 0; x < box.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y - box.y)[c] =
            row[static_cast<std::size_t>(box.x + x) * step + static_cast<std::size_t>(pick[c])];
  }
  return out;
}

void copy_texels(const ConstPixelsView8& picture, const PixelBox& box, const PixelsView8& page, int x, int y,
                 bool rotated) {
  if (!rotated) {
    for (int row = 0; row < box.height; ++row)
      std::memcpy(page.at(x, y + row), picture.at(box.x, box.y + row),
                  4 * static_cast<std::size_t>(box.width));
    return;
  }
  for (int row = 0; row < box.height; ++row)
    for (int column = 0; column < box.width; ++column)
      std::memcpy(page.at(x + box.height - 1 - row, y + column), picture.at(box.x + column, box.y + row), 4);
}

MaterialPair load_pair(const PackInput& m, std::vector<std::string>& remarks) {
  if (m.convert) return m.convert(remarks);
  MaterialPair out{Image8(m.width, m.height, 4), Image8(m.width, m.height, 4)};
  std::array<FileBytes, 2> files;
  for (const Texture texture : both_textures) {
    Image8& picture = texture == Texture::diffuse_alpha ? out.diffuse_alpha : out.specular_gloss;
    StripReader(m, texture, files).read(view(picture), [](int, int) {});
  }
  return out;
}

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

int Composer::clean_levels(int page) const {
  int out = 1;
  for (const PlannedPlace& each : plan_.places)
    if (each.page == page) out = std::max(out, each.clean_levels);
  return out;
}

bool Composer::in_file_order(std::size_t region) const {
  const PackInput& m = materials_[regions_[region].material];
  return !m.convert && is_whole(regions_[region].box, m) && regions_[region].shrink == 0 &&
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
    // A region that is read in one go leaves the memory of its files to the next.
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
  const PixelBox& box = region.box;
  if (region.shrink > 0) {
    const MaterialPair stored = stored_pair(pair_of(region.material), region, m, options_.gloss);
    return copy_texels(etak::view(stored.of(task.texture)), {0, 0, region.width(), region.height()}, page,
                       at.x, at.y, at.rotated);
  }
  copy_texels(etak::view(picture), box, page, at.x, at.y, at.rotated);
  if (at.gutter == 0) return;
  // What the sampler would have read around the box: the picture's own texels, and beyond its edges as it
  // wraps.
  const auto around = [&](int column, int row) {
    const int x = at.rotated ? at.x + box.height - 1 - row : at.x + column,
              y = at.rotated ? at.y + column : at.y + row;
    std::memcpy(page.at(x, y),
                picture
                    .at(wrapped_texel(box.x + column, m.width, m.wrap[0]),
                        wrapped_texel(box.y + row, m.height, m.wrap[1]))
                    .data(),
                4);
  };
  for (int row = -at.gutter; row < box.height + at.gutter; ++row)
    for (int column = -at.gutter; column < box.width + at.gutter; ++column)
      if (row < 0 || row >= box.height || column < 0 || column >= box.width) around(column, row);
}

const MaterialPair& Composer::pair_of(std::size_t material) {
  Cached* cached = nullptr;
  {
    const std::lock_guard lock(pairs_lock_);
    cached = &pairs_[material];
  }
  std::call_once(cached->once, [&] {
    std::vector<std::string> ignored;  // told when the material was first looked at
    cached->pair = load_pair(materials_[material], ignored);
  });
  return cached->pair;
}

void Composer::begin_page(int page) {
  halves_.assign(materials_.size(), {});
  open_.clear();
  open_.resize(regions_.size());
  clean_ = clean_levels(page);
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
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < regions_.size(); ++i)
    for (const Texture texture : both_textures)
      if (plan_.places[i].page == page && plan_.pages[static_cast<std::size_t>(page)].has[index_of(texture)])
        tasks.push_back({i, texture});
  // The largest first, so that none is left for the end.
  std::stable_sort(tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) {
    const PixelBox &first = regions_[a.region].box, &second = regions_[b.region].box;
    return std::int64_t{first.width} * first.height > std::int64_t{second.width} * second.height;
  });
  parallel_chunks(tasks.size(), options_.threads, 1, [&](std::size_t begin, std::size_t, unsigned worker) {
    region_texels(tasks[begin].region, tasks[begin].texture, pixels, worker);
    if (region_done) region_done();
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
  const PlannedPage& size = plan_.pages[static_cast<std::size_t>(page)];
  if (pixels.levels() > clean_ && size.width > 0) page_mips(pixels, clean_);
}

void Composer::mips(int page, PagePixels& pixels) {
  const PlannedPage& size = plan_.pages[static_cast<std::size_t>(page)];
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < regions_.size(); ++i)
    if (plan_.places[i].page == page) here.push_back(i);
  clean_ = clean_levels(page);
  parallel_chunks(here.size(), options_.threads, 1,
                  [&](std::size_t begin, std::size_t, unsigned) { region_mips(here[begin], pixels); });
  pairs_.clear();
  if (pixels.levels() > clean_ && size.width > 0) page_mips(pixels, clean_);
}

namespace {

// A region on a level of its page: its texels, and the cell around them.
struct LevelBoxes {
  PixelBox part, cell;
};
LevelBoxes boxes_at(const PlannedPlace& at, int level, int width, int height, const PixelsView8& page) {
  LevelBoxes out;
  out.cell = cut(at_level(at.cell, level), page.width, page.height);
  out.part = cut({out.cell.x + (at.gutter >> level), out.cell.y + (at.gutter >> level), width, height},
                 page.width, page.height);
  return out;
}

}  // namespace

// Where nothing has to be turned, cut off or put in the place of a texture that is not there, levels are made
// where they belong.
bool Composer::mips_in_place(std::size_t region, const PlannedPlace& at, std::array<Wrap, 2> wrap, int levels,
                             PagePixels& pixels) const {
  const PackInput& m = materials_[regions_[region].material];
  const PixelBox& source = regions_[region].box;
  if (at.rotated || regions_[region].shrink > 0 || m.normal.is_image() ||
      options_.gloss != GlossForm::schueler)
    return false;
  if (levels > full_mip_levels(source.width, source.height)) return false;
  std::array<std::vector<PixelsView8>, 2> to;
  for (const Texture texture : both_textures)
    for (int l = 0; l < levels; ++l) {
      const PixelsView8 page = pixels.view(texture, l);
      if (page.data == nullptr) return false;
      const int width = std::max(1, source.width >> l), height = std::max(1, source.height >> l);
      const PixelBox part =
          l == 0 ? PixelBox{at.x, at.y, width, height} : boxes_at(at, l, width, height, page).part;
      if (part.width != width || part.height != height) return false;
      to[index_of(texture)].push_back(page.part(part));
    }
  MipOptions options;
  options.levels = levels;
  if (m.alpha_mode == AlphaMode::mask) options.alpha_cutoff = m.alpha_cutoff;
  if (options_.bleed) bleed_under_alpha(to[0][0], to[1][0]);
  mip_levels(to[0][0], to[1][0], options, 1, to[0], to[1]);
  for (const Texture texture : both_textures)
    for (int l = 1; l < levels; ++l) {
      const PixelsView8 page = pixels.view(texture, l);
      const PixelsView8& own = to[index_of(texture)][static_cast<std::size_t>(l)];
      const LevelBoxes boxes = boxes_at(at, l, own.width, own.height, page);
      fill_gutter(page, boxes.part, boxes.cell, wrap, false);
    }
  return true;
}

void Composer::region_mips(std::size_t region, PagePixels& pixels) {
  const PlannedPlace at = place_in(pixels, region);
  const PackInput& m = materials_[regions_[region].material];
  const PlannedPage& page = plan_.pages[static_cast<std::size_t>(at.page)];
  const int shrink = regions_[region].shrink;
  const PixelBox& part_shown = regions_[region].box;
  const PixelBox source{0, 0, regions_[region].width(), regions_[region].height()};
  const PixelBox box{at.x, at.y, at.rotated ? source.height : source.width,
                     at.rotated ? source.width : source.height};
  const bool has_both_textures = page.has[0] && page.has[1];
  const std::array<Wrap, 2> wrap = is_whole(part_shown, m) ? m.wrap : std::array{Wrap::clamp, Wrap::clamp};
  const int levels = std::min(pixels.levels(), clean_);
  if ((levels > 1 || options_.bleed) && !mips_in_place(region, at, wrap, levels, pixels)) {
    // The mips need both halves of a texel: a missing one counts as opaque, or as black of gloss 0.
    const auto half = [&](Texture texture) {
      if (page.has[index_of(texture)]) return copy_of(pixels.view(texture), box, at.rotated);
      return Image8(source.width, source.height, 4, texture == Texture::diffuse_alpha ? 255 : 0);
    };
    Image8 a = half(Texture::diffuse_alpha), b = half(Texture::specular_gloss);
    if (options_.bleed &&
        bleed_under_alpha(etak::view(a), has_both_textures ? etak::view(b) : PixelsView8{}) > 0)
      for (const Texture texture : both_textures)
        if (page.has[index_of(texture)])
          copy_texels(etak::view(texture == Texture::diffuse_alpha ? a : b),
                      {0, 0, source.width, source.height}, pixels.view(texture), box.x, box.y, at.rotated);
    MipOptions options;
    options.levels = levels;
    if (m.alpha_mode == AlphaMode::mask) options.alpha_cutoff = m.alpha_cutoff;
    std::optional<Image8> normals;
    if (m.has_normals() && levels > 1) {
      normals = normals_of(m, part_shown);
      options.normals = &*normals;
    }
    MipPair chain;
    if (shrink > 0 && options.normals != nullptr) {
      // The spread of all normals counts, also of those between the texels that are stored.
      options.levels = shrink + levels;
      const MaterialPair& whole = pair_of(regions_[region].material);
      chain = region_chain(part_of(whole.diffuse_alpha, part_shown),
                           part_of(whole.specular_gloss, part_shown), options, options_.gloss);
      for (auto* images : {&chain.diffuse_alpha, &chain.specular_gloss})
        images->erase(images->begin(),
                      images->begin() + std::min(shrink, static_cast<int>(images->size()) - 1));
    } else {
      chain = region_chain(a, b, options, options_.gloss);
    }
    for (const Texture texture : both_textures) {
      if (!page.has[index_of(texture)]) continue;
      const auto& images = texture == Texture::diffuse_alpha ? chain.diffuse_alpha : chain.specular_gloss;
      for (int l = 1; l < levels; ++l) {
        const PixelsView8 out = pixels.view(texture, l);
        const Image8& image = images[std::min(static_cast<std::size_t>(l), images.size() - 1)];
        const auto [part, cell] = boxes_at(at, l, at.rotated ? image.height : image.width,
                                           at.rotated ? image.width : image.height, out);
        copy_texels(etak::view(image),
                    {0, 0, at.rotated ? part.height : part.width, at.rotated ? part.width : part.height}, out,
                    part.x, part.y, at.rotated);
        fill_gutter(out, part, cell, wrap, at.rotated);
      }
    }
  }
  // Level 0 may have its gutter from the picture already; then only the rounding of the cell is left, unless
  // the picture's own edge was bled since.
  PixelBox filled = box;
  if ((m.convert || at.rotated) && shrink == 0 && !(options_.bleed && is_whole(part_shown, m)))
    filled = {box.x - at.gutter, box.y - at.gutter, box.width + 2 * at.gutter, box.height + 2 * at.gutter};
  for (const Texture texture : both_textures)
    if (page.has[index_of(texture)])
      fill_gutter(pixels.view(texture), filled, at.cell,
                  filled == box ? wrap : std::array{Wrap::clamp, Wrap::clamp}, at.rotated);
}

// Mips beyond those of the regions mix neighbours; they are made from the page as it is.
void Composer::page_mips(PagePixels& pixels, int first) const {
  const auto whole = [&](Texture texture) {
    const PixelsView8 from = pixels.view(texture, first - 1);
    if (from.data == nullptr) return Image8();
    return copy_of(from, {0, 0, from.width, from.height}, false);
  };
  Image8 a = whole(Texture::diffuse_alpha), b = whole(Texture::specular_gloss);
  if (a.values.empty()) a = Image8(b.width, b.height, 4, 255);
  if (b.values.empty()) b = Image8(a.width, a.height, 4, 0);
  MipOptions options;
  options.levels = pixels.levels() - first + 1;
  const MipPair chain = region_chain(a, b, options, options_.gloss, options_.threads);
  for (const Texture texture : both_textures) {
    const auto& images = texture == Texture::diffuse_alpha ? chain.diffuse_alpha : chain.specular_gloss;
    for (int l = first; l < pixels.levels(); ++l) {
      const PixelsView8 out = pixels.view(texture, l);
      if (out.data == nullptr) continue;
      const Image8& image = images[static_cast<std::size_t>(l - first + 1)];
      std::memcpy(out.data, image.values.data(), image.values.size());
    }
  }
}

}  // namespace etak
