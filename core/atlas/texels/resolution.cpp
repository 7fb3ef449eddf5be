// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/resolution.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"
#include "core/image/wrap.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// The eight quantities of a texel, colours linear.
using Quantities = std::array<float, channel_count>;

class Sampler {
 public:
  Sampler(const MaterialPair& pair, const WrapBoth& wrap) : pair_(pair), wrap_(wrap) {}

  int width() const { return pair_.diffuse_alpha.width; }
  int height() const { return pair_.diffuse_alpha.height; }

  // Bilinear at a place in texels, their centres at halves.
  Quantities at(double x, double y) const {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const auto right_share = static_cast<float>(x - 0.5 - left),
               low_share = static_cast<float>(y - 0.5 - top);
    Quantities out{};
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const float share = (i == 0 ? 1 - right_share : right_share) * (j == 0 ? 1 - low_share : low_share);
        if (share > 0) add(static_cast<int>(left) + i, static_cast<int>(top) + j, share, out);
      }
    return out;
  }

 private:
  void add(int x, int y, float share, Quantities& out) const {
    const int column = wrapped_texel(x, width(), wrap_[0]), row = wrapped_texel(y, height(), wrap_[1]);
    const auto& linear = linear_tables().srgb;
    std::size_t c = 0;
    for (const Image8* picture : {&pair_.diffuse_alpha, &pair_.specular_gloss}) {
      const auto texel = picture->at(column, row);
      for (std::size_t k = 0; k < 3; ++k) out[c++] += share * linear[texel[k]];
      out[c++] += share * static_cast<float>(texel[3]) / 255;
    }
  }

  const MaterialPair& pair_;
  const WrapBoth& wrap_;
};

LinearRgb color(const Quantities& v, std::size_t first) {
  return {double{v[first]}, double{v[first + 1]}, double{v[first + 2]}};
}

// What CIEDE2000 of two colours cannot exceed. With its a' = (1 + G) a, G <= 0.5, and all of its divisors at least 1:
// dE^2 <= (1 + |RT| / 2) (dL^2 + da'^2 + db^2), |RT| <= 2.
double most_delta_e(const Lab& a, const Lab& b) {
  const double l = a.l - b.l, x = 1.5 * (a.a - b.a), y = a.b - b.b;
  return std::sqrt(2 * (l * l + x * x + y * y));
}

// Codes of sRGB rise by so much of linear light at most, near black.
constexpr double steepest = 12.92;

// Takes the difference of two places into the worst one. What cannot be worse is not computed.
void widen(ResolutionError& worst, const Quantities& a, const Quantities& b) {
  if (a == b) return;
  for (const Texture texture : both_textures) {
    const std::size_t first = first_channel(texture);
    const double plain = std::abs(double{a[first + 3]} - double{b[first + 3]});
    worst.delta_e = std::max(worst.delta_e, 100 * plain);
    worst.codes = std::max(worst.codes, 255 * plain);
    double most = 0;
    for (std::size_t c = first; c < first + 3; ++c) {
      const double linear = std::abs(double{a[c]} - double{b[c]});
      most = std::max(most, linear);
      if (255 * steepest * linear > worst.codes)
        worst.codes =
            std::max(worst.codes, 255 * std::abs(srgb_encode(double{a[c]}) - srgb_encode(double{b[c]})));
    }
    if (most == 0) continue;
    const Lab x = to_lab(color(a, first)), y = to_lab(color(b, first));
    if (most_delta_e(x, y) > worst.delta_e) worst.delta_e = std::max(worst.delta_e, delta_e2000(x, y));
  }
}

// A normal map as unit vectors: their means over areas are the mean normals of the levels.
Image unit_normals(const Image8& map) {
  Image out(map.width, map.height, 3);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto code = map.at(x, y);
      double v[3], square = 0;
      for (std::size_t c = 0; c < 3; ++c) v[c] = code[c] / 127.5 - 1, square += v[c] * v[c];
      const double length = std::sqrt(square);
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = static_cast<float>(length > 0 ? v[c] / length : c == 2 ? 1 : 0);
    }
  return out;
}

double variance(std::span<const float> mean) {
  constexpr double least = 1e-3;  // of |N|: its variance makes a lobe wider than roughness 1
  const double length = std::max(least, math::hypot(double{mean[0]}, double{mean[1]}, double{mean[2]}));
  return std::max(0.0, (1 - length) / length);
}

double plain(std::uint8_t code) {
  return code / 255.0;
}
double plain(float value) {
  return double{value};
}

// Replaces the gloss of levels 1 and on, for which mip_pair() took gloss as Schueler's: each from level 0.
template <class Value>
void average_roughness(std::vector<Pixels<Value>>& levels, GlossForm form, const Image8* normals) {
  const Pixels<Value>& first = levels.front();
  Image squared(first.width, first.height, 1);
  for (std::size_t i = 0; i < squared.values.size(); ++i) {
    const double r = converted_gloss(plain(first.values[4 * i + 3]), form, GlossForm::roughness);
    squared.values[i] = static_cast<float>(r * r * r * r);
  }
  const Image units = normals != nullptr ? unit_normals(*normals) : Image();
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const Image mean = shrunk(squared, levels[l].width, levels[l].height);
    const Image spread = normals != nullptr ? shrunk(units, levels[l].width, levels[l].height) : Image();
    for (std::size_t i = 0; i < mean.values.size(); ++i) {
      double width = std::max(double{mean.values[i]}, 0.0);
      if (normals != nullptr) width += 2 * variance({spread.values.data() + 3 * i, 3});
      const double gloss =
          converted_gloss(std::sqrt(std::sqrt(std::min(width, 1.0))), GlossForm::roughness, form);
      if constexpr (sizeof(Value) == 1)
        levels[l].values[4 * i + 3] = plain_u8(gloss);
      else
        levels[l].values[4 * i + 3] = static_cast<float>(gloss);
    }
  }
}

}  // namespace

