// SPDX-License-Identifier: Apache-2.0
#include "core/image/dilate.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/color/gloss.h"
#include "core/image/linear_tables.h"

namespace etak {
namespace {

// Writes one texel `count` times, side by side.
template <class Value>
void repeat(const Value* texel, Value* out, int count, int channels) {
  for (int i = 0; i < count; ++i)
    std::memmove(out + static_cast<std::size_t>(i) * static_cast<std::size_t>(channels), texel,
                 sizeof(Value) * static_cast<std::size_t>(channels));
}

// Four lanes: linear R, G, B and a fourth value.
using Float4 = float __attribute__((vector_size(16)));

// The mean of the visible texels of a block, one vector for each texture. The fourth lane of `a` counts the
// visible parts: after divide() it is 1 where any is visible and 0 where none is. The fourth lane of `b` is
// 1/e.
struct Block {
  Float4 a{}, b{};

  void add(const Block& one) {
    a += one.a;
    b += one.b;
  }
  void divide() {
    if (a[3] <= 1) return;
    const float share = 1 / a[3];
    a *= share;
    b *= share;
  }
};

struct BlockLevel {
  int width, height;
  std::vector<Block> blocks;
  Block* row(int y) { return blocks.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

BlockLevel level_above(int width, int height) {
  BlockLevel out{(width + 1) / 2, (height + 1) / 2, {}};
  out.blocks.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  return out;
}

// The first level of blocks, made from texels.
//   texel   gives the Block of the texel at a column and row, all zero where its alpha is 0
template <class Texel>
BlockLevel pulled(int width, int height, const Texel& texel) {
  BlockLevel out = level_above(width, height);
  for (int y = 0; y < out.height; ++y) {
    Block* const blocks = out.row(y);
    for (int x = 0; x < out.width; ++x) {
      Block sum;
      for (int v = 2 * y; v < std::min(2 * y + 2, height); ++v)
        for (int u = 2 * x; u < std::min(2 * x + 2, width); ++u) sum.add(texel(u, v));
      sum.divide();
      blocks[x] = sum;
    }
  }
  return out;
}

BlockLevel pulled(BlockLevel& below) {
  BlockLevel out = level_above(below.width, below.height);
  for (int y = 0; y < below.height; ++y)
    for (int x = 0; x < below.width; ++x) out.row(y / 2)[x / 2].add(below.row(y)[x]);
  for (Block& block : out.blocks) block.divide();
  return out;
}

// Gives each block of `base` without visible texels the value of the smallest visible block above it.
void push(BlockLevel& base) {
  std::vector<BlockLevel> levels;
  levels.push_back(std::move(base));
  // Levels are needed up to the first one whose blocks are all visible.
  const auto has_hole = [](const BlockLevel& level) {
    return std::any_of(level.blocks.begin(), level.blocks.end(),
                       [](const Block& block) { return block.a[3] == 0; });
  };
  while (has_hole(levels.back())) levels.push_back(pulled(levels.back()));
  for (std::size_t l = levels.size() - 1; l-- > 0;)
    for (int y = 0; y < levels[l].height; ++y)
      for (int x = 0; x < levels[l].width; ++x)
        if (Block& block = levels[l].row(y)[x]; block.a[3] == 0) block = levels[l + 1].row(y / 2)[x / 2];
  base = std::move(levels[0]);
}

// Turns texels into the lanes of a Block, and lanes back into values of a texel.
template <class Value>
struct Lanes;

template <>
struct Lanes<std::uint8_t> {
  const LinearTables& tables = linear_tables();
  Float4 a(const std::uint8_t* c) const {
    return Float4{tables.srgb[c[0]], tables.srgb[c[1]], tables.srgb[c[2]], 1};
  }
  Float4 b(const std::uint8_t* c) const {
    return Float4{tables.srgb[c[0]], tables.srgb[c[1]], tables.srgb[c[2]], tables.inverse[c[3]]};
  }
  std::uint8_t color(float v) const { return tables.srgb_code(v); }
  std::uint8_t gloss(float v) const { return tables.gloss_code(v); }
};

template <>
struct Lanes<float> {
  Float4 a(const float* v) const { return Float4{v[0], v[1], v[2], 1}; }
  Float4 b(const float* v) const { return Float4{v[0], v[1], v[2], variance_of_gloss(v[3])}; }
  float color(float v) const { return v; }
  float gloss(float v) const { return gloss_of_variance(v); }
};

}  // namespace

template <class Value>
void replicate_edges(const PixelsViewOf<Value>& page, const PixelBox& box, const PixelBox& cell) {
  const int right = box.x + box.width, cell_right = cell.x + cell.width;
  for (int y = box.y; y < box.y + box.height; ++y) {
    if (cell.x < box.x) repeat(page.at(box.x, y), page.at(cell.x, y), box.x - cell.x, page.channels);
    if (right < cell_right)
      repeat(page.at(right - 1, y), page.at(right, y), cell_right - right, page.channels);
  }
  const std::size_t bytes =
      sizeof(Value) * static_cast<std::size_t>(cell.width) * static_cast<std::size_t>(page.channels);
  for (int y = cell.y; y < box.y; ++y) std::memcpy(page.at(cell.x, y), page.at(cell.x, box.y), bytes);
  const int last = box.y + box.height - 1;
  for (int y = last + 1; y < cell.y + cell.height; ++y)
    std::memcpy(page.at(cell.x, y), page.at(cell.x, last), bytes);
}

template void replicate_edges(const PixelsView8&, const PixelBox&, const PixelBox&);
template void replicate_edges(const PixelsViewOf<float>&, const PixelBox&, const PixelBox&);

template <class Value>
std::size_t bleed_under_alpha(const PixelsViewOf<Value>& a, const PixelsViewOf<Value>& b) {
  assert(a.channels == 4);
  assert(b.data == nullptr || (b.channels == 4 && b.width == a.width && b.height == a.height));
  std::size_t hidden = 0;
  for (int y = 0; y < a.height; ++y) {
    const Value* row = a.row(y);
    for (int x = 0; x < a.width; ++x) hidden += row[4 * x + 3] == 0 ? 1 : 0;
  }
  if (hidden == 0 || hidden == static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height))
    return 0;

