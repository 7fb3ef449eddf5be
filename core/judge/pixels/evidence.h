// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/surfaces/document.h"
#include "core/judge/pixels/components.h"
#include "core/judge/target.h"
#include "core/maps/edge_steps.h"
#include "core/maps/map_evidence.h"
#include "core/maps/other_content.h"

namespace etak {

// Evidence: everything that is known of a target before a rule has judged it. Rules read it and never see
// pixels.

/// How often each of the 256 codes of a channel occurs.
using Histogram = std::array<std::uint32_t, 256>;

/// The codes between the 1st and the 99th percentile of a histogram.
struct CodeSteps {
  int first = 0, last = 0;               // codes
  int used = 0;                          // how many of them occur
  int median_step = 0, widest_step = 0;  // from one used code to the next
};
CodeSteps code_steps(const Histogram& codes);

/// Counts of the byte pass: exact, over every texel.
struct ByteCounts {
  std::uint64_t texels = 0, opaque = 0;  // opaque: those that the 1xx to 3xx rules judge
  std::uint64_t alpha_zero = 0, alpha_full = 0;
  std::uint64_t zone_any = 0, zone_all = 0;  // a channel of B (all of them) in the forbidden zone's codes
  std::uint64_t black = 0;                   // B all 0
  std::uint64_t metals = 0;                  // opaque, Y at or above the zone's upper limit
  std::uint64_t energy_over = 0, energy_far_over = 0;  // opaque; beyond the two limits of ETK201
  PixelBox energy_box;                                 // around them, in the picture
  std::array<int, 2> energy_at{};                      // codes of the worst channel, A and B
  std::array<int, 2> energy_place{};                   // x, y of its texel in the picture
  std::uint64_t energy_worst = 0;                      // its sum, where 1 is linear_one
  std::uint64_t gloss_zero = 0, gloss_full = 0;        // opaque
  std::uint64_t gloss_sum = 0, gloss_squares = 0, gloss_texels = 0;
  std::uint8_t gloss_least = 255, gloss_most = 0;
  // Texels with 8 < alpha < 247 that have a diffuse colour: their number, the number of those with max(RGB)
  // <= alpha + 1, and sums for a correlation. Black texels and metals are left out: black stays black,
  // whatever it is multiplied by.
  std::uint64_t middle = 0, middle_below = 0, sum_max = 0, sum_alpha = 0, sum_max2 = 0, sum_alpha2 = 0,
                sum_product = 0;

  void add(const ByteCounts& other);
};

/// Histograms and smoothness, of every row or of a sample of rows.
struct Detail {
  std::uint64_t texels = 0;  // of these rows
  std::uint64_t opaque = 0;
  bool every_row = false;
  std::array<Histogram, 4> a{}, b{};  // over opaque texels; a[3], b[3]: alpha and gloss
  // Pairs of neighbours in a row whose green codes of A (of B) differ by at most 1.
  std::uint64_t smooth_a = 0, smooth_b = 0;

  void add(const Detail& other);
};

/// The values of a picture's three colour channels that have codes up to 100, for ETK404.
struct DarkValues {
  std::uint64_t count = 0, in_comb = 0;  // in_comb: among comb_codes()
  int codes = 0;                         // distinct ones
};

/// Counts the dark values of `picture`, the histograms of a Detail. A code with more than a quarter of all of
/// them is left out, because it is a flat area, which tells nothing of how the values came about.
DarkValues dark_values(const std::array<Histogram, 4>& picture);

/// A metallic value between these is neither metal nor dielectric (ETK101, ETK113): glTF 2.0 and Filament ask
/// for values close to 0 or 1. Metals begin at `metal_from`.
inline constexpr double half_metal_above = 0.1, metal_from = 0.9;
/// The two limits as codes: the first above 25.5, and the first from 229.5 on.
inline constexpr std::uint8_t half_metal_first_code = 26, metal_first_code = 230;

/// Everything that the pass over the pixels has found in a tile.
struct TileEvidence {
  CheckTile tile;  // name, material, box; the whole picture when the target has no tiles
  bool whole = false;
  ByteCounts counts;
  Detail detail;
  std::vector<RegionKind> kinds;        // that were analysed
  std::vector<PlateauSummary> regions;  // one per kind
  std::uint64_t fringe = 0;             // hidden texels that ETK502 reports
  std::array<int, 2> fringe_place{};
  int fringe_worst = 0;
  std::uint64_t gutter_wrong = 0;  // texels of the gutter that ETK505 reports
  int gutter_worst = 0;
  std::array<int, 2> gutter_place{};
  std::array<double, 16> mip_bleed{};   // per level from 1: largest difference, linear or plain, 0..1
  std::array<std::uint64_t, 2> hash{};  // of the texels of A and B, for ETK507
  bool hashed = false;

