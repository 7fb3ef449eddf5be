// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"

namespace etak {

inline constexpr int most_page_side = 1024;

/// A page of four channels that is made by formula, the same in every run.
struct MadePage {
  const char* id;
  const char* title;
  Image8 pixels;
};

/// What pages of textures hold, of each kind one: grain (stone), shapes on nothing (sprites), patches of one
/// colour with a fine gloss (materials). What a compression level costs depends on all of them: on noise
/// alone every level gives up early and takes the same time.
///   side   of each, up to most_page_side: the left upper part of a page of that side
std::vector<MadePage> made_pages(int side);

}  // namespace etak
