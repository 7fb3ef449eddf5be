// SPDX-License-Identifier: Apache-2.0
#include "core/image/mips.h"

#include <atomic>

#include "core/image/linear_tables.h"
#include "core/image/mip_chain.h"
#include "core/image/mip_rows.h"

namespace etak {
namespace {

using namespace mip_detail;

// Rows of codes, turned into texels as they are read. Opacity stays in codes: their means are exact.
struct CodeRow {
  const LinearTables* tables;
  const std::uint8_t *codes_a, *codes_b, *codes_n;
  int channels_n;
  NormalVariance variance;

  static std::size_t at(int x, int channels) {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(channels);
  }
  Float4 a(int x) const {
    const std::uint8_t* c = codes_a + at(x, 4);
    return Float4{tables->srgb[c[0]], tables->srgb[c[1]], tables->srgb[c[2]], static_cast<float>(c[3])};
  }
  Float4 b(int x) const {
    const std::uint8_t* c = codes_b + at(x, 4);
    return Float4{tables->srgb[c[0]], tables->srgb[c[1]], tables->srgb[c[2]], tables->inverse[c[3]]};
  }
  Float4 n(int x) const {
    const std::uint8_t* c = codes_n + at(x, channels_n);
    const auto component = [](std::uint8_t code) { return static_cast<float>(code) / 127.5f - 1; };
    return normal_lanes(component(c[0]), component(c[1]), component(c[2]), variance);
  }
};

struct CodeSource {
  const LinearTables& tables;
  ConstPixelsView8 a, b, normals;  // normals.data null: none
  NormalVariance variance;
  CodeRow row(int y) const {
    return {&tables,          a.row(y), b.row(y), normals.data == nullptr ? nullptr : normals.row(y),
            normals.channels, variance};
  }
};

// The beginning of a new row; returns how many texels.
int average_first(const std::array<CodeRow, 3>& rows, int count, bool weigh_by_opacity, const OutRow& out) {
  const MipRows* const fast = mip_rows();
  if (fast == nullptr) return 0;
  return fast->average(rows[0].codes_a, rows[1].codes_a, rows[0].codes_b, rows[1].codes_b, count,
                       weigh_by_opacity, *rows[0].tables, out.a, out.b);
}

ChainShape shape_of(int width, int height, const MipOptions& options) {
  const int full = full_mip_levels(width, height);
  return {width, height, options.levels == 0 ? full : std::min(options.levels, full),
          options.alpha_weights_diffuse, options.normals != nullptr};
}

// Levels 1 and on into to_a[l], to_b[l] ([0] is not touched).
std::size_t write_levels(ConstPixelsView8 a, ConstPixelsView8 b, const MipOptions& options, unsigned threads,
                         std::span<const PixelsView8> to_a, std::span<const PixelsView8> to_b) {
  assert(a.width == b.width && a.height == b.height && a.channels == 4 && b.channels == 4);
  assert(options.normals == nullptr ||
         (options.normals->width == a.width && options.normals->height == a.height &&
          options.normals->channels >= 3));
  const LinearTables& tables = linear_tables();
  const ChainShape shape = shape_of(a.width, a.height, options);
  const CodeSource source{tables, a, b,
                          options.normals != nullptr ? view(*options.normals) : ConstPixelsView8{},
                          options.normal_variance};

  // A mask's opacities are scaled when a level is whole.
  std::vector<std::vector<float>> opacities(static_cast<std::size_t>(shape.levels));
  if (options.alpha_cutoff)
    for (int level = 1; level < shape.levels; ++level)
      opacities[static_cast<std::size_t>(level)].resize(static_cast<std::size_t>(side_at(a.width, level)) *
                                                        static_cast<std::size_t>(side_at(a.height, level)));

  const float widest = 1 / tables.gloss_step[1];  // up to half a code wider than gloss 0 still rounds to it
  std::atomic<std::size_t> clamped{0};
  const MipRows* const fast = mip_rows();
  make_chain(shape, threads, source, [&](int level, int y, const StoredRow& row) {
    const auto at = static_cast<std::size_t>(level);
    const int width = side_at(a.width, level);
    std::uint8_t *out_a = to_a[at].row(y), *out_b = to_b[at].row(y);
    std::size_t wider = 0;
    int x = 0;
    if (fast != nullptr && row.texels_n == nullptr)
      x = fast->encode(row.texels_a, row.texels_b, width, tables, widest, out_a, out_b, wider);
    for (out_a += 4 * x, out_b += 4 * x; x < width; ++x, out_a += 4, out_b += 4) {
      const Float4 texel_a = row.a(x), texel_b = row.b(x);
      for (int c = 0; c < 3; ++c) {
        out_a[c] = tables.srgb_code(texel_a[c]);
        out_b[c] = tables.srgb_code(texel_b[c]);
      }
      out_a[3] = static_cast<std::uint8_t>(texel_a[3] + 0.5f);
      float inverse = texel_b[3];
      if (row.texels_n != nullptr) inverse += added_variance(row.n(x), options.normal_variance);
      wider += inverse > widest ? 1 : 0;
      out_b[3] = tables.gloss_code(inverse);
    }
    if (wider > 0) clamped += wider;
    if (!opacities[at].empty()) {
      float* to = opacities[at].data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
      for (int i = 0; i < width; ++i) to[i] = row.a(i)[3];
    }
  });

  if (!options.alpha_cutoff) return clamped;
  // A code passes when code / 255 >= cutoff; the samples between texels are no whole codes.
  const auto cutoff = static_cast<float>(*options.alpha_cutoff * 255);
  const double share = coverage(a.width, a.height, cutoff, threads, [&](int y, float* out) {
    const std::uint8_t* from = a.row(y);
    for (int x = 0; x < a.width; ++x) out[x] = static_cast<float>(from[4 * x + 3]);
  });
  for (int level = 1; level < shape.levels; ++level) {
    const auto at = static_cast<std::size_t>(level);
    const int width = side_at(a.width, level), height = side_at(a.height, level);
    const float factor = coverage_factor(opacities[at], width, height, cutoff, share, 255, true, threads);
    const float* from = opacities[at].data();
    for (int y = 0; y < height; ++y) {
      std::uint8_t* out = to_a[at].row(y);
      for (int x = 0; x < width; ++x)
        out[4 * x + 3] = static_cast<std::uint8_t>(scaled_opacity(*from++, factor, 255, true));
    }
  }
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
  return write_levels(a, b, options, threads, to_a, to_b);
}

MipPair mip_pair(const Image8& a, const Image8& b, const MipOptions& options, unsigned threads) {
  MipPair pair;
  std::vector<PixelsView8> to_a, to_b;
  const int levels = shape_of(a.width, a.height, options).levels;
  for (auto [from, images] : {std::pair{&a, &pair.diffuse_alpha}, std::pair{&b, &pair.specular_gloss}}) {
    images->reserve(static_cast<std::size_t>(levels));
    images->push_back(*from);
    for (int level = 1; level < levels; ++level)
      images->emplace_back(side_at(from->width, level), side_at(from->height, level), 4);
  }
  for (Image8& image : pair.diffuse_alpha) to_a.push_back(view(image));
  for (Image8& image : pair.specular_gloss) to_b.push_back(view(image));
  pair.gloss_clamped = write_levels(view(a), view(b), options, threads, to_a, to_b);
  return pair;
}

}  // namespace etak
