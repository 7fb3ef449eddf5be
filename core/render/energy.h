// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/render/scene.h"

namespace etak {

/// The directional albedo of the scene's surface, quickly, for marking pictures: the share of light of
/// radiance 1 from all directions that goes to the viewer, in the channel where it is largest. A value above
/// 1 is more light than came in.
///   steps     how many cosines between viewer and normal, evenly from 0 to 1 (0.01 is taken for 0); >= 2
///   returns   one albedo for each cosine
///   error     0.01 for lobes of gloss 0 to 1
std::vector<float> quick_albedo(const Scene& scene, int steps);

}  // namespace etak
