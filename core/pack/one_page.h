// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/atlas/sources/sources.h"

namespace etak {

struct PackOptions;
struct PackSource;
struct PackResult;

// One pair of textures for all materials, so that one bind serves a whole scene (Schueler's argument for two
// textures). What materials share is found part by part (diffuse, alpha, F0, gloss): each part is stored once,
// and what is one number is one texel.

/// Where a part of a material lies: in the pair of one of the packed inputs, or, of a number, in a texel of it.
struct PartPlace {
  std::size_t sheet = 0;
  std::optional<int> texel;
};

/// How materials read the inputs that are packed in their place. These hold a part of some material in each of
/// their four; a part that no material has there is black, and opaque.
struct OnePage {
  std::vector<PackInput> materials;                                 // as they were read
  std::vector<std::array<PartPlace, channel_parts.size()>> places;  // by material
  std::vector<std::size_t> channels;  // by packed input: how many some material reads
  TexelAccount before;                // of the materials
  std::vector<LeaveOutLine> lines;    // what sharing leaves out, and numbers
};

/// Puts sheets of shared parts in the place of the source's materials. The colour of a sheet has alpha beside it
/// only where all materials of that colour read that alpha, so that mips and bleeding are those of the materials.
/// The gloss has normals beside it where all its materials have the same ones; else that is told.
///   result   gets these remarks, and what the materials take on pages of their own
/// Throws Error for a material that tiles over its surface, and what reading the pictures throws.
std::shared_ptr<const OnePage> share_parts(const PackOptions& options, PackSource& source,
                                           PackResult& result);

}  // namespace etak
