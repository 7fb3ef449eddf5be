// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

/// What a sampler reads beyond the edges of a picture, along one axis.
enum class Wrap { repeat, mirrored, clamp };

/// The column (or row) that a sampler reads for column `at` of a picture of `size` columns.
inline int wrapped_texel(int at, int size, Wrap wrap) {
  if (at >= 0 && at < size) return at;
  if (wrap == Wrap::clamp) return at < 0 ? 0 : size - 1;
  const int period = wrap == Wrap::mirrored ? 2 * size : size;
  const int in = (at % period + period) % period;
  return in < size ? in : period - 1 - in;
}

}  // namespace etak
