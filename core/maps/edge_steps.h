// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/image/picture.h"

namespace etak {

/// How a picture continues beside itself, in codes: means over a line of texels of how far the three colours of a texel
/// are from those of its neighbour.
///   across   [0] from the last column to the first, [1] from the last row to the first
///   inside   [0] the largest between neighbouring columns, [1] between neighbouring rows
struct EdgeSteps {
  std::array<double, 2> across{}, inside{};
};

/// Reads all rows of a picture.
EdgeSteps edge_steps(RowSource& rows);

}  // namespace etak
