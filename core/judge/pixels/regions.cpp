// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/regions.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace etak {

RegionPlane plane_of(RegionKind kind) {
  switch (kind) {
    case RegionKind::albedo_dark:
    case RegionKind::albedo_bright:
    case RegionKind::albedo_single:
      return RegionPlane::a;
    case RegionKind::half_metal:
      return RegionPlane::metallic;
    default:
      return RegionPlane::b;
  }
}

namespace {

constexpr int ring = RegionAnalysis::rows_kept;
constexpr int margin = 16;  // codes left and right of a row that repeat its ends
constexpr int flat = 4;     // largest range of codes on a plateau
constexpr int hue = 24;     // largest difference of neighbours in a channel on plateaus of any_f0, in codes

std::size_t slot_of(int y) {
  return static_cast<std::size_t>(y) % ring;
}

/// A row of codes, which are filled in when they are needed, 64 texels (a word) at a time.
struct CodeRow {
  int y = -1;  // which row; -1: none
  std::vector<std::uint8_t> codes;
  std::vector<bool> ready;  // per word

  void begin(int row, std::size_t words) {
    y = row;
    codes.resize(64 * words + 2 * margin);
    ready.assign(words, false);
  }
  std::uint8_t* at(int x) { return codes.data() + margin + x; }
};

/// Luminance codes of one picture and their medians, for the few rows around the one that is judged.
class Plane {
 public:
  Plane(RegionPlane which, int width, int height, const CodeTables& tables)
      : which_(which),
        width_(width),
        height_(height),
        words_((static_cast<std::size_t>(width) + 63) / 64),
        tables_(tables) {}

  const std::uint8_t* codes(int y, std::size_t word, const std::function<RowPointers(int)>& rows) {
    CodeRow& row = luminance_[slot_of(y)];
    if (row.y != y) row.begin(y, words_);
    if (!row.ready[word]) fill(row, word, rows(y));
    return row.at(static_cast<int>(64 * word));
  }

  /// Codes of the whole row from column 0; only the words of texels that were judged are filled.
  const std::uint8_t* row(int y) { return luminance_[slot_of(y)].at(0); }

  /// The bits of `wanted` whose 3x3 range of medians is at most `flat`.
  std::uint64_t flat_texels(int y, std::size_t word, std::uint64_t wanted,
                            const std::function<RowPointers(int)>& rows) {
    const std::size_t first = word == 0 ? 0 : word - 1, last = std::min(words_ - 1, word + 1);
    std::uint8_t least[66], most[66];
    for (int dy = -1; dy <= 1; ++dy) {
      const int other = std::clamp(y + dy, 0, height_ - 1);
      CodeRow& row = median_[slot_of(other)];
      if (row.y != other) row.begin(other, words_);
      for (std::size_t w = first; w <= last; ++w)
        if (!row.ready[w]) fill_median(row, w, rows);
      const std::uint8_t* m = row.at(static_cast<int>(64 * word) - 1);
      for (int i = 0; i < 66; ++i) {
        least[i] = dy == -1 ? m[i] : std::min(least[i], m[i]);
        most[i] = dy == -1 ? m[i] : std::max(most[i], m[i]);
      }
    }
    std::uint8_t range[64];
    for (int i = 0; i < 64; ++i)
      range[i] = static_cast<std::uint8_t>(std::max({most[i], most[i + 1], most[i + 2]}) -
                                           std::min({least[i], least[i + 1], least[i + 2]}));
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; ++i) bits |= std::uint64_t{range[i] <= flat} << i;
    return bits & wanted;
  }

