// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/compose_floats.h"

#include <algorithm>
#include <optional>

#include "core/atlas/outputs.h"
#include "core/atlas/resolution.h"
#include "core/atlas/sources/floats.h"
#include "core/image/dilate.h"
#include "core/image/wrap.h"

namespace etak {
namespace {

// Texels of a cell from a picture whose texel (x, y) belongs at column left + x, row top + y of the page
// (rotated: column c becomes row c, rows run from right to left).
//   high   rows of the picture
//   from   gives the texel of a column and a row, also beyond the picture's edges
template <class From>
void fill(Image& page, const PixelBox& cell, int left, int top, int high, bool rotated, From from) {
  for (int y = cell.y; y < cell.y + cell.height; ++y)
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      const int column = rotated ? y - top : x - left, row = rotated ? high - 1 - (x - left) : y - top;
      std::copy_n(from(column, row), 4, page.at(x, y).data());
    }
}

class FloatComposer {
 public:
  FloatComposer(const std::vector<PackInput>& materials, const std::vector<Region>& regions,
                const PackingPlan& plan, const ComposeOptions& options, int page, int levels)
      : materials_(materials), regions_(regions), plan_(plan), options_(options), page_(page) {
    const PlannedPage& size = plan.pages[static_cast<std::size_t>(page)];
    for (std::size_t t = 0; t < 2; ++t)
      for (int l = 0; l < levels && size.has[t]; ++l)
        out_.levels[t].emplace_back(std::max(1, size.width >> l), std::max(1, size.height >> l), 4);
    for (const PlannedPlace& place : plan.places)
      if (place.page == page) clean_ = std::max(clean_, place.clean_levels);
    levels_ = levels;
  }

  FloatPage run() {
    std::size_t loaded = materials_.size();
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (plan_.places[r].page != page_) continue;
      if (regions_[r].material != loaded) pair_ = load_floats(materials_[loaded = regions_[r].material]);
      place(r);
    }
    if (levels_ > clean_) page_mips();
    return std::move(out_);
  }

 private:
  MipPairFloat chain_of(std::size_t r, int levels) const {
    const Region& region = regions_[r];
    const PackInput& m = materials_[region.material];
    Image a = part_of(pair_.diffuse_alpha, region.box), b = part_of(pair_.specular_gloss, region.box);
    if (options_.bleed) bleed_under_alpha(a, b);
    MipOptions options;
    options.levels = region.shrink + levels;
    if (m.alpha_mode == AlphaMode::mask) options.alpha_cutoff = m.alpha_cutoff;
    MipPairFloat chain = region_chain(a, b, options, options_.gloss, options_.threads);
    if (m.has_normals() && levels > 1) {
      // The level that is stored is looked at with its normals; those after it stand for their spread.
      const Image8 normals = normals_of(m, region.box);
      options.normals = &normals;
      MipPairFloat spread = region_chain(a, b, options, options_.gloss, options_.threads);
      for (auto l = static_cast<std::size_t>(region.shrink) + 1; l < chain.specular_gloss.size(); ++l)
        chain.specular_gloss[l] = std::move(spread.specular_gloss[l]);
    }
    for (auto* images : {&chain.diffuse_alpha, &chain.specular_gloss})
      images->erase(images->begin(),
                    images->begin() + std::min(region.shrink, static_cast<int>(images->size()) - 1));
    return chain;
  }

  void place(std::size_t r) {
    const Region& region = regions_[r];
    const PlannedPlace& at = plan_.places[r];
    const PackInput& m = materials_[region.material];
    const PixelBox& box = region.box;
    const bool whole = box == PixelBox{0, 0, m.width, m.height};
    const std::array<Wrap, 2> wrap = whole ? m.wrap : std::array{Wrap::clamp, Wrap::clamp};
    const int levels = std::min(levels_, clean_);
    const MipPairFloat chain = chain_of(r, levels);
    for (std::size_t t = 0; t < 2; ++t) {
      if (out_.levels[t].empty()) continue;
      const auto& images = t == 0 ? chain.diffuse_alpha : chain.specular_gloss;
      for (int l = 0; l < levels; ++l) {
        const Image& image = images[std::min(static_cast<std::size_t>(l), images.size() - 1)];
        Image& page = out_.levels[t][static_cast<std::size_t>(l)];
        const PixelBox cell = cut(at_level(at.cell, l), page.width, page.height);
        const int gutter = at.gutter >> l;
        // At level 0 the picture's own texels lie around the box, as far as the gutter goes.
        const Image& picture = t == 0 ? pair_.diffuse_alpha : pair_.specular_gloss;
        const auto around = [&](int column, int row) {
          column = std::clamp(column, -gutter, box.width - 1 + gutter);
          row = std::clamp(row, -gutter, box.height - 1 + gutter);
          const int x = wrapped_texel(box.x + column, m.width, m.wrap[0]),
                    y = wrapped_texel(box.y + row, m.height, m.wrap[1]);
          const bool inside = x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
          return inside ? image.at(x - box.x, y - box.y).data() : picture.at(x, y).data();
        };
        const auto alone = [&](int column, int row) {
          return image
              .at(wrapped_texel(column, image.width, wrap[0]), wrapped_texel(row, image.height, wrap[1]))
              .data();
        };
        const int high = image.height, left = cell.x + gutter, top = cell.y + gutter;
        if (l == 0 && region.shrink == 0)
          fill(page, cell, left, top, high, at.rotated, around);
        else
          fill(page, cell, left, top, high, at.rotated, alone);
      }
    }
  }

  void page_mips() {
    const auto last = static_cast<std::size_t>(clean_ - 1);
    Image a, b;
    if (!out_.levels[0].empty()) a = out_.levels[0][last];
    if (!out_.levels[1].empty()) b = out_.levels[1][last];
    if (a.values.empty()) a = Image(b.width, b.height, 4, 1);
    if (b.values.empty()) b = Image(a.width, a.height, 4, 0);
    MipOptions options;
    options.levels = levels_ - clean_ + 1;
    MipPairFloat chain = region_chain(a, b, options, options_.gloss, options_.threads);
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t l = last + 1; l < out_.levels[t].size(); ++l)
        out_.levels[t][l] = std::move((t == 0 ? chain.diffuse_alpha : chain.specular_gloss)[l - last]);
  }

  const std::vector<PackInput>& materials_;
  const std::vector<Region>& regions_;
  const PackingPlan& plan_;
  const ComposeOptions& options_;
  const int page_;
  int levels_ = 1, clean_ = 1;
  FloatPair pair_;
  FloatPage out_;
};

}  // namespace

FloatPage compose_floats(int page, int levels, const std::vector<PackInput>& materials,
                         const std::vector<Region>& regions, const PackingPlan& plan,
                         const ComposeOptions& options) {
  return FloatComposer(materials, regions, plan, options, page, levels).run();
}

void write_float_page(OutputFolder& folder, int page, const FloatPage& pixels, const std::string& format,
                      const PictureDoor& door) {
  for (const Texture texture : both_textures) {
    const auto& levels = pixels.levels[static_cast<std::size_t>(texture)];
    for (std::size_t l = 0; l < levels.size(); ++l)
      folder.write(page_file(page, texture, format, static_cast<int>(l)),
                   door.encode(levels[l], format, texture == Texture::diffuse_alpha ? "alpha" : "gloss"));
  }
}

}  // namespace etak