  const PlateauSummary* region(RegionKind kind) const;
};

/// Wrong or unusual values of a float picture.
struct FloatFacts {
  std::uint64_t nan = 0, infinite = 0, negative = 0, above_one = 0;
  std::array<int, 2> nan_at{}, negative_at{}, above_at{};  // the first of each
  float most_negative = 0, largest = 0;
  std::array<float, 3> above_value{};  // of the largest
  double above_luminance = 0;          // Y of it
};

/// One table of a material file or spectrum, as read: rows in the order of the file, wavelengths in nm.
struct SpectralRows {
  std::string pointer;  // "/datasets/0"
  std::string id;
  std::vector<double> wavelength_nm, n, k, reflectance;  // the last three empty where there is no such column
  bool is_formula = false;
  double first_nm = 0, last_nm = 0;  // of a formula
  bool preferred = false;
  bool contradicts = false;  // the reader found one wavelength with two values
  bool flagged = false;      // the importer or the authors doubt it
  std::string doi, url, via, licence, sample;
};

/// A material file or spectrum.
struct MaterialEvidence {
  std::string name, material_class;
  std::vector<SpectralRows> datasets;
  std::string schema_error;  // what the strict reader has to say; empty: nothing
  std::string schema_pointer;
  std::optional<std::array<double, 3>> stored_f0;  // linear sRGB
  std::optional<std::array<int, 3>> stored_bytes;
  std::optional<std::array<double, 3>> computed_f0;  // of the preferred dataset
  std::optional<std::array<int, 3>> computed_bytes;
  std::optional<double> luminance;
  // Reflectance at 550 nm by dataset; flagged datasets are left out.
  std::vector<std::pair<std::string, double>> at_550;
  bool is_material_file = true;  // citations are expected
};

/// Codes of a picture of a set of single files. Of roughness, metallic and the like at most 256 evenly spread rows are
/// counted; of colours 64 rows of 256 texels at most, and only whether they are normals.
///   codes      of the first three channels
///   coloured   texels that are not grey (other_content.h)
struct DataCodes {
  std::array<Histogram, 3> codes{};
  std::uint64_t texels = 0, coloured = 0;
  NormalSums normals;

  /// Share of a channel's texels with first <= code <= last, 0 to 1.
  double share(std::size_t channel, int first, int last) const;
};

/// One opened picture.
///   channels   what R, G, B and A hold, a letter for each (channel_word of names.h); empty: the usual of the role
struct PictureEvidence {
  PictureHeader header;
  std::string label;
  FileRole role = FileRole::specular_gloss;
  std::optional<FloatFacts> floats;
  std::string channels = {};
  std::optional<DataCodes> data = {};
};

/// A picture file whose values were looked at as they are, or as a tile.
///   narrow   of 16 bits, and all values are those of 8; not of one value alone
///   steps    where it is laid beside itself; none: not asked for, or it is not laid so
struct PictureLook {
  std::string label;
  FileRole role = FileRole::base_color;
  bool narrow = false;
  std::optional<EdgeSteps> steps;
};

/// The texels of a texture for a unit of the scene's world, on the whole: the root of its texels over the area that they
/// cover, of all triangles of a material.
struct TextureDensity {
  std::string material, label;
  FileRole role = FileRole::base_color;
  double texels = 0;
};

/// The pictures that the materials of a scene read, each once.
///   gpu_bytes   with all mips and without block compression (texture_bytes.h)
///   densities   of each material's textures whose triangles have an area
struct SceneFacts {
  std::size_t textures = 0;
  std::uint64_t gpu_bytes = 0;
  std::vector<TextureDensity> densities;
};

/// Everything that the rules judge of one target.
struct Evidence {
  std::optional<PictureEvidence> a, b;  // a metal-rough set: base colour and metal-rough
  bool metal_rough = false;
  std::vector<TileEvidence> tiles;
  std::vector<PictureEvidence> headers;  // every picture file of the target, for the rules on headers
  std::vector<MapEvidence> maps;
  std::vector<PictureLook> looks;
  std::vector<BlockLoss> losses;  // of textures in blocks that the pictures they were made of lie beside
  std::optional<MaterialEvidence> material;
  std::vector<DocumentSurface> surfaces;
  std::optional<SceneFacts> scene;      // where a limit asks for it
  std::vector<std::string> unreadable;  // "LABEL: message"
};

}  // namespace etak
