// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/render/scene.h"

namespace etak {

/// Share of light from all around that the scene's surface sends to a viewer, in the channel where it is
/// most, at `steps` cosines of the viewer from 0 (a hair above) to 1. What is above 1 is more than came.
///   error   0.01 for the lobes of gloss 0 to 1; quick, for pictures
std::vector<float> quick_albedo(const Scene& scene, int steps);

}  // namespace etak
