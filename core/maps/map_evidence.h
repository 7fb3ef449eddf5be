// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/maps/file_role.h"
#include "core/maps/normals.h"

namespace etak {

// What was seen of the pictures that stand beside a material's colours: normal, occlusion and emissive maps.
// Rules read it and never see texels. Of large maps a sample of bands is looked at (map_survey.h).

/// Sums for a linear relation of two quantities.
struct PairSums {
  std::uint64_t count = 0;
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(double x_, double y_) {
    ++count;
    x += x_;
    y += y_;
    xx += x_ * x_;
    yy += y_ * y_;
    xy += x_ * y_;
  }
  /// Correlation, -1 to 1, of the deviations from the means; 0 where one of them does not vary.
  double correlation() const;
  /// The correlation of the quantities themselves, for slopes that are 0 on the whole.
  double correlation_about_zero() const;
  /// Slope of y over x, and how many of its standard errors it is away from 0; 0 where x does not vary.
  double slope() const;
  double slope_errors() const;
};

/// A normal map's texels beside their neighbours. Lengths are of a vector whose unit is 127.5 codes.
///   off      length wrong by more than 2.5 codes; rounding alone makes 0.9
///   too_short, too_long   by more than a code
///   smooth   texels whose neighbours point the same way within 1.5 degrees; smooth_short: those too short
///   loss     x: what averaging four normals would take from the length, by the neighbours' differences;
///            y: what the length lacks
///   steep_colors   different colours among texels with a loss, counted up to 4096
///   twist    of texels that are twisted by more than 1.5 codes: x the change of the slope to the right
///            along the rows downwards, y that of the slope in green along the columns to the right. Where
///            the map is of a surface, the two are equal (green points down) or opposite (green points up)
///   relief_x, relief_y    slopes of red and of green against those of the height map beside, to the right
///                         and downwards
struct NormalShape {
  std::uint64_t texels = 0;
  std::uint64_t grey = 0;  // of all rows: the three codes within 2 of each other
  std::uint64_t off = 0, too_short = 0, too_long = 0;
  std::uint64_t smooth = 0, smooth_short = 0;
  PairSums loss, twist, relief_x, relief_y;
  std::uint32_t steep_colors = 0;
};

/// Blocks of 4 x 4 texels of a normal map with the roughness of the same texels.
///   varying   their mean normal is shorter than 0.9
///   narrow    of those: whose highlight is more than four times narrower than the normals allow
///   relation  x: what the mean normal lacks in length; y: roughness
struct GlossBesideNormals {
  std::uint64_t blocks = 0, varying = 0, narrow = 0;
  PairSums relation;
  std::string label;  // of the file with roughness or gloss
};

/// The steps that a JPEG's quantiser has left in the brightness of its blocks.
///   step    of the lowest frequencies, in codes
///   score   1: all of them lie on multiples; 0: none in particular
struct JpegComb {
  double step = 0, score = 0;
};

/// Codes of a grey map, or the largest of the three of an emissive map.
///   hidden       texels whose alpha in the base colour beside is 0; hidden_lit: of those, with a code above
///                16
///   coloured     of an occlusion map in a file of its own: texels that are not grey (other_content.h)
struct GreyFacts {
  std::uint64_t texels = 0;
  std::array<std::uint64_t, 256> codes{};
  std::uint64_t hidden = 0, hidden_lit = 0, coloured = 0;

  /// Texels with first <= code <= last.
  std::uint64_t between(int first, int last) const;
};

struct MapEvidence {
  FileRole role = FileRole::normal;
  std::string label;
  int width = 0, height = 0;
  std::string blocks = {};              // the name of the format, of a texture in blocks (block_formats)
  GreenAxis green = GreenAxis::unsaid;  // what the name, or the format, says
  std::string said_by = {};             // "its name", "glTF 2.0"
  NormalFacts normals = {};
  NormalShape shape = {};
  std::optional<GlossBesideNormals> gloss = {};
  std::optional<JpegComb> jpeg = {};
  GreyFacts grey = {};
  bool packed = false;  // a channel of a picture that holds roughness or metallic too
};

/// What compression has changed of a texture in blocks, by the picture beside it: 99th percentiles over its texels.
///   source     label of that picture
///   colour     CIEDE2000 of colours or F0
///   exponent   percent of the exponent of gloss or roughness. Codes that differ by one count as equal, because 8 bits alone
///              round as much
///   degrees    between normals
struct BlockLoss {
  std::string label, blocks, source;
  std::optional<double> colour, exponent, degrees;
};

/// What is wrong with a normal map as a whole. The first that is true stands for what follows from it, so
/// that lengths are not blamed on a map that was stored by a curve.
enum class NormalDamage { none, empty, constant, height, encoded, jpeg, shrunk };
NormalDamage damage_of(const MapEvidence& map);

/// Which way green points by the map itself, or by the height map beside it.
struct MeasuredGreen {
  GreenAxis axis = GreenAxis::unsaid;
  double agreement = 0;    // 0 to 1
  bool by_height = false;  // the map alone does not tell
};
MeasuredGreen measured_green(const MapEvidence& map);

}  // namespace etak
