// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/floats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/color/srgb.h"

namespace etak {
namespace {

// A picture's numbers: codes as they are, which floats hold exactly.
struct Numbers {
  Image image;
  double full = 1;      // the code that stands for 1
  bool floats = false;  // of a file of floats, whose colours are linear by themselves

  double at(std::size_t i) const { return double{image.values[i]} / full; }
};

template <class Code>
Numbers numbers_of(const Pixels<Code>& codes) {
  Numbers out{Image(codes.width, codes.height, codes.channels), std::numeric_limits<Code>::max(), false};
  std::copy(codes.values.begin(), codes.values.end(), out.image.values.begin());
  return out;
}

Numbers numbers_of(Picture picture) {
  if (auto* floats = std::get_if<Image>(&picture.pixels)) return {std::move(*floats), 1, true};
  if (const auto* wide = std::get_if<Image16>(&picture.pixels)) return numbers_of(*wide);
  return numbers_of(std::get<Image8>(picture.pixels));
}

double value_of(const PlaneSource& source, double v, bool floats) {
  const CodeCurve* curve = source.curve.get();
  if (!source.color) return curve != nullptr && curve->apply ? curve->apply(v) : v;
  if (curve != nullptr && floats && curve->linear_float) return curve->linear_float(v);
  if (curve != nullptr && curve->linear) return curve->linear(v);
  return srgb_decode(v);
}

// Colour and grey planes side by side.
Image joined(const Image& color, const Image& grey) {
  Image out(color.width, color.height, 4);
  for (std::size_t i = 0; i < out.pixel_count(); ++i) {
    std::copy_n(color.values.data() + 3 * i, 3, out.values.data() + 4 * i);
    out.values[4 * i + 3] = grey.values[i];
  }
  return out;
}

}  // namespace

Image fractions(Picture picture) {
  Numbers numbers = numbers_of(std::move(picture));
  for (std::size_t i = 0; i < numbers.image.values.size(); ++i)
    numbers.image.values[i] = static_cast<float>(numbers.at(i));
  return std::move(numbers.image);
}

Image plane_floats(const PlaneSource& source, int width, int height) {
  const std::size_t channels = source.color ? 3 : 1;
  Image out(width, height, static_cast<int>(channels));
  if (!source.is_image()) {
    for (std::size_t i = 0; i < out.values.size(); ++i)
      out.values[i] = static_cast<float>(source.exact[i % channels]);
    return out;
  }
  const Numbers numbers = numbers_of(load_picture(source.path, *source.door));
  const Image& from = numbers.image;
  check_size(source, from.width, from.height, width, height);
  const std::array<int, 3> pick = picked_channels(source, from.channels);
  const auto step = static_cast<std::size_t>(from.channels);
  for (std::size_t i = 0; i < out.pixel_count(); ++i)
    for (std::size_t c = 0; c < channels; ++c) {
      const double v = numbers.at(step * i + static_cast<std::size_t>(pick[c]));
      if (!std::isfinite(v)) refuse_not_finite(source);
      out.values[channels * i + c] =
          static_cast<float>(source.space ? v : value_of(source, v, numbers.floats));
    }
  if (source.space) source.space(out.values.data(), out.pixel_count());
  return out;
}

FloatPair load_floats(const PackInput& m) {
  if (m.convert_floats) return m.convert_floats();
  const auto texture = [&](std::size_t t) {
    return joined(plane_floats(m.color[t], m.width, m.height), plane_floats(m.grey[t], m.width, m.height));
  };
  return {texture(0), texture(1)};
}

FloatPair metallic_floats(const PlaneSource& base, const PlaneSource& alpha, const PlaneSource& metallic,
                          const PlaneSource& gloss, int width, int height) {
  Image diffuse = plane_floats(base, width, height), f0 = diffuse;
  const Image metal = plane_floats(metallic, width, height);
  for (std::size_t i = 0; i < metal.values.size(); ++i)
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const MetallicChannel texel = metallic_channel(double{diffuse.values[c]}, double{metal.values[i]});
      diffuse.values[c] = static_cast<float>(texel.diffuse);
      f0.values[c] = static_cast<float>(texel.f0);
    }
  return {joined(diffuse, plane_floats(alpha, width, height)),
          joined(f0, plane_floats(gloss, width, height))};
}

}  // namespace etak