 private:
  void fill(CodeRow& row, std::size_t word, const RowPointers& from) {
    row.ready[word] = true;
    const int x0 = static_cast<int>(64 * word), x1 = std::min(width_, x0 + 64);
    std::uint8_t* to = row.at(x0);
    if (which_ == RegionPlane::metallic) {
      for (int x = x0; x < x1; ++x) *to++ = from.metallic[4 * x];
    } else {
      const std::uint8_t* rgb = (which_ == RegionPlane::a ? from.a : from.b) + 4 * x0;
      // Flat pictures are the common case, so equal texels are not looked up again.
      std::uint32_t before = 0xffffffff;
      std::uint8_t code = 0;
      for (int x = x0; x < x1; ++x, rgb += 4) {
        const std::uint32_t now = static_cast<std::uint32_t>(rgb[0] | rgb[1] << 8 | rgb[2] << 16);
        if (now != before) code = tables_.luminance_code(rgb);
        before = now;
        *to++ = code;
      }
    }
    repeat_ends(row, word);
  }

  void repeat_ends(CodeRow& row, std::size_t word) {
    if (word == 0) std::memset(row.at(-margin), *row.at(0), margin);
    if (word + 1 == words_) {
      std::uint8_t* end = row.at(width_);
      const std::size_t rest = 64 * words_ - static_cast<std::size_t>(width_) + margin;
      std::memset(end, end[-1], rest);
    }
  }

  void fill_median(CodeRow& row, std::size_t word, const std::function<RowPointers(int)>& rows) {
    row.ready[word] = true;
    const int x0 = static_cast<int>(64 * word);
    const std::uint8_t* around[5];
    for (int i = 0; i < 5; ++i) {
      const int y = std::clamp(row.y + i - 2, 0, height_ - 1);
      if (word > 0) codes(y, word - 1, rows);
      if (word + 1 < words_) codes(y, word + 1, rows);
      around[i] = codes(y, word, rows) - 2;
    }
    std::uint8_t least = 255, most = 0;
    for (const auto* codes : around)
      for (int i = 0; i < 68; ++i) {
        least = std::min(least, codes[i]);
        most = std::max(most, codes[i]);
      }
    std::uint8_t* to = row.at(x0);
    if (least == most) {
      std::memset(to, least, 64);
    } else {
      for (int x = 0; x < 64; x += 16) {
        const std::uint8_t* part[5];
        for (int i = 0; i < 5; ++i) part[i] = around[i] + x;
        median_5x5(part, to + x);
      }
    }
    repeat_ends(row, word);
  }

  RegionPlane which_;
  int width_, height_;
  std::size_t words_;
  const CodeTables& tables_;
  std::array<CodeRow, ring> luminance_, median_;
};

/// The bits of `wanted` whose neighbours to the left and right, and above and below, have similar colours:
/// where two materials of one luminance meet, the plateaus of any_f0 must not run together. The limit is
/// wide, because texels are compared and not medians.
std::uint64_t like_coloured(int y, std::size_t word, std::uint64_t wanted, const PixelBox& tile,
                            const std::function<RowPointers(int)>& rows) {
  const std::uint8_t *above = rows(std::max(0, y - 1)).b, *here = rows(y).b,
                     *below = rows(std::min(tile.height - 1, y + 1)).b;
  std::uint64_t like = 0;
  for (std::uint64_t rest = wanted; rest != 0; rest &= rest - 1) {
    const int x = static_cast<int>(64 * word) + std::countr_zero(rest);
    const std::uint8_t *left = here + 4 * std::max(0, x - 1),
                       *right = here + 4 * std::min(tile.width - 1, x + 1);
    int most = 0;
    for (int c = 0; c < 3; ++c)
      most = std::max({most, std::abs(left[c] - right[c]), std::abs(above[4 * x + c] - below[4 * x + c])});
    if (most <= hue) like |= rest & -rest;
  }
  return like;
}

/// The latest rows of a mask.
struct BitRows {
  std::size_t words = 0;
  std::vector<std::uint64_t> bits;
  std::array<bool, ring> filled{};  // by row: some bit is set

  explicit BitRows(std::size_t count) : words(count), bits(count * ring) {}
  std::uint64_t* row(int y) { return bits.data() + slot_of(y) * words; }
  bool any(int y) const { return filled[slot_of(y)]; }
};

