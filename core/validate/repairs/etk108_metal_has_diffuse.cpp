// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/color/luminance.h"
#include "core/judge/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

constexpr int soft_edge = 4;          // texels, as far as an edge between metal and other surfaces reaches
constexpr double least_other = 0.02;  // F0 of what is no metal: water
constexpr double all_metal = 0.97;    // share of metal from which noise is what remains

double luminance_at(const Image8& specular, std::size_t i, const CodeTables& tables) {
  const std::uint8_t* texel = specular.values.data() + i * static_cast<std::size_t>(specular.channels);
  if (specular.channels < 3) return tables.decoded[texel[0]];
  return luminance_of(
      std::array<double, 3>{tables.decoded[texel[0]], tables.decoded[texel[1]], tables.decoded[texel[2]]});
}

// Darkens the diffuse colour of the texels around a region of metal by their share of metal, which F0 tells: it is a
// mixture of that of the metal and that of the surface beside it, and so is what filtering makes of a mask.
void darken_edge(RepairPicture& a, const RepairRegion& region, const Image8& specular,
                 std::vector<char>& done, TextureTransfer transfer) {
  const CodeTables& tables = code_tables(transfer);
  const double metal = luminance_of(region.linear);
  const int width = specular.width, height = specular.height;
  const auto around = [&](std::size_t i, const auto& use) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    for (int v = std::max(0, y - soft_edge); v <= std::min(height - 1, y + soft_edge); ++v)
      for (int u = std::max(0, x - soft_edge); u <= std::min(width - 1, x + soft_edge); ++u)
        use(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u));
  };
  std::vector<std::size_t> edge;
  for (const std::size_t i : region.texels)
    around(i, [&](std::size_t at) {
      if (done[at] == 0) edge.push_back(at), done[at] = 1;
    });
  for (const std::size_t i : edge) {
    double other = 1;
    around(i, [&](std::size_t at) { other = std::min(other, luminance_at(specular, at, tables)); });
    other = std::max(other, least_other);
    if (metal <= other) continue;
    const double share = (luminance_at(specular, i, tables) - other) / (metal - other);
    const double left = share > all_metal ? 0 : 1 - std::clamp(share, 0.0, 1.0);
    const auto texel = a.texel(i);
    for (std::size_t c = 0; c < a.colour_channels(); ++c)
      texel[c] = a.code(encode_of(transfer, left * decode_of(transfer, a.value(texel[c]))));
  }
}

RepairOutcome blacken_metal(const RepairBench& bench) {
  RepairPicture* a = bench.with_role({FileRole::diffuse_alpha});
  if (a == nullptr) return {"", "diffuse is in no file of its own"};
  const Image8 marks = bench.marks(RegionKind::metal_with_diffuse);
  if (const std::string why = wrong_size(*a, marks); !why.empty()) return {"", why};
  const std::vector<RepairRegion> regions = regions_to_repair(bench, marks, bench.seen().b);
  std::vector<char> done(marks.values.size(), 0);
  for (const RepairRegion& region : regions)
    for (const std::size_t i : region.texels) {
      for (std::size_t c = 0; c < a->colour_channels(); ++c) a->texel(i)[c] = 0;
      done[i] = 1;
    }
  for (const RepairRegion& region : regions)
    darken_edge(*a, region, bench.seen().b, done, bench.settings.transfer);
  return {"made diffuse black under metal"};
}

}  // namespace

constinit const Repair repair_etk108{"ETK108", &blacken_metal};

}  // namespace etak
