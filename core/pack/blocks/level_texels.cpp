// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/level_texels.h"

#include <algorithm>
#include <cmath>

#include "core/atlas/texels/page_pixels.h"
#include "core/pack/blocks/page_format.h"

namespace etak {

LevelTexels::LevelTexels(const BlockJob& job, const BlockMeasure& with, int level, const TexelsShown& shown)
    : uses(block_uses(job.decision, shown, job.page, job.texture, level, job.how.format->block_width)),
      measure(with),
      job_(job),
      view_(job.pixels.view(job.texture, level)) {}

AnyBlock LevelTexels::bare_block(std::size_t number) const {
  const int side = job_.how.format->block_width;
  const auto across = static_cast<std::size_t>(uses.across);
  const int left = side * static_cast<int>(number % across), top = side * static_cast<int>(number / across);
  AnyBlock out;
  for (int i = 0; i < side * side; ++i) {
    const int x = left + i % side, y = top + i / side;
    const int inside_x = std::min(x, view_.width - 1), inside_y = std::min(y, view_.height - 1);
    std::copy_n(view_.at(inside_x, inside_y), 4, out.texels[static_cast<std::size_t>(i)].data());
    if (x != inside_x || y != inside_y) continue;
    const std::uint8_t share = uses.used[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                                         static_cast<std::size_t>(x)];
    out.counting |= std::uint64_t{share != 0} << i;
    out.shares[static_cast<std::size_t>(i)] = share;
  }
  return out;
}

AnyBlock LevelTexels::block(std::size_t number) const {
  AnyBlock out = bare_block(number);
  measure.weigh(out);
  if (!job_.fourth_apart) return out;
  for (auto& texel : out.texels) texel[3] = 255;
  out.weights[3] = 0;
  return out;
}

std::array<TexelForm, 16> LevelTexels::forms(std::size_t number) const {
  const AnyBlock from = bare_block(number);
  const bool see_through = job_.texture == Texture::diffuse_alpha &&
                           job_.materials[*uses.owner[number]].alpha_mode != AlphaMode::opaque;
  std::array<TexelForm, 16> out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = measure.form_of(from.texels[i]);
    if (see_through && from.texels[i][3] == 0) out[i] = {{0, 0, 0, out[i].weights[3]}};
    if (job_.fourth_apart) out[i].weights[3] = 0;
  }
  return out;
}

bool LevelTexels::is_mask(std::size_t material) const {
  return job_.texture == Texture::diffuse_alpha && job_.materials[material].alpha_mode == AlphaMode::mask;
}

double LevelTexels::compare(std::size_t number, const std::array<std::uint8_t, 4>* texels,
                            BlockDifferences& to) const {
  const AnyBlock from = bare_block(number);
  const std::size_t owner = *uses.owner[number];
  const PackInput& material = job_.materials[owner];
  const bool diffuse = job_.texture == Texture::diffuse_alpha;
  const bool opaque = diffuse && material.alpha_mode == AlphaMode::opaque;
  const int cutoff = is_mask(owner) ? static_cast<int>(std::ceil(255 * material.alpha_cutoff)) : -1;
  // BC4 and BC5 go without an F0 that is one number of the material.
  const bool f0_apart = is_fitting(*job_.how.format) && has_constant_f0(job_.decision.left_out.fates[owner]);
  double out = 0;
  for (std::size_t i = 0; i < most_block_texels; ++i) {
    if ((from.counting >> i & 1) == 0) continue;
    // Nothing shows the colour of a texel that lets all light through.
    const bool unseen = diffuse && !opaque && from.texels[i][3] == 0;
    to.colour[to.count] = unseen || f0_apart ? 0 : measure.colour(from.texels[i], texels[i]);
    to.fourth[to.count] =
        opaque || job_.fourth_apart ? 0 : measure.fourth(from.texels[i][3], texels[i][3], cutoff);
    to.share[to.count] = from.shares[i];
    const double budgets = std::max(to.colour[to.count] / measure.colour_budget(),
                                    to.fourth[to.count] / measure.fourth_budget());
    if (budgets > 1) out += budgets * from.shares[i];
    ++to.count;
  }
  return out;
}

}  // namespace etak