template <class Value>
MipPairOf<Value> region_chain(const Pixels<Value>& a, const Pixels<Value>& b, MipOptions options,
                              GlossForm gloss, unsigned threads) {
  if (gloss == GlossForm::schueler) return mip_pair(a, b, options, threads);
  const Image8* normals = std::exchange(options.normals, nullptr);
  auto out = mip_pair(a, b, options, threads);
  average_roughness(out.specular_gloss, gloss, normals);
  return out;
}

template MipPair region_chain(const Image8&, const Image8&, MipOptions, GlossForm, unsigned);
template MipPairFloat region_chain(const Image&, const Image&, MipOptions, GlossForm, unsigned);

MipOptions mip_options(const PackInput& material, int levels) {
  MipOptions out;
  out.levels = levels;
  if (material.alpha_mode == AlphaMode::mask) out.alpha_cutoff = material.alpha_cutoff;
  return out;
}

template <class Value>
MipPairOf<Value> levels_from(int first, int levels, const PairPart<Value>& part, GlossForm gloss,
                             unsigned threads) {
  MipOptions options = mip_options(part.material, first + levels);
  std::optional<Image8> normals;
  if (part.material.has_normals() && levels > 1) {
    normals = normals_of(part.material, part.box);
    options.normals = &*normals;
  }
  MipPairOf<Value> out = region_chain(part.a, part.b, options, gloss, threads);
  for (auto* images : {&out.diffuse_alpha, &out.specular_gloss})
    images->erase(images->begin(), images->begin() + std::min(first, static_cast<int>(images->size()) - 1));
  return out;
}

template MipPair levels_from(int, int, const PairPart<std::uint8_t>&, GlossForm, unsigned);
template MipPairFloat levels_from(int, int, const PairPart<float>&, GlossForm, unsigned);

ResolutionError resolution_error(const MaterialPair& whole, const MaterialPair& fewer, const WrapBoth& wrap,
                                 const PixelBox& looked_at, double enough, unsigned threads) {
  const Sampler a(whole, wrap), b(fewer, wrap);
  const double across = static_cast<double>(b.width()) / a.width(),
               down = static_cast<double>(b.height()) / a.height();
  const auto rows = 2 * static_cast<std::size_t>(looked_at.height) + 1;
  std::vector<ResolutionError> worst(rows);
  std::atomic<bool> stop{false};
  parallel_chunks(rows, threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t row = begin; row < end && !stop; ++row)
      for (int column = 0; column <= 2 * looked_at.width; ++column) {
        const double x = looked_at.x + 0.5 * column, y = looked_at.y + 0.5 * static_cast<double>(row);
        widen(worst[begin], a.at(x, y), b.at(across * x, down * y));
        if (worst[begin].delta_e > enough) {
          stop = true;
          return;
        }
      }
  });
  ResolutionError out;
  for (const ResolutionError& each : worst) {
    out.delta_e = std::max(out.delta_e, each.delta_e);
    out.codes = std::max(out.codes, each.codes);
  }
  return out;
}

PixelBox whole_texels(const PixelBox& box, int level) {
  const auto end = [level](int at) { return (at + (1 << level) - 1) >> level; };
  const int x = box.x >> level, y = box.y >> level;
  return {x, y, end(box.x + box.width) - x, end(box.y + box.height) - y};
}

Resolution resolution_of(const MipPair& levels, const ResolutionLimits& limits, const WrapBoth& wrap,
                         const PixelBox& looked_at, unsigned threads) {
  const int deepest = static_cast<int>(levels.diffuse_alpha.size()) - 1;
  const auto level = [&](int l) {
    return MaterialPair{levels.diffuse_alpha[static_cast<std::size_t>(l)],
                        levels.specular_gloss[static_cast<std::size_t>(l)]};
  };
  constexpr double any = 1e9;
  Resolution out;
  const int free = out.shrink = std::min(limits.unseen, deepest);
  const MaterialPair reference = level(free);
  const PixelBox seen_at = whole_texels(looked_at, free);
  const auto varies = [](const Image8& picture) {
    for (std::size_t i = 3; i < picture.values.size(); i += 4)
      if (picture.values[i] != picture.values[3]) return true;
    return false;
  };
  if (limits.bound && !(limits.mask && varies(reference.diffuse_alpha)))
    for (int l = free + 1; l <= deepest; ++l) {
      const ResolutionError error =
          resolution_error(reference, level(l), wrap, seen_at, *limits.bound, threads);
      if (error.delta_e > *limits.bound) break;
      out.shrink = l;
      out.seen = error;
    }
  if (out.shrink > 0)
    out.whole =
        free == 0 ? out.seen : resolution_error(level(0), level(out.shrink), wrap, looked_at, any, threads);
  return out;
}

MaterialPair stored_pair(const MaterialPair& pair, const Region& region, const PackInput& material,
                         GlossForm gloss) {
  const Image8 a = part_of(pair.diffuse_alpha, region.box), b = part_of(pair.specular_gloss, region.box);
  MipPair stored = levels_from(region.shrink, 1, PairPart<std::uint8_t>{material, region.box, a, b}, gloss);
  return {std::move(stored.diffuse_alpha.front()), std::move(stored.specular_gloss.front())};
}

}  // namespace etak
