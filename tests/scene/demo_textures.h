// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/image/image.h"

// The demo's pictures, all drawn by noise.h and all periodic. Colours are sRGB codes; the rest (gloss,
// roughness, opacity, normals) plain codes.
namespace etak::demo {

Image8 wood_colour();    // 512, RGB: rings along u
Image8 wood_gloss();     // 512, grey: late wood shines more
Image8 worn_gloss();     // 256, grey: polished metal with scratches
Image8 stained_gloss();  // 256, grey: metal with dull stains

/// Stone: dry, or as Schueler shows it wet: darker and more saturated, glossy where water stands.
Image8 stone_colour(bool wet);  // 512, RGB
Image8 stone_gloss(bool wet);   // 512, grey
Image8 stone_normals();         // 512, RGB: tangent space, +y up

Image8 leaf();  // 256, RGBA: one leaf; opacity is 0 or 255 but for its edge

/// glTF's packing: roughness = 1 - gloss in G, metal in B.
Image8 metal_rough(const Image8& gloss, bool metal);

/// One colour all over, as programs export what is a number.
Image8 one_colour(int side, const std::array<std::uint8_t, 3>& codes);

// Mistakes. The same picture encoded for sRGB once more; of RGBA with black where nothing is seen; with its
// linear values between `least` and `most`.
Image8 encoded_again(const Image8& picture);
Image8 with_black_ground(const Image8& picture);
Image8 brightened(const Image8& picture, double least, double most);

}  // namespace etak::demo
