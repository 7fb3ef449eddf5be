// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/image/files/png.h"

namespace etak::test {

/// What is changed of a scene.
///   mirrored         pictures and UVs are turned over from left to right, and normals with them
///   color_gains      of base colour in linear light, by channel
///   roughness_gain   of the codes of roughness
///   color_side, other_side   sides of the pictures of base colour and of all others, as shares of what they
///                            were; the nearest texels are taken
struct Alteration {
  const char* name;
  bool mirrored = false;
  std::array<double, 3> color_gains{1, 1, 1};
  double roughness_gain = 1;
  double color_side = 1, other_side = 1;
};

/// A mirrored copy, one with other colours and roughness, one of other sizes, and one whose metal and
/// roughness have a quarter of the texels of their colour. All have half the side or less, which takes a
/// quarter of the time.
inline const std::vector<Alteration> alterations{{"mirrored", true, {1, 1, 1}, 1, 0.5, 0.5},
                                                 {"gains", false, {0.9, 0.55, 0.7}, 0.8, 0.5, 0.5},
                                                 {"sizes", true, {1, 1, 1}, 1, 0.375, 0.375},
                                                 {"uneven", false, {0.8, 1, 0.6}, 0.9, 0.5, 0.25}};

/// Writes an altered copy of a glTF scene of files into a folder that is there: scene.gltf, its buffer, and
/// each picture as PNG. Returns the path of scene.gltf.
std::string altered_copy(const std::string& scene, const Alteration& alteration, PngLevel level,
                         const std::string& folder);

}  // namespace etak::test
