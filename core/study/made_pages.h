// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"

namespace etak {

/// The largest side of a made page, in texels.
inline constexpr int most_page_side = 1024;

/// A page of four channels that is made by formula, the same in every run.
struct MadePage {
  const char* id;
  const char* title;
  Image8 pixels;
};

/// One page of each kind of content that textures have: grain (stone), shapes on a transparent ground
/// (sprites), patches of one colour with fine structure in the gloss (materials). The time of a compression
/// level depends on the content: on noise alone every level gives up early and takes the same time.
///   side   of each page, up to most_page_side; a smaller page is the upper left part of the largest
std::vector<MadePage> made_pages(int side);

}  // namespace etak
