// SPDX-License-Identifier: Apache-2.0
#include "core/image/mips.h"

#include <atomic>
#include <limits>

#include "core/color/gloss.h"
#include "core/image/linear_tables.h"
#include "core/image/mip_chain.h"
#include "core/image/mip_rows.h"

namespace etak {
namespace {

using namespace mip_detail;

// Converts the values of a picture to the numbers that are averaged, and back.
template <class Value>
struct Scale;

// Opacities are averaged as codes, whose sums are exact in float.
template <>
struct Scale<std::uint8_t> {
  static constexpr bool rounded = true;
  static constexpr float largest = 255;  // opacity of an opaque texel
  const LinearTables& tables = linear_tables();
  float widest = 1 / tables.gloss_step[1];  // half a code wider than gloss 0, which still rounds to it

  float linear(std::uint8_t code) const { return tables.srgb[code]; }
  float variance(std::uint8_t code) const { return tables.inverse[code]; }
  std::uint8_t color(float v) const { return tables.srgb_code(v); }
  std::uint8_t opacity(float v) const { return static_cast<std::uint8_t>(v + 0.5f); }
  std::uint8_t gloss(float v) const { return tables.gloss_code(v); }
};

template <>
struct Scale<float> {
  static constexpr bool rounded = false;
  static constexpr float largest = 1;
  float widest = std::numeric_limits<float>::infinity();

  float linear(float v) const { return v; }
  float variance(float v) const { return variance_of_gloss(v); }
  float color(float v) const { return v; }
  float opacity(float v) const { return v; }
  float gloss(float v) const { return gloss_of_variance(v); }
};

// A row of level 0, whose values become texels when they are read.
template <class Value>
struct LevelRow {
  const Scale<Value>* scale;
  const Value *values_a, *values_b;
  const std::uint8_t* codes_n;
  int channels_n;
  NormalVariance variance;

  static std::size_t at(int x, int channels) {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(channels);
  }
  Float4 a(int x) const {
    const Value* v = values_a + at(x, 4);
    return Float4{scale->linear(v[0]), scale->linear(v[1]), scale->linear(v[2]), static_cast<float>(v[3])};
  }
  Float4 b(int x) const {
    const Value* v = values_b + at(x, 4);
    return Float4{scale->linear(v[0]), scale->linear(v[1]), scale->linear(v[2]), scale->variance(v[3])};
  }
  Float4 n(int x) const {
    const std::uint8_t* c = codes_n + at(x, channels_n);
    const auto component = [](std::uint8_t code) { return static_cast<float>(code) / 127.5f - 1; };
    return normal_lanes(component(c[0]), component(c[1]), component(c[2]), variance);
  }
};

template <class Value>
struct LevelSource {
  const Scale<Value>& scale;
  PixelsViewOf<const Value> a, b;
  ConstPixelsView8 normals;  // its data is null where there are no normals
  NormalVariance variance;
  LevelRow<Value> row(int y) const {
    return {&scale,           a.row(y), b.row(y), normals.data == nullptr ? nullptr : normals.row(y),
            normals.channels, variance};
  }
};

// The overload of mip_chain.h for rows of codes, by the loops of mip_rows.h.
int average_first(const std::array<LevelRow<std::uint8_t>, 3>& rows, int count, bool weigh_by_opacity,
                  const OutRow& out) {
  const MipRows* const fast = mip_rows();
  if (fast == nullptr) return 0;
  return fast->average(rows[0].values_a, rows[1].values_a, rows[0].values_b, rows[1].values_b, count,
                       weigh_by_opacity, rows[0].scale->tables, out.a, out.b);
}

ChainShape shape_of(int width, int height, const MipOptions& options) {
  const int full = full_mip_levels(width, height);
  return {width, height, options.levels == 0 ? full : std::min(options.levels, full),
          options.alpha_weights_diffuse, options.normals != nullptr};
}

// The unscaled opacities of each level from 1 on; empty vectors where there is no alpha cutoff.
using LevelOpacities = std::vector<std::vector<float>>;

// Encodes one row of a level; returns how many of its texels have a lobe wider than that of gloss 0.
template <class Value>
std::size_t write_row(const StoredRow& row, int width, const Scale<Value>& scale, NormalVariance variance,
                      Value* out_a, Value* out_b) {
  std::size_t wider = 0;
  int x = 0;
  if constexpr (Scale<Value>::rounded)
    if (const MipRows* const fast = mip_rows(); fast != nullptr && row.texels_n == nullptr)
      x = fast->encode(row.texels_a, row.texels_b, width, scale.tables, scale.widest, out_a, out_b, wider);
  for (out_a += 4 * x, out_b += 4 * x; x < width; ++x, out_a += 4, out_b += 4) {
    const Float4 texel_a = row.a(x), texel_b = row.b(x);
    for (int c = 0; c < 3; ++c) {
      out_a[c] = scale.color(texel_a[c]);
      out_b[c] = scale.color(texel_b[c]);
    }
    out_a[3] = scale.opacity(texel_a[3]);
    float inverse = texel_b[3];
    if (row.texels_n != nullptr) inverse += added_variance(row.n(x), variance);
    wider += inverse > scale.widest ? 1 : 0;
    out_b[3] = scale.gloss(inverse);
  }
  return wider;
}

// Scales the alpha of every level so that its coverage is that of level 0.
template <class Value>
void keep_coverage(const PixelsViewOf<const Value>& a, const LevelOpacities& opacities, double alpha_cutoff,
                   const Scale<Value>& scale, unsigned threads, std::span<const PixelsViewOf<Value>> to_a) {
  // A code passes when code / 255 >= cutoff. The cutoff is not rounded to a code, because samples between
  // texels are fractions of codes.
  const auto cutoff = static_cast<float>(alpha_cutoff * double{scale.largest});
  const double share = coverage(a.width, a.height, cutoff, threads, [&](int y, float* out) {
    const Value* from = a.row(y);
    for (int x = 0; x < a.width; ++x) out[x] = static_cast<float>(from[4 * x + 3]);
  });
  for (std::size_t level = 1; level < opacities.size(); ++level) {
    const int width = side_at(a.width, static_cast<int>(level)),
              height = side_at(a.height, static_cast<int>(level));
    const float factor = coverage_factor({opacities[level], width, height, scale.largest, scale.rounded},
                                         cutoff, share, threads);
    const float* from = opacities[level].data();
    for (int y = 0; y < height; ++y) {
      Value* out = to_a[level].row(y);
      for (int x = 0; x < width; ++x)
        out[4 * x + 3] = static_cast<Value>(scaled_opacity(*from++, factor, scale.largest, scale.rounded));
    }
  }
}

// Writes the levels from 1 on into to_a[l] and to_b[l]; entry 0 is not written.
template <class Value>
std::size_t write_levels(PixelsViewOf<const Value> a, PixelsViewOf<const Value> b, const MipOptions& options,
                         unsigned threads, std::span<const PixelsViewOf<Value>> to_a,
                         std::span<const PixelsViewOf<Value>> to_b) {
  assert(a.width == b.width && a.height == b.height && a.channels == 4 && b.channels == 4);
  assert(options.normals == nullptr ||
         (options.normals->width == a.width && options.normals->height == a.height &&
          options.normals->channels >= 3));
  const Scale<Value> scale;
  const ChainShape shape = shape_of(a.width, a.height, options);
  const LevelSource<Value> source{scale, a, b,
                                  options.normals != nullptr ? view(*options.normals) : ConstPixelsView8{},
                                  options.normal_variance};
  // The opacities of a mask are kept unscaled, because the factor of a level is known when all of it is made.
  LevelOpacities opacities(static_cast<std::size_t>(shape.levels));
  if (options.alpha_cutoff)
    for (int level = 1; level < shape.levels; ++level)
      opacities[static_cast<std::size_t>(level)].resize(static_cast<std::size_t>(side_at(a.width, level)) *
                                                        static_cast<std::size_t>(side_at(a.height, level)));

  std::atomic<std::size_t> clamped{0};
  make_chain(shape, threads, source, [&](int level, int y, const StoredRow& row) {
    const auto at = static_cast<std::size_t>(level);
    const int width = side_at(a.width, level);
    const std::size_t wider =
        write_row(row, width, scale, options.normal_variance, to_a[at].row(y), to_b[at].row(y));
    if (wider > 0) clamped += wider;
    if (opacities[at].empty()) return;
    float* to = opacities[at].data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int i = 0; i < width; ++i) to[i] = row.a(i)[3];
  });
  if (options.alpha_cutoff) keep_coverage(a, opacities, *options.alpha_cutoff, scale, threads, to_a);
  return clamped;
}

}  // namespace

