// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace etak::demo {

/// Writes a small world of materials to the folder `path`, the same bytes every time; all pictures are drawn
/// by demo_textures.h:
///   manifest.json   for `etak pack`: gold, copper, wood, glass, red plastic, white paint, stone dry (twice)
///                   and wet, a leaf; optics by name from etak's library, the rest from pictures
///   scene.gltf      glTF 2.0 with scene.bin: spheres and quads, a tiled floor, a mask, glass,
///                   specular-gloss, two equal pictures, a quad that sees part of its picture, and a material
///                   that nothing uses
///   *.png           pictures of both
/// Throws Error.
///   overwrite       false: refuses a folder that has one of these files
void write_demo_scene(const std::string& path, bool overwrite);

/// Writes to the folder `path` the pictures of six materials that cannot be real, or are stored so that a program
/// draws them wrong: what the validator is for. Throws Error.
void write_demo_mistakes(const std::string& path, bool overwrite);

}  // namespace etak::demo
