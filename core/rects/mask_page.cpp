// SPDX-License-Identifier: Apache-2.0
#include "core/rects/mask_page.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/rects/index.h"

namespace etak::rects {
namespace {

using Word = std::uint64_t;
constexpr int word_bits = 64;
constexpr Word all_ones = ~Word{0};

int log2_floor(int value) {
  return std::bit_width(static_cast<unsigned>(value)) - 1;
}

bool bit(const Word* row, int x) {
  return (row[x / word_bits] >> (x % word_bits) & 1) != 0;
}

void set(Word* row, int begin, int end) {
  for (int i = begin / word_bits; i <= (end - 1) / word_bits; ++i) {
    const int from = std::max(begin - i * word_bits, 0), to = std::min(end - i * word_bits, word_bits);
    row[i] |= (all_ones << from) & (all_ones >> (word_bits - to));
  }
}

}  // namespace

ReadyMask::ReadyMask(MaskShape of)
    : shape(std::move(of)), longest_first(shape.runs), area(static_cast<std::int64_t>(count_of(shape.runs))) {
  std::stable_sort(longest_first.begin(), longest_first.end(),
                   [](const RowRun& a, const RowRun& b) { return a.end - a.begin > b.end - b.begin; });
}

MaskPage::MaskPage(int width, int height)
    : width_(width),
      words_((width + word_bits - 1) / word_bits),
      stride_(at(words_) + 1),
      levels_(at(log2_floor(width) + 1), std::vector<Word>(stride_ * at(height), 0)),
      taken_(at(words_)) {}

const MaskPage::Word* MaskPage::row(int level, int y) const {
  return levels_[at(level)].data() + stride_ * at(y);
}

MaskPage::Word* MaskPage::row(int level, int y) {
  return levels_[at(level)].data() + stride_ * at(y);
}

std::optional<MaskSpot> MaskPage::find(const ReadyMask& of, int last) {
  if (of.shape.width > width_) return std::nullopt;
  const int columns = width_ - of.shape.width + 1, words = (columns + word_bits - 1) / word_bits;
  const Word beyond = columns % word_bits == 0 ? 0 : all_ones << (columns % word_bits);
  for (int y = 0; y <= last; ++y) {
    std::fill_n(taken_.begin(), words, Word{0});
    taken_[at(words - 1)] = beyond;
    if (!any_free(of, y, words)) continue;
    for (int i = 0; i < words; ++i)
      if (taken_[at(i)] != all_ones) return MaskSpot{i * word_bits + std::countr_one(taken_[at(i)]), y};
  }
  return std::nullopt;
}

bool MaskPage::is_free(const MaskShape& shape, const MaskSpot& spot) const {
  if (spot.x < 0 || spot.y < 0 || spot.x + shape.width > width_ ||
      at(spot.y + shape.height) * stride_ > levels_[0].size())
    return false;
  return std::ranges::all_of(shape.runs, [&](const RowRun& run) {
    const int level = log2_floor(run.end - run.begin);
    const Word* const here = row(level, spot.y + run.row);
    return !bit(here, spot.x + run.begin) && !bit(here, spot.x + run.end - (1 << level));
  });
}

void MaskPage::put(const MaskShape& shape, const MaskSpot& spot) {
  for (std::size_t i = 0; i < shape.runs.size(); ++i) {
    const RowRun& run = shape.runs[i];
    set(row(0, spot.y + run.row), spot.x + run.begin, spot.x + run.end);
    if (i + 1 == shape.runs.size() || shape.runs[i + 1].row != run.row) widen(spot.y + run.row);
  }
}

void MaskPage::widen(int y) {
  for (int k = 1; k < static_cast<int>(levels_.size()); ++k) {
    const Word* const from = row(k - 1, y);
    Word* const to = row(k, y);
    const int shift = 1 << (k - 1), words = shift / word_bits, bits = shift % word_bits;
    for (int i = 0; i < words_; ++i) {
      const Word low = i + words < words_ ? from[i + words] : 0;
      const Word high = i + words + 1 < words_ ? from[i + words + 1] : 0;
      to[i] = from[i] | (bits == 0 ? low : low >> bits | high << (word_bits - bits));
    }
  }
}

bool MaskPage::any_free(const ReadyMask& of, int y, int words) {
  for (const RowRun& run : of.longest_first) {
    const int level = log2_floor(run.end - run.begin);
    const Word* const here = row(level, y + run.row);
    const int second = run.end - (1 << level);
    const Word *const a = here + run.begin / word_bits, *const b = here + second / word_bits;
    const int a_bits = run.begin % word_bits, b_bits = second % word_bits;
    Word all = all_ones;
    for (int i = 0; i < words; ++i) {
      // Shifting by one and then by the rest leaves nothing where the rest is a whole word.
      const Word first = a[i] >> a_bits | a[i + 1] << 1 << (word_bits - 1 - a_bits);
      const Word last = b[i] >> b_bits | b[i + 1] << 1 << (word_bits - 1 - b_bits);
      taken_[at(i)] |= first | last;
      all &= taken_[at(i)];
    }
    if (all == all_ones) return false;
  }
  return true;
}

std::optional<RectPlace> put_lowest(MaskPage& page, const ReadyMask& upright, const ReadyMask* turned,
                                    int height) {
  std::optional<MaskSpot> spot = page.find(upright, height - upright.shape.height);
  bool is_turned = false;
  if (turned != nullptr) {
    const std::optional<MaskSpot> second = page.find(*turned, height - turned->shape.height);
    const auto end = [](const MaskSpot& s, const ReadyMask& r) { return s.y + r.shape.height; };
    is_turned = second && (!spot || end(*second, *turned) < end(*spot, upright));
    if (is_turned) spot = second;
  }
  if (!spot) return std::nullopt;
  page.put((is_turned ? *turned : upright).shape, *spot);
  return RectPlace{0, spot->x, spot->y, is_turned};
}

}  // namespace etak::rects
