// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/floats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "core/color/srgb.h"

namespace etak {
namespace {

double value_of(const PlaneSource& source, double v, bool floats) {
  const CodeCurve* curve = source.curve.get();
  if (!source.color) return curve != nullptr && curve->apply ? curve->apply(v) : v;
  if (curve != nullptr && floats && curve->linear_float) return curve->linear_float(v);
  if (curve != nullptr && curve->linear) return curve->linear(v);
  return srgb_decode(v);
}

// What stands for 1 in a picture.
template <class Value>
double full(const Pixels<Value>&) {
  return sizeof(Value) < sizeof(float) ? double{std::numeric_limits<Value>::max()} : 1.0;
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
  if (auto* floats = std::get_if<Image>(&picture.pixels)) return std::move(*floats);
  return std::visit(
      [](const auto& from) {
        Image out(from.width, from.height, from.channels);
        for (std::size_t i = 0; i < out.values.size(); ++i)
          out.values[i] = static_cast<float>(static_cast<double>(from.values[i]) / full(from));
        return out;
      },
      std::as_const(picture.pixels));
}

PlaneNumbers::PlaneNumbers(const PlaneSource& source, int width, int height)
    : source_(&source), width_(static_cast<std::size_t>(width)) {
  if (!source.is_image()) return;
  picture_ = source.known();
  if (!picture_) picture_ = std::make_shared<const Picture>(load_picture(source.path, *source.door));
  const auto& [header, pixels] = *picture_;
  check_size(source, header.width, header.height, width, height);
  pick_ = picked_channels(source, header.channels);
  std::visit(
      [&]<class Value>(const Pixels<Value>& from) {
        if constexpr (sizeof(Value) < sizeof(float)) {
          of_code_.resize(std::size_t{std::numeric_limits<Value>::max()} + 1);
          for (std::size_t code = 0; code < of_code_.size(); ++code)
            of_code_[code] = value(static_cast<double>(code) / full(from), false);
        }
      },
      pixels);
}

float PlaneNumbers::value(double v, bool floats) const {
  return static_cast<float>(source_->space ? v : value_of(*source_, v, floats));
}

void PlaneNumbers::read(int y, float* out) const {
  const auto channels = static_cast<std::size_t>(this->channels());
  if (!picture_) {
    for (std::size_t i = 0; i < channels * width_; ++i)
      out[i] = static_cast<float>(source_->exact[i % channels]);
    return;
  }
  std::visit(
      [&]<class Value>(const Pixels<Value>& from) {
        const auto step = static_cast<std::size_t>(from.channels);
        const Value* row = from.at(0, y).data();
        for (std::size_t x = 0; x < width_; ++x, row += step)
          for (std::size_t c = 0; c < channels; ++c) {
            const Value v = row[pick_[c]];
            if constexpr (sizeof(Value) < sizeof(float)) {
              out[channels * x + c] = of_code_[v];
            } else {
              if (!std::isfinite(v)) refuse_not_finite(*source_);
              out[channels * x + c] = value(double{v}, true);
            }
          }
      },
      picture_->pixels);
  if (source_->space) source_->space(out, width_);
}

Image plane_floats(const PlaneSource& source, int width, int height) {
  const PlaneNumbers numbers(source, width, height);
  Image out(width, height, numbers.channels());
  for (int y = 0; y < height; ++y) numbers.read(y, out.at(0, y).data());
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