const mip_detail::MipRows* mip_detail::mip_rows() {
#ifdef ETAK_MIPS_X86_64
  static const bool avx2 = (__builtin_cpu_init(), __builtin_cpu_supports("avx2") != 0);
  return avx2 ? &mip_rows_avx2() : nullptr;
#else
  return nullptr;
#endif
}

int full_mip_levels(int width, int height) {
  assert(width >= 1 && height >= 1);
  return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

std::size_t mip_levels(const ConstPixelsView8& a, const ConstPixelsView8& b, const MipOptions& options,
                       unsigned threads, std::span<const PixelsView8> to_a,
                       std::span<const PixelsView8> to_b) {
  return write_levels<std::uint8_t>(a, b, options, threads, to_a, to_b);
}

template <class Value>
MipPairOf<Value> mip_pair(const Pixels<Value>& a, const Pixels<Value>& b, const MipOptions& options,
                          unsigned threads) {
  MipPairOf<Value> pair;
  std::array<std::vector<PixelsViewOf<Value>>, 2> to;
  const int levels = shape_of(a.width, a.height, options).levels;
  for (const Texture texture : both_textures) {
    const Pixels<Value>& from = texture == Texture::diffuse_alpha ? a : b;
    auto& images = pair.of(texture);
    images.reserve(static_cast<std::size_t>(levels));
    images.push_back(from);
    for (int level = 1; level < levels; ++level)
      images.emplace_back(side_at(from.width, level), side_at(from.height, level), 4);
    for (Pixels<Value>& image : images) to[static_cast<std::size_t>(texture)].push_back(view(image));
  }
  pair.gloss_clamped = write_levels<Value>(view(a), view(b), options, threads, to[0], to[1]);
  return pair;
}

template MipPair mip_pair(const Image8&, const Image8&, const MipOptions&, unsigned);
template MipPairFloat mip_pair(const Image&, const Image&, const MipOptions&, unsigned);

}  // namespace etak
