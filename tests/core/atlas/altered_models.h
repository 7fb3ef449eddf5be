// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdlib>
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
/// roughness have a quarter of the texels of their colour.
inline const std::vector<Alteration> alterations{{"mirrored", true},
                                                 {"gains", false, {0.9, 0.55, 0.7}, 0.8},
                                                 {"sizes", true, {1, 1, 1}, 1, 0.75, 0.75},
                                                 {"uneven", false, {0.8, 1, 0.6}, 0.9, 1, 0.5}};

/// The alterations that are tried on a model, by its place among the real ones: two, in turn, because all of
/// them take minutes; all where ETAK_ALL_COPIES is set.
inline std::vector<Alteration> alterations_of(std::size_t model) {
  if (std::getenv("ETAK_ALL_COPIES") != nullptr) return alterations;
  return {alterations[1 - model % 2], alterations[3 - model % 2]};
}

/// Writes an altered copy of a glTF scene of files into a folder that is there: scene.gltf, its buffer, and
/// each picture as PNG. Returns the path of scene.gltf.
std::string altered_copy(const std::string& scene, const Alteration& alteration, PngLevel level,
                         const std::string& folder);

}  // namespace etak::test
