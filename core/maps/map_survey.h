// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/image/picture.h"
#include "core/maps/map_evidence.h"

namespace etak {

// Maps are looked at in bands of rows: all of them up to a million texels, evenly spread ones of larger maps.
// A defect of a share of the texels is found in such a sample as well, and the cost stays below that of
// decoding.

inline constexpr int map_band_rows = 16;

/// Where the channel of gloss or roughness lies in the picture beside a normal map.
struct GlossPlace {
  std::size_t channel = 0;
  bool is_gloss = false;  // 1 - roughness
};

/// The pictures beside a normal map, of its size; null: none.
struct BesideNormals {
  RowSource* height = nullptr;
  RowSource* gloss = nullptr;
  GlossPlace place = {};
};

/// Reads a normal map from the top, and the others in step with it. Throws Error for broken data.
/// Of the evidence, what the texels tell is filled in.
MapEvidence survey_normals(RowSource& normals, const BesideNormals& beside);

/// Surveys an occlusion map (its first channel) or an emissive map (the largest of its colours).
///   alpha   the base colour beside an emissive map, of its size; null: none
MapEvidence survey_grey(RowSource& map, FileRole role, RowSource* alpha);

/// Surveys a texture in blocks in step with the picture of its size that it was made of. Labels are not filled in.
///   gloss   where both hold gloss or roughness; that of F0 is Schueler's. Colours that are floats are not compared,
///           nor those under alpha 0, of which encoders make what they like
BlockLoss survey_loss(RowSource& blocks, RowSource& source, FileRole role, std::optional<GlossPlace> gloss);

}  // namespace etak
