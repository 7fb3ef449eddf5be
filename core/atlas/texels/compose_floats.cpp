// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/compose_floats.h"

#include <algorithm>

#include "core/atlas/outputs.h"
#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/pictures.h"
#include "core/atlas/texels/place_outline.h"
#include "core/atlas/texels/place_texels.h"
#include "core/atlas/texels/resolution.h"
#include "core/image/dilate.h"

namespace etak {
namespace {

FloatPage empty_page(const PlannedPage& size, int levels) {
  FloatPage out;
  for (const Texture texture : both_textures)
    for (int l = 0; l < levels && size.has[index_of(texture)]; ++l)
      out.levels[index_of(texture)].emplace_back(std::max(1, size.width >> l), std::max(1, size.height >> l),
                                                 4);
  return out;
}

// A region, its material and the pictures of that.
struct FloatRegion {
  const Region& region;
  const PackInput& material;
  const FloatPair& pair;
};

// Levels [0, levels) of a region with their gutters.
void place_region(const FloatRegion& of, const PlannedPlace& at, int levels, const ComposeOptions& options,
                  FloatPage& page) {
  const Region& region = of.region;
  const PackInput& m = of.material;
  const FloatPair& pair = of.pair;
  const auto level_of = [&](Texture texture, int level) { return page.view(texture, level); };
  Image a = part_of(pair.diffuse_alpha, region.box), b = part_of(pair.specular_gloss, region.box);
  const bool bled = options.bleed && bleed_under_alpha(a, b) > 0;
  if (region.shrink == 0) {
    FloatPair own;  // with the bled box in place
    if (bled) {
      own = pair;
      paste(a, region.box.x, region.box.y, own.diffuse_alpha);
      paste(b, region.box.x, region.box.y, own.specular_gloss);
    }
    for (const Texture texture : both_textures) {
      const PixelsViewOf<float> out = page.view(texture, 0);
      if (out.data == nullptr) continue;
      place_picture((bled ? own : pair).of(texture), region.box, m.wrap, at, out);
      fill_gutter(out, grown(box_on_page(region, at), at.gutter), at.cell, {Wrap::clamp, Wrap::clamp},
                  at.rotated);
    }
  }
  const PairPart<float> part{m, region.box, a, b};
  MipPairFloat chain = levels_from(region.shrink, levels, part, options.gloss, options.threads);
  // The level that is stored is looked at with its normals; those after it stand for their spread.
  if (region.shrink > 0 && m.has_normals() && levels > 1)
    chain.specular_gloss[0] =
        levels_from(region.shrink, 1, part, options.gloss, options.threads).specular_gloss[0];
  place_levels(chain, at, m.wrap_of(region.box), region.shrink > 0 ? 0 : 1, levels, level_of);
}

}  // namespace

PixelsViewOf<float> FloatPage::view(Texture texture, int level) {
  auto& of = levels[index_of(texture)];
  return of.empty() ? PixelsViewOf<float>{} : etak::view(of[static_cast<std::size_t>(level)]);
}

FloatPage compose_floats(int page, int levels, const std::vector<PackInput>& materials,
                         const std::vector<Region>& regions, const PackingPlan& plan,
                         const ComposeOptions& options) {
  FloatPage out = empty_page(plan.pages[static_cast<std::size_t>(page)], levels);
  const int clean = plan.clean_levels(page);
  const int placed = std::min(levels, clean);
  FloatPair pair;
  Image8 normals;
  std::size_t loaded = materials.size();  // whose they are
  for (std::size_t r = 0, end = 0; r < regions.size(); r = end) {
    end = r + 1;
    while (regions[r].outline != 0 && end < regions.size() && regions[end].outline == regions[r].outline)
      ++end;
    if (plan.places[r].page != page) continue;
    const PackInput& m = materials[regions[r].material];
    const bool with_normals = m.has_normals() && placed > 1;
    if (regions[r].material != loaded) {
      loaded = regions[r].material;
      pair = load_floats(m);
      if (with_normals) normals = normals_of(m, {0, 0, m.width, m.height});
    }
    if (!has_texels_around(regions[r], m))
      place_region({regions[r], m, pair}, plan.places[r], placed, options, out);
    else
      place_outline({{&regions[r], end - r}, {&plan.places[r], end - r}},
                    OutlinePictures<FloatPair>{m, pair, with_normals ? &normals : nullptr}, placed, options,
                    [&](Texture texture, int level) { return out.view(texture, level); });
  }
  if (levels > clean)
    make_shared_levels<float>(clean, levels, options.gloss, options.threads,
                              [&](Texture texture, int level) { return out.view(texture, level); });
  return out;
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
