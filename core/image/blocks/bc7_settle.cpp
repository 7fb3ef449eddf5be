// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/bc7_settle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/image/blocks/bc7_block.h"
#include "core/image/blocks/bptc.h"

namespace etak {
namespace {

using bc7::Block, bc7::modes;

constexpr std::size_t texel_count = 16, channels = 4, group_size = 4;
using Group = float __attribute__((vector_size(4 * group_size)));  // of texels
using Colour = std::array<float, channels>;

// The texels of one part of a block that count, by channel.
struct Texels {
  std::size_t count = 0, groups = 0;
  std::array<std::size_t, texel_count> at{};  // in the block
  std::array<Group, texel_count / group_size> share{}, value[channels]{}, weight[channels]{}, pairs[3]{};

  Texels(const BlockSource& source, const std::array<TexelForm, texel_count>& forms, const Block& block,
         std::size_t part) {
    for (std::size_t i = 0; i < texel_count; ++i) {
      if (source.shares[i] <= 0 || bc7::part_of(block, i) != part) continue;
      const std::size_t g = count / group_size, l = count % group_size;
      share[g][l] = source.shares[i];
      for (std::size_t c = 0; c < channels; ++c) {
        value[c][g][l] = source.texels[i][c];
        weight[c][g][l] = forms[i].weights[c];
      }
      for (std::size_t p = 0; p < 3; ++p) pairs[p][g][l] = 2 * forms[i].pairs[p];
      at[count++] = i;
    }
    groups = (count + group_size - 1) / group_size;
  }

  // The squared errors of a group whose texels were this colour.
  Group error(std::size_t g, const Colour& of) const {
    const Group red = value[0][g] - of[0], green = value[1][g] - of[1], blue = value[2][g] - of[2],
                off = value[3][g] - of[3];
    const Group colour = red * (weight[0][g] * red + pairs[0][g] * green + pairs[1][g] * blue) +
                         green * (weight[1][g] * green + pairs[2][g] * blue) + weight[2][g] * blue * blue,
                fourth = weight[3][g] * off * off;
    return colour < fourth ? fourth : colour;
  }
};

// What a texel of a part may be.
struct Palette {
  std::array<Colour, 32> entries;
  std::size_t count = 0;
  unsigned bits = 0, second_bits = 0;  // entry number: index + (second << bits)

  Palette(const Block& block, std::size_t part)
      : bits(bc7::index_bits(block)), second_bits(bc7::second_index_bits(block)) {
    count = std::size_t{1} << (bits + second_bits);
    for (std::size_t c = 0; c < channels; ++c) {
      const unsigned first = bc7::code_of(block, 2 * part, c), last = bc7::code_of(block, 2 * part + 1, c);
      const std::size_t to = bc7::turned(block, c);
      const bool alone = c == 3 && second_bits != 0;
      for (unsigned k = 0; k < count; ++k) {
        const unsigned share =
            alone ? bptc::weight(second_bits, k >> bits) : bptc::weight(bits, k & ((1u << bits) - 1));
        entries[k][to] = static_cast<float>(bc7::between(first, last, share));
      }
    }
  }
};

// What the texels of a part cost with its ends, each with its nearest entry.
float cost_of(const Texels& texels, const Block& block, std::size_t part) {
  const Palette palette(block, part);
  constexpr float within = 0.05f;  // errors within the bound only show the way
  float out = 0;
  for (std::size_t g = 0; g < texels.groups; ++g) {
    Group least = texels.error(g, palette.entries[0]);
    for (std::size_t k = 1; k < palette.count; ++k) {
      const Group error = texels.error(g, palette.entries[k]);
      least = error < least ? error : least;
    }
    for (std::size_t l = 0; l < group_size; ++l)
      out += texels.share[g][l] * (least[l] > 1 ? std::sqrt(least[l]) : within * least[l]);
  }
  return out;
}

void choose_indices(const Texels& texels, std::size_t part, Block& block) {
  const Palette palette(block, part);
  for (std::size_t t = 0; t < texels.count; ++t) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < palette.count; ++k) {
      const std::size_t g = t / group_size, l = t % group_size;
      if (texels.error(g, palette.entries[k])[l] < texels.error(g, palette.entries[best])[l]) best = k;
    }
    block.index[texels.at[t]] = static_cast<unsigned>(best) & ((1u << palette.bits) - 1);
    block.second[texels.at[t]] = static_cast<unsigned>(best) >> palette.bits;
  }
}

// A change of the two ends of a part.
//   lasts   both last bits, the first one below; -1: they stay
struct Move {
  std::array<std::array<int, channels>, 2> by{};
  int lasts = -1;
};

std::vector<Move> make_moves() {
  std::vector<Move> out;
  for (std::size_t c = 0; c < channels; ++c)
    for (const int step : {-1, 1, -2, 2})
      for (const auto& [first, second] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
        Move& move = out.emplace_back();
        move.by[0][c] = first * step;
        move.by[1][c] = second * step;
      }
  for (int lasts = 0; lasts < 4; ++lasts) {
    out.push_back({{}, lasts});
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t c = 0; c < channels; ++c)
        for (const int step : {-1, 1}) {
          Move& move = out.emplace_back(Move{{}, lasts});
          move.by[e][c] = step;
        }
  }
  for (std::size_t e = 0; e < 2; ++e)
    for (const int step : {-1, 1}) out.emplace_back().by[e] = {step, step, step, 0};
  return out;
}