  const Lanes<Value> lanes;
  BlockLevel blocks = pulled(a.width, a.height, [&](int x, int y) {
    Block out;
    const Value* const texel = a.at(x, y);
    if (texel[3] == 0) return out;
    out.a = lanes.a(texel);
    if (b.data != nullptr) out.b = lanes.b(b.at(x, y));
    return out;
  });
  push(blocks);

  for (int y = 0; y < a.height; ++y) {
    Value *row_a = a.row(y), *row_b = b.data == nullptr ? nullptr : b.row(y);
    int filled_column = -1;  // column of the block whose values are in value_a and value_b
    Value value_a[3]{}, value_b[4]{};
    for (int x = 0; x < a.width; ++x) {
      if (row_a[4 * x + 3] != 0) continue;
      if (x / 2 != filled_column) {
        filled_column = x / 2;
        const Block& block = blocks.row(y / 2)[x / 2];
        for (int c = 0; c < 3; ++c) {
          value_a[c] = lanes.color(block.a[c]);
          value_b[c] = lanes.color(block.b[c]);
        }
        value_b[3] = lanes.gloss(block.b[3]);
      }
      std::copy_n(value_a, 3, row_a + 4 * x);
      if (row_b != nullptr) std::copy_n(value_b, 4, row_b + 4 * x);
    }
  }
  return hidden;
}

template std::size_t bleed_under_alpha(const PixelsView8&, const PixelsView8&);
template std::size_t bleed_under_alpha(const PixelsViewOf<float>&, const PixelsViewOf<float>&);

}  // namespace etak