/// Keeps the texels whose neighbours to the left and right are set too; beyond the ends the end is repeated.
void erode_across(const std::uint64_t* in, std::size_t words, int width, std::uint64_t* out) {
  std::uint64_t left = in[0] & 1;  // the bit that stands left of the word
  const int last = (width - 1) % 64;
  for (std::size_t w = 0; w < words; ++w) {
    const bool end = w + 1 == words;
    const std::uint64_t right = end ? (in[w] >> last & 1) << last : in[w + 1] << 63;
    out[w] = in[w] & (in[w] << 1 | left) & (in[w] >> 1 | right);
    left = in[w] >> 63;
  }
}

bool and_rows(const std::uint64_t* a, const std::uint64_t* b, const std::uint64_t* c, std::size_t words,
              std::uint64_t* out) {
  std::uint64_t any = 0;
  for (std::size_t w = 0; w < words; ++w) any |= out[w] = a[w] & b[w] & c[w];
  return any != 0;
}

/// The state of one kind in one tile.
struct KindState {
  RegionKind kind;
  BitRows across, eroded, across2, eroded2;
  Components components;
  std::size_t masked = 0, masked_rows = 0;
  int left = std::numeric_limits<int>::max(), right = -1, top = 0, bottom = 0;  // of the mask, in the tile
  bool open = false;  // the components hold a row above

  KindState(RegionKind k, std::size_t words, const PixelBox& tile, std::size_t least_area, int erode,
            const CodeTables& tables)
      : kind(k),
        across(erode == 1 ? 0 : words),
        eroded(words),
        across2(erode == 5 ? words : 0),
        eroded2(erode == 5 ? words : 0),
        components(k, tile, least_area, erode / 2, tables) {}

  // Counts the texels of row y of the mask, and widens the box around all of them.
  bool add_mask(int y, const std::uint64_t* mask, std::size_t words) {
    std::size_t first = words, last = 0;
    for (std::size_t w = 0; w < words; ++w) {
      if (mask[w] == 0) continue;
      masked += static_cast<std::size_t>(std::popcount(mask[w]));
      first = std::min(first, w);
      last = w;
    }
    if (first == words) return false;
    left = std::min(left, static_cast<int>(64 * first) + std::countr_zero(mask[first]));
    right = std::max(right, static_cast<int>(64 * last) + 63 - std::countl_zero(mask[last]));
    if (masked_rows++ == 0) top = y;
    bottom = y;
    return true;
  }

  PixelBox masked_box(const PixelBox& tile) const {
    if (masked == 0) return {};
    return {tile.x + left, tile.y + top, right - left + 1, bottom - top + 1};
  }
};

}  // namespace

struct RegionAnalysis::State {
  PixelBox tile;
  int erode;
  std::size_t words;
  std::vector<KindState> kinds;
  std::array<std::unique_ptr<Plane>, 3> planes;
  std::vector<std::uint64_t> plateau;
  Recorder recorder;

  Plane& plane(RegionKind kind) { return *planes[static_cast<std::size_t>(plane_of(kind))]; }

  // Makes row `y` of the eroded mask from the rows around it.
  static void erode_down(BitRows& from, BitRows& to, int y, int height) {
    const int above = std::max(0, y - 1), below = std::min(height - 1, y + 1);
    to.filled[slot_of(y)] = from.any(above) && from.any(y) && from.any(below) &&
                            and_rows(from.row(above), from.row(y), from.row(below), from.words, to.row(y));
  }

  void second_across(KindState& k, int y) {
    k.across2.filled[slot_of(y)] = k.eroded.any(y);
    if (k.eroded.any(y)) erode_across(k.eroded.row(y), words, tile.width, k.across2.row(y));
  }

