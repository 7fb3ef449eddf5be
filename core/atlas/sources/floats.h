// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/atlas/leave_out.h"
#include "core/atlas/sources/sources.h"
#include "core/image/picture.h"

namespace etak {

// Materials as floats, for outputs that hold floats: from the numbers of the files, not from 8-bit codes.

/// A picture as floats, codes as fractions of full scale.
Image fractions(Picture picture);

/// One plane as floats, row by row, in any order and by several threads at once: a colour in linear light (three channels)
/// or a grey quantity (one). Values outside of 0..1 stay. Throws Error: what PlaneRows throws, and for values that are
/// not finite.
class PlaneNumbers {
 public:
  /// Reads the file, unless it is known(). `source` must outlive this object.
  PlaneNumbers(const PlaneSource& source, int width, int height);
  int channels() const { return source_->color ? 3 : 1; }
  /// Writes row `y`, channels() values a texel.
  void read(int y, float* out) const;

 private:
  float value(double v, bool floats) const;

  const PlaneSource* source_;
  std::size_t width_;
  std::shared_ptr<const Picture> picture_;  // null: a constant
  std::array<int, 3> pick_{};
  std::vector<float> of_code_;  // the values of the codes of a file
};

/// One plane at its full size: a colour in linear light (three channels) or a grey quantity (one). Throws Error as
/// PlaneNumbers.
Image plane_floats(const PlaneSource& source, int width, int height);

/// Both textures of a material at its size. What its pictures do not say is constant.
FloatPair load_floats(const PackInput& material);

/// A linear channel of base colour c and metalness m: diffuse = c (1 - m), F0 = 0.04 (1 - m) + c m.
struct MetallicChannel {
  double diffuse, f0;
};
inline MetallicChannel metallic_channel(double base, double metallic) {
  return {base * (1 - metallic), 0.04 + (base - 0.04) * metallic};
}

/// Both textures of base colour and metalness, by metallic_channel().
FloatPair metallic_floats(const PlaneSource& base, const PlaneSource& alpha, const PlaneSource& metallic,
                          const PlaneSource& gloss, int width, int height);

}  // namespace etak
