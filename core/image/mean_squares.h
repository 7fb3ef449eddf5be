// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/image/image.h"

namespace etak {

/// Gives rows of a picture one after the other, `channels` values a pixel, each valid until the next is asked for.
using RowReader = std::function<const float*(int y)>;

/// A picture that is made row by row, in a smaller size: each new pixel is the mean over a square of pixels, which is cut
/// off at the right and the lower edge. Several threads work at once.
///   channels   1, 3, 4 or 8
///   most       the squares are as small as no side above this allows
///   open       makes a reader for one thread, which is asked for rows from `first` on
Image mean_squares(int width, int height, int channels, int most,
                   const std::function<RowReader(int first)>& open);

}  // namespace etak