  void judge(std::size_t index, int y, const std::function<RowPointers(int)>& rows) {
    KindState& k = kinds[index];
    BitRows& survivors = erode == 5 ? k.eroded2 : k.eroded;
    if (!survivors.any(y)) {
      if (k.open) k.components.add_empty_row();
      k.open = false;
      return;
    }
    Plane& p = plane(k.kind);
    const std::uint64_t* in = survivors.row(y);
    std::uint64_t any = 0;
    for (std::size_t w = 0; w < words; ++w) {
      plateau[w] = in[w] == 0 ? 0 : p.flat_texels(y, w, in[w], rows);
      if (k.kind == RegionKind::any_f0) plateau[w] = like_coloured(y, w, plateau[w], tile, rows);
      if (plateau[w] != 0) p.codes(y, w, rows);
      any |= plateau[w];
    }
    if (any == 0) {
      if (k.open) k.components.add_empty_row();
      k.open = false;
      return;
    }
    if (recorder) recorder(index, y, plateau.data());
    k.components.add_row(y, plateau.data(), words, rows(y), p.row(y));
    k.open = true;
  }
};

RegionAnalysis::RegionAnalysis(const PixelBox& tile, std::span<const RegionKind> kinds, int erode,
                               std::size_t least_area, const CodeTables& tables)
    : state_(std::make_unique<State>()) {
  assert(tile.width > 0 && tile.height > 0);
  State& s = *state_;
  s.tile = tile;
  s.erode = erode;
  s.words = (static_cast<std::size_t>(tile.width) + 63) / 64;
  s.plateau.resize(s.words);
  s.kinds.reserve(kinds.size());
  for (const RegionKind kind : kinds) {
    s.kinds.emplace_back(kind, s.words, tile, least_area, erode, tables);
    auto& plane = s.planes[static_cast<std::size_t>(plane_of(kind))];
    if (!plane) plane = std::make_unique<Plane>(plane_of(kind), tile.width, tile.height, tables);
  }
}

RegionAnalysis::~RegionAnalysis() = default;
RegionAnalysis::RegionAnalysis(RegionAnalysis&&) noexcept = default;

std::size_t RegionAnalysis::word_count() const {
  return state_->words;
}

void RegionAnalysis::record(Recorder recorder) {
  state_->recorder = std::move(recorder);
}

void RegionAnalysis::push(int y, const std::uint64_t* masks, const std::function<RowPointers(int)>& rows) {
  State& s = *state_;
  const int height = s.tile.height;
  const bool last = y == height - 1;
  for (std::size_t i = 0; i < s.kinds.size(); ++i) {
    KindState& k = s.kinds[i];
    const std::uint64_t* mask = masks + i * s.words;
    if (s.erode == 0) {
      s.recorder(i, y, mask);
      continue;
    }
    const bool any = k.add_mask(y, mask, s.words);
    if (s.erode == 1) {
      k.eroded.filled[slot_of(y)] = any;
      if (any) std::copy_n(mask, s.words, k.eroded.row(y));
    } else {
      k.across.filled[slot_of(y)] = any;
      if (any) erode_across(mask, s.words, s.tile.width, k.across.row(y));
      for (int e = std::max(0, y - 1); e <= (last ? y : y - 1); ++e) {
        State::erode_down(k.across, k.eroded, e, height);
        if (s.erode != 5) continue;
        s.second_across(k, e);
        if (e >= 1) State::erode_down(k.across2, k.eroded2, e - 1, height);
        if (e == height - 1) State::erode_down(k.across2, k.eroded2, e, height);
      }
    }
    // A row is judged three rows late: it needs the medians of the row below, which need two rows more.
    for (int judged = last ? std::max(0, y - 3) : y - 3; judged <= (last ? y : y - 3); ++judged)
      if (judged >= 0) s.judge(i, judged, rows);
  }
}

std::vector<PlateauSummary> RegionAnalysis::finish() {
  std::vector<PlateauSummary> out;
  for (KindState& k : state_->kinds) {
    PlateauSummary& summary = out.emplace_back();
    summary.masked = k.masked;
    summary.masked_box = k.masked_box(state_->tile);
    k.components.finish(summary);
  }
  return out;
}

}  // namespace etak
