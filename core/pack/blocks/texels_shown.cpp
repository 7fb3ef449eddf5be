// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/texels_shown.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace etak {
namespace {

// Which texels of an owner's picture its materials read, 1 each; none: not known.
std::optional<std::vector<std::uint8_t>> read_of(const PackSource& source, const PackDecision& decision,
                                                 std::size_t owner) {
  const PackInput& picture = source.inputs.materials[owner];
  std::vector<std::uint8_t> out(static_cast<std::size_t>(picture.width) *
                                static_cast<std::size_t>(picture.height));
  for (std::size_t m = 0; m < source.scene->entries.size(); ++m) {
    const MaterialFate& fate = decision.left_out.fates[m];
    if (!fate.texels || fate.owner != owner) continue;
    const SceneRead::Entry& entry = source.scene->entries[m];
    const GltfTexture* const lead = leading_texture(source.scene->material(entry));
    if (lead == nullptr || !entry.use || entry.use->touched == 0 || entry.use->mask.size() != out.size())
      return std::nullopt;
    std::ranges::transform(out, texels_read(*entry.use, lead->sampler), out.begin(), std::bit_or());
  }
  return out;
}

// Whether something reads one of the texels of a picture that a stored texel of a region is made of.
bool is_read(const std::vector<std::uint8_t>& read, const PackInput& picture, const Region& region,
             int column, int row) {
  const int side = 1 << region.shrink, left = region.box.x + column * side, top = region.box.y + row * side;
  for (int y = top; y < std::min(picture.height, top + side); ++y)
    for (int x = left; x < std::min(picture.width, left + side); ++x)
      if (read[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(x)] != 0)
        return true;
  return false;
}

}  // namespace

TexelsShown texels_shown(const PackSource& source, const PackDecision& decision, int page) {
  if (source.scene == nullptr || source.one_page != nullptr) return {};
  const PlannedPage& of = decision.plan.pages[static_cast<std::size_t>(page)];
  const auto width = static_cast<std::size_t>(of.width);
  TexelsShown out(width * static_cast<std::size_t>(of.height));
  std::optional<std::size_t> owner;  // regions are in the order of their materials
  std::optional<std::vector<std::uint8_t>> read;
  for (std::size_t r = 0; r < decision.regions.size(); ++r) {
    const Region& region = decision.regions[r];
    const PlannedPlace& at = decision.plan.places[r];
    if (at.page != page) continue;
    if (owner != region.material) {
      owner = region.material;
      read = read_of(source, decision, region.material);
    }
    const PackInput& picture = source.inputs.materials[region.material];
    const PixelBox box = box_on_page(region, at);
    for (int y = 0; y < box.height; ++y)
      for (int x = 0; x < box.width; ++x) {
        const int column = at.rotated ? y : x, row = at.rotated ? box.width - 1 - x : y;
        if (!read || is_read(*read, picture, region, column, row))
          out[static_cast<std::size_t>(box.y + y) * width + static_cast<std::size_t>(box.x + x)] = 255;
      }
  }
  return out;
}

TexelsShown next_level(const TexelsShown& of, int width, int height) {
  if (of.empty()) return {};
  const int across = std::max(1, width / 2), down = std::max(1, height / 2);
  TexelsShown out;
  out.reserve(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x) {
      unsigned sum = 3;  // rounds up
      for (const int row : {2 * y, 2 * y + 1})
        for (const int column : {2 * x, 2 * x + 1})
          sum += of[static_cast<std::size_t>(std::min(row, height - 1)) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(std::min(column, width - 1))];
      out.push_back(static_cast<std::uint8_t>(sum / 4));
    }
  return out;
}

}  // namespace etak
