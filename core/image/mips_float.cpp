// SPDX-License-Identifier: Apache-2.0
#include "core/color/gloss.h"
#include "core/image/mip_chain.h"

namespace etak {
namespace {

using namespace mip_detail;

struct FloatRow {
  const float *values_a, *values_b, *values_n;
  NormalVariance variance;

  Float4 a(int x) const {
    const float* c = values_a + 4 * x;
    return Float4{c[0], c[1], c[2], c[3]};
  }
  Float4 b(int x) const {
    const float* c = values_b + 4 * x;
    return Float4{c[0], c[1], c[2], variance_of_gloss(c[3])};
  }
  Float4 n(int x) const {
    const float* c = values_n + 3 * x;
    return normal_lanes(c[0], c[1], c[2], variance);
  }
};

struct FloatSource {
  const Image &a, &b;
  const std::vector<float>& normals;  // x y z
  NormalVariance variance;
  FloatRow row(int y) const {
    return {a.at(0, y).data(), b.at(0, y).data(),
            normals.empty()
                ? nullptr
                : normals.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) * 3,
            variance};
  }
};

std::vector<float> decoded(const Image8& normals) {
  std::vector<float> out;
  out.reserve(normals.pixel_count() * 3);
  for (int y = 0; y < normals.height; ++y)
    for (int x = 0; x < normals.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) out.push_back(static_cast<float>(normals.at(x, y)[c]) / 127.5f - 1);
  return out;
}

}  // namespace

MipPairFloat mip_pair(const Image& a, const Image& b, const MipOptions& options, unsigned threads) {
  assert(a.width == b.width && a.height == b.height && a.channels == 4 && b.channels == 4);
  assert(options.normals == nullptr ||
         (options.normals->width == a.width && options.normals->height == a.height &&
          options.normals->channels >= 3));
  const int full = full_mip_levels(a.width, a.height);
  const ChainShape shape{a.width, a.height, options.levels == 0 ? full : std::min(options.levels, full),
                         options.alpha_weights_diffuse, options.normals != nullptr};
  const std::vector<float> normals =
      options.normals != nullptr ? decoded(*options.normals) : std::vector<float>();

  MipPairFloat pair;
  for (auto [from, images] : {std::pair{&a, &pair.diffuse_alpha}, std::pair{&b, &pair.specular_gloss}}) {
    images->reserve(static_cast<std::size_t>(shape.levels));
    images->push_back(*from);
    for (int level = 1; level < shape.levels; ++level)
      images->emplace_back(side_at(from->width, level), side_at(from->height, level), 4);
  }
  make_chain(shape, threads, FloatSource{a, b, normals, options.normal_variance},
             [&](int level, int y, const StoredRow& row) {
               Image& to_a = pair.diffuse_alpha[static_cast<std::size_t>(level)];
               Image& to_b = pair.specular_gloss[static_cast<std::size_t>(level)];
               for (int x = 0; x < to_a.width; ++x) {
                 const Float4 texel_a = row.a(x), texel_b = row.b(x);
                 float inverse = texel_b[3];
                 if (row.texels_n != nullptr) inverse += added_variance(row.n(x), options.normal_variance);
                 for (std::size_t c = 0; c < 3; ++c) {
                   to_a.at(x, y)[c] = texel_a[static_cast<int>(c)];
                   to_b.at(x, y)[c] = texel_b[static_cast<int>(c)];
                 }
                 to_a.at(x, y)[3] = texel_a[3];
                 to_b.at(x, y)[3] = gloss_of_variance(inverse);
               }
             });

  if (!options.alpha_cutoff) return pair;
  const auto cutoff = static_cast<float>(*options.alpha_cutoff);
  const auto row_of = [](const Image& image) {
    return [&image](int y, float* out) {
      for (int x = 0; x < image.width; ++x) out[x] = image.at(x, y)[3];
    };
  };
  const double share = coverage(a.width, a.height, cutoff, threads, row_of(a));
  for (std::size_t level = 1; level < pair.diffuse_alpha.size(); ++level) {
    Image& image = pair.diffuse_alpha[level];
    std::vector<float> opacities(image.pixel_count());
    for (int y = 0; y < image.height; ++y)
      row_of(image)(y,
                    opacities.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width));
    const float factor =
        coverage_factor(opacities, image.width, image.height, cutoff, share, 1, false, threads);
    for (std::size_t i = 0; i < opacities.size(); ++i)
      image.values[4 * i + 3] = scaled_opacity(opacities[i], factor, 1, false);
  }
  return pair;
}

}  // namespace etak
