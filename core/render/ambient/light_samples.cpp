// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/light_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/render/ambient/lat_long.h"
#include "core/render/ambient/lobe_samples.h"
#include "core/render/ambient/prefilter.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

constexpr int map_width = 1024, sharpest_width = 512;
// A texel is bright where its luminance is more than so many times the mean.
constexpr double bright_above = 4;

// The bright part of a map, as lights of equal luminance: places of a lattice in the integral of its luminance.
std::vector<LightSamples::Bright> bright_lights(const Image& bright) {
  std::vector<double> rows, columns;  // cumulated over the rows, and in each row over its columns
  double total = 0;
  for (int y = 0; y < bright.height; ++y) {
    double row = 0;
    for (int x = 0; x < bright.width; ++x)
      columns.push_back(row += luminance_at(bright, x, y) * solid_angle(bright, y));
    rows.push_back(total += row);
  }
  std::vector<LightSamples::Bright> out;
  for (int i = 0; total > 0 && i < bright_count; ++i) {
    const double turns = i / std::numbers::phi, wanted = total * (i + 0.5) / bright_count;
    const auto y = std::upper_bound(rows.begin(), rows.end() - 1, wanted) - rows.begin();
    const auto first = columns.begin() + y * bright.width;
    const double in_row = first[bright.width - 1] * (turns - std::floor(turns));
    const auto x = std::upper_bound(first, first + bright.width - 1, in_row) - first;
    const double above = y == 0 ? 0 : rows[std::size_t(y - 1)], before = x == 0 ? 0 : first[x - 1];
    const double down = (wanted - above) / (rows[std::size_t(y)] - above),
                 along = (in_row - before) / (first[x] - before);
    const auto rgb = bright.at(int(x), int(y));
    const double factor = total / bright_count / luminance_at(bright, int(x), int(y));
    out.push_back(
        {direction_at((double(x) + along) / bright.width, MapRow((double(y) + down) / bright.height)),
         scaled({rgb[0], rgb[1], rgb[2]}, factor)});
  }
  return out;
}

}  // namespace

LightSamples light_samples(const Image& lat_long, bool bright_apart, unsigned threads) {
  LightSamples out;
  Image seen = at_most(lat_long, map_width);
  if (bright_apart) {
    Image bright = seen;
    double mean = 0;
    for (int y = 0; y < seen.height; ++y)
      for (int x = 0; x < seen.width; ++x)
        mean += luminance_at(seen, x, y) * solid_angle(seen, y) / (4 * std::numbers::pi);
    const double most = bright_above * mean;
    for (int y = 0; y < seen.height; ++y)
      for (int x = 0; x < seen.width; ++x) {
        const double here = luminance_at(seen, x, y), share = here > most ? most / here : 1;
        for (std::size_t c = 0; c < 3; ++c) {
          const float all = seen.at(x, y)[c];
          seen.at(x, y)[c] = static_cast<float>(double{all} * share);
          bright.at(x, y)[c] = share < 1 ? all - seen.at(x, y)[c] : 0;
        }
      }
    out.bright = bright_lights(bright);
  }
  out.irradiance = irradiance_of(seen, threads);
  std::vector<Image> maps;
  for (double level = sharpest_sample; level <= dullest_sample; ++level)
    maps.push_back(lobe_map(seen, gloss_of_level(level), level < 0 ? sharpest_width : sharpest_width / 2,
                            threads, level < -1 ? map_width : map_width / 2));
  std::vector<const Image*> levels;
  for (const Image& map : maps) levels.push_back(&map);
  out.stack = stacked(levels, LightSamples::tile, threads);
  return out;
}

Vec3 LightSamples::irradiance_at(const Vec3& n) const {
  return look_up(irradiance, place_of(n));
}

}  // namespace etak