// Whether the block has the ends to which a move would take it; takes it there.
bool take(const Move& move, std::size_t part, Block& block) {
  const bc7::Mode& mode = modes[block.mode];
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t c = 0; c < channels; ++c) {
      unsigned& end = block.end[2 * part + e][c];
      const int to = static_cast<int>(end) + move.by[e][c];
      if (to < 0 || (to != static_cast<int>(end) && to >= 1 << bc7::end_bits(block, c))) return false;
      end = static_cast<unsigned>(to);
    }
  if (move.lasts < 0) return true;
  const auto first = static_cast<unsigned>(move.lasts & 1), last = static_cast<unsigned>(move.lasts >> 1);
  if (!mode.own_p && (!mode.shared_p || first != last)) return false;
  block.last[2 * part] = first;
  block.last[2 * part + 1] = last;
  return true;
}

// Takes what improves a part until nothing does; returns what it costs then.
float climb(const Texels& texels, std::size_t part, Block& block) {
  static const std::vector<Move> moves = make_moves();
  constexpr int most_turns = 16;
  float least = cost_of(texels, block, part);
  bool better = true;
  for (int turn = 0; better && turn < most_turns; ++turn) {
    better = false;
    for (const Move& move : moves) {
      Block next = block;
      if (!take(move, part, next)) continue;
      const float cost = cost_of(texels, next, part);
      if (cost >= least) continue;
      least = cost;
      block = next;
      better = true;
    }
  }
  return least;
}

// Sets the ends of a part to that diagonal of the box around its texels along which they lie.
void fit(const Texels& texels, std::size_t part, Block& block) {
  const auto value = [&](std::size_t t, std::size_t c) -> float {
    return texels.value[bc7::turned(block, c)][t / group_size][t % group_size];
  };
  Colour mean{}, low{255, 255, 255, 255}, high{}, along{};
  for (std::size_t t = 0; t < texels.count; ++t)
    for (std::size_t c = 0; c < channels; ++c) {
      mean[c] += value(t, c) / static_cast<float>(texels.count);
      low[c] = std::min(low[c], value(t, c));
      high[c] = std::max(high[c], value(t, c));
    }
  std::size_t widest = 0;
  for (std::size_t c = 1; c < channels; ++c)
    if (bc7::end_bits(block, c) > 0 && high[c] - low[c] > high[widest] - low[widest]) widest = c;
  for (std::size_t t = 0; t < texels.count; ++t)
    for (std::size_t c = 0; c < channels; ++c)
      along[c] += (value(t, c) - mean[c]) * (value(t, widest) - mean[widest]);
  const unsigned last = modes[block.mode].own_p || modes[block.mode].shared_p ? 1 : 0;
  for (std::size_t e = 0; e < 2; ++e) {
    block.last[2 * part + e] = last;
    for (std::size_t c = 0; c < channels; ++c) {
      const float code = (e == 0) == (along[c] >= 0) ? low[c] : high[c];
      const unsigned bits = bc7::end_bits(block, c) + last;
      const auto whole = static_cast<unsigned>(code / 255 * static_cast<float>((1u << bits) - 1) + 0.5f);
      if (bits > last) block.end[2 * part + e][c] = whole >> last;
    }
  }
}

// Calls use(texels of a part, part) for each part of a block.
template <class Use>
void each_part(const BlockSource& source, const std::array<TexelForm, texel_count>& forms, const Block& block,
               const Use& use) {
  for (std::size_t part = 0; part < modes[block.mode].subsets; ++part)
    use(Texels(source, forms, block, part), part);
}

// Blocks to start from, those of the least cost first.
std::vector<Block> starts_of(const BlockSource& source, const std::array<TexelForm, texel_count>& forms,
                             std::size_t count) {
  bool opaque = true;
  for (std::size_t i = 0; i < texel_count; ++i)
    opaque = opaque && (source.shares[i] <= 0 || source.texels[i][3] == 255 || forms[i].weights[3] <= 0);
  std::vector<Block> all{{6}};
  for (std::size_t partition = 0; partition < bc7::partitions_of_2.size(); ++partition)
    for (const std::size_t mode : std::array<std::size_t, 3>{1, 3, 7})
      if (opaque == (mode != 7)) all.push_back({mode, partition});
  for (unsigned rotation = 0; rotation < channels; ++rotation) {
    all.push_back({5, 0, rotation});
    for (unsigned selection = 0; selection < 2; ++selection) all.push_back({4, 0, rotation, selection});
  }
  std::vector<std::pair<float, std::size_t>> by_cost;
  for (std::size_t b = 0; b < all.size(); ++b) {
    float cost = 0;
    each_part(source, forms, all[b], [&](const Texels& texels, std::size_t part) {
      fit(texels, part, all[b]);
      cost += cost_of(texels, all[b], part);
    });
    by_cost.emplace_back(cost, b);
  }
  count = std::min(count, all.size());
  std::ranges::partial_sort(by_cost, by_cost.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<Block> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(all[by_cost[k].second]);
  return out;
}

}  // namespace

void settle_bc7(const BlockSource& source, const std::array<TexelForm, 16>& forms, std::size_t starts,
                std::uint8_t* block) {
  std::vector<Block> from{bc7::read_block(block)};
  if (starts > 0)
    for (const Block& each : starts_of(source, forms, starts)) from.push_back(each);
  Block best = from[0];
  float least = 1e30f;
  for (Block& each : from) {
    float cost = 0;
    each_part(source, forms, each,
              [&](const Texels& texels, std::size_t part) { cost += climb(texels, part, each); });
    if (cost < least) least = cost, best = each;
  }
  each_part(source, forms, best,
            [&](const Texels& texels, std::size_t part) { choose_indices(texels, part, best); });
  bc7::store_block(best, block);
}

}  // namespace etak
