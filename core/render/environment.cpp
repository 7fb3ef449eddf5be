// SPDX-License-Identifier: Apache-2.0
#include "core/render/environment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/base/clones.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // not all functions of the text are used
namespace ambient_text {
#include "core/math/real_f64.h"

#include "core/light/ambient.glsl"
}  // namespace ambient_text
#pragma GCC diagnostic pop

using std::numbers::pi;
constexpr int level_count = lobe_levels;
// Prefiltering reads a map of at most this many columns: finer detail is smaller than the narrowest lobe
// (e = 4096, about 5 degrees wide).
constexpr int prefilter_width = 512;
constexpr double widest_lobe_map = 256;
// Of quick prefiltering, and of the picture of a studio that is prefiltered so.
constexpr int quick_width = 128, quick_studio_width = 256;
constexpr double widest_quick_map = 64;

double luminance_at(const Image& map, int x, int y) {
  const float* rgb = map.at(x, y).data();
  return luminance_of<double>(rgb[0], rgb[1], rgb[2]);
}

Vec3 direction_at(double u, double v) {
  const double phi = 2 * pi * (u - 0.5), theta = pi * v;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

struct MapPlace {
  double u, v;
};
MapPlace place_of(const Vec3& d) {
  // Both angles are computed by atan2, because acos loses digits towards the poles.
  return {0.5 + std::atan2(d[0], -d[2]) / (2 * pi),
          std::atan2(std::sqrt(d[0] * d[0] + d[2] * d[2]), d[1]) / pi};
}

// The bilinear value at a place. Columns wrap around; rows end at the poles.
Vec3 look_up(const Image& map, const MapPlace& place) {
  const double x = place.u * map.width - 0.5,
               y = std::clamp(place.v * map.height - 0.5, 0.0, map.height - 1.0);
  const double column = std::floor(x), row = std::floor(y);
  const double fx = x - column, fy = y - row;
  const auto wrap = [&](int i) { return i < 0 ? i + map.width : i >= map.width ? i - map.width : i; };
  const int x0 = wrap(static_cast<int>(column)), x1 = wrap(static_cast<int>(column) + 1);
  const int y0 = static_cast<int>(row), y1 = std::min(y0 + 1, map.height - 1);
  const auto a = map.at(x0, y0), b = map.at(x1, y0), c = map.at(x0, y1), d = map.at(x1, y1);
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = (double{a[i]} * (1 - fx) + double{b[i]} * fx) * (1 - fy) +
             (double{c[i]} * (1 - fx) + double{d[i]} * fx) * fy;
  return out;
}

// The solid angle of a pixel in `row` of a map, in sr.
double solid_angle(const Image& map, int row) {
  const double top = std::cos(pi * row / map.height), bottom = std::cos(pi * (row + 1) / map.height);
  return 2 * pi / map.width * (top - bottom);
}

Image at_most(const Image& map, int width) {
  return map.width <= width ? map : shrunk(map, width, std::min(map.height, width / 2));
}

// A map of width x width/2 pixels whose values are value(direction).
template <class Value>
Image filled(int width, unsigned threads, Value value) {
  Image out(width, width / 2, 3);
  parallel_chunks(static_cast<std::size_t>(out.height), threads, 1,
                  [&](std::size_t row, std::size_t, unsigned) {
                    const int y = static_cast<int>(row);
                    for (int x = 0; x < out.width; ++x) {
                      const Vec3 v = value(direction_at((x + 0.5) / out.width, (y + 0.5) / out.height));
                      for (std::size_t i = 0; i < 3; ++i) out.at(x, y)[i] = static_cast<float>(v[i]);
                    }
                  });
  return out;
}

// Adds `from`, times a weight. Without fused operations, so that all instruction sets give the same sums.
ETAK_CLONES_O3("avx2")
void add_weighted(double* to, const float* from, double weight, int count) {
  for (int i = 0; i < count; ++i) to[i] += weight * double{from[i]};
}

// The rows of a map, so that a sum over neighbouring columns can be made for many places at once. Of the columns
// every `stride`-th lies in one run, and each run stands three times, because columns wrap around.
class Runs {
 public:
  Runs(const Image& map, int stride) : count_(map.width / stride), stride_(stride), rows_(map.height) {
    values_.reserve(map.values.size() * 3);
    for (std::size_t channel = 0; channel < 3; ++channel)
      for (int y = 0; y < map.height; ++y)
        for (int first = 0; first < stride; ++first)
          for (int i = 0; i < 3 * count_; ++i)
            values_.push_back(map.at(first + i % count_ * stride, y)[channel]);
  }
  // The columns column, column + stride, ... of a row, as many as a run has.
  const float* from(std::size_t channel, int y, int column) const {
    const int before = column < 0 ? (column + 1) / stride_ - 1 : column / stride_;
    const int run = (static_cast<int>(channel) * rows_ + y) * stride_ + column - before * stride_;
    return values_.data() + static_cast<std::ptrdiff_t>(run) * 3 * count_ + count_ + before;
  }

 private:
  int count_, stride_, rows_;
  std::vector<float> values_;
};

// A map of width x width/2 pixels: for each of its directions r the sums S of weight(c) radiance d_omega and T of
// weight(c) d_omega, over the pixels of `seen` whose cosine c with r is above `least`, as finish(r, S, T).
//
// The cosine depends on both rows and on the difference of the columns alone. So a weight is computed once for
// all pixels of a row of the result that lie alike between the columns of `seen`, and not once for each of them.
template <class Weight, class Finish>
Image summed(const Image& seen, int width, double least, unsigned threads, Weight weight, Finish finish) {
  Image out(width, width / 2, 3);
  // Pixels i * phases + p of a row lie alike for all i below `alike`.
  const int alike = std::gcd(width, seen.width), phases = width / alike, stride = seen.width / alike;
  const Runs runs(seen, stride);
  const double reach = std::acos(std::clamp(least, -1.0, 1.0));
  const auto row_of = [&](int row) {
    const double v = (row + 0.5) / out.height, sine = std::sin(pi * v), cosine = std::cos(pi * v);
    std::array<std::vector<double>, 3> sums;
    for (auto& each : sums) each.resize(static_cast<std::size_t>(width));
    std::vector<double> totals(static_cast<std::size_t>(phases));
    const double middle = v * seen.height, rows = reach / pi * seen.height;
    const int first_row = std::max(0, static_cast<int>(std::floor(middle - rows)) - 1);
    const int last_row = std::min(seen.height, static_cast<int>(std::ceil(middle + rows)) + 1);
    for (int y = first_row; y < last_row; ++y) {
      const double theta = pi * (y + 0.5) / seen.height, omega = solid_angle(seen, y);
      const double across = sine * std::sin(theta), along = cosine * std::cos(theta);
      // Columns whose cosine may be above `least`: those with cos(difference) above (least - along) / across.
      if (across + along <= least) continue;
      const double side = std::acos(std::clamp((least - along) / std::max(across, 1e-300), -1.0, 1.0));
      const int half = std::min(seen.width / 2, static_cast<int>(side / (2 * pi) * seen.width) + 2);
      const int columns = std::min(seen.width, 2 * half + 1);
      for (int p = 0; p < phases; ++p) {
        const double place = (p + 0.5) * seen.width / width;
        const int nearest = static_cast<int>(std::floor(place));
        for (int k = nearest - half; k < nearest - half + columns; ++k) {
          const double c = across * std::cos(2 * pi * (k + 0.5 - place) / seen.width) + along;
          if (c <= least) continue;
          const double w = weight(c) * omega;
          totals[static_cast<std::size_t>(p)] += w;
          for (std::size_t channel = 0; channel < 3; ++channel)
            add_weighted(sums[channel].data() + p * alike, runs.from(channel, y, k), w, alike);
        }
      }
    }
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(x % phases * alike + x / phases);
      const Vec3 sum{sums[0][at], sums[1][at], sums[2][at]};
      const Vec3 value =
          finish(direction_at((x + 0.5) / width, v), sum, totals[static_cast<std::size_t>(x % phases)]);
      for (std::size_t i = 0; i < 3; ++i) out.at(x, row)[i] = static_cast<float>(value[i]);
    }
  };
  parallel_chunks(static_cast<std::size_t>(out.height), threads, 1,
                  [&](std::size_t row, std::size_t, unsigned) { row_of(static_cast<int>(row)); });
  return out;
}

// round_lobe() as a table over the cosines that matter, linear between 2048 steps.
class LobeWeight {
 public:
  explicit LobeWeight(double e) : least_(std::max(0.0, 2 * std::exp2(std::log2(1e-4) * 2 / e) - 1)) {
    for (int i = 0; i <= steps; ++i) {
      const double c = least_ + (1 - least_) * i / steps;
      values_.push_back(round_lobe(e, c));
    }
    values_.push_back(values_.back());
  }
  double least() const { return least_; }  // the lobe is below 1e-4 of its peak beneath this cosine
  double at(double c) const {
    const double at = std::min((c - least_) / (1 - least_), 1.0) * steps;
    const auto i = static_cast<std::size_t>(at);
    return values_[i] + (values_[i + 1] - values_[i]) * (at - static_cast<double>(i));
  }

 private:
  static constexpr int steps = 2048;
  double least_;
  std::vector<double> values_;
};

//   widest   columns of the result at most, a power of 2
Image lobe_map(const Image& map, double gloss, double widest, unsigned threads) {
  const double e = exponent_of_gloss(gloss);
  // A pixel of the result spans half the width of the lobe, and a pixel of the summed map spans about a quarter:
  // so that it has once or twice as many columns as the result, which summed() is quick with.
  const double wanted = std::clamp(6.3 * std::sqrt(e), 32.0, widest);
  const int width = 1 << static_cast<int>(std::ceil(std::log2(wanted)));
  const int times = static_cast<int>(std::ceil(2 * wanted / width - 0.25));
  const Image seen = at_most(map, std::min(times * width, prefilter_width));
  const LobeWeight weight(e);
  return summed(
      seen, width, weight.least(), threads, [&](double c) { return weight.at(c); },
      [&](const Vec3& r, const Vec3& sum, double total) {
        // Between the pixels of a map that is coarser than the lobe there may be none within it.
        if (total == 0) return look_up(seen, place_of(r));
        return Vec3{sum[0] / total, sum[1] / total, sum[2] / total};
      });
}

// All levels below each other, as octahedral maps.
Image stacked(const std::vector<Environment::Level>& levels, unsigned threads) {
  constexpr int tile = Environment::level_tile, inner = tile - 2;
  Image out(tile, tile * level_count, 3);
  parallel_chunks(
      static_cast<std::size_t>(out.height), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
          const Image& map = levels[static_cast<std::size_t>(row / tile)].map;
          for (int x = 0; x < tile; ++x) {
            const auto d = ambient_text::octahedral_direction((x - 0.5) / inner, (row % tile - 0.5) / inner);
            const Vec3 v = look_up(map, place_of({d.x, d.y, d.z}));
            for (std::size_t c = 0; c < 3; ++c) out.at(x, row)[c] = static_cast<float>(v[c]);
          }
        }
      });
  return out;
}

}  // namespace

Environment::Environment(const Image& lat_long, double scale, const std::string& what, unsigned threads,
                         Prefilter prefilter) {
  if (lat_long.channels < 3)
    throw Error::at(what, std::to_string(lat_long.channels) + " channels",
                    "an environment of red, green and blue");
  if (lat_long.width < 2 || lat_long.height < 2 || lat_long.width > 8192 || lat_long.height > 4096)
    throw Error::at(what,
                    std::to_string(lat_long.width) + " x " + std::to_string(lat_long.height) + " pixels",
                    "an environment of 2 x 2 to 8192 x 4096");
  if (!(scale >= 0) || !std::isfinite(scale))
    throw Error::at(what, "scale " + number(scale, 6), "a factor of at least 0");
  map_ = Image(lat_long.width, lat_long.height, 3);
  for (int y = 0; y < map_.height; ++y)
    for (int x = 0; x < map_.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = lat_long.at(x, y)[c] * static_cast<float>(scale);
        if (!(value >= 0) || !std::isfinite(value))
          throw Error::at(what,
                          "radiance " + number(double{value}, 6) + " at column " + std::to_string(x) +
                              ", row " + std::to_string(y),
                          "finite numbers of at least 0");
        map_.at(x, y)[c] = value;
      }

  if (map_.width > sharpest_width) smaller_map_ = at_most(map_, sharpest_width);
  const bool quick = prefilter == Prefilter::quick;
  const Image seen = at_most(map_, quick ? quick_width : prefilter_width);
  irradiance_ = summed(
      at_most(seen, 128), 64, 0, threads, [](double c) { return c; },
      [](const Vec3&, const Vec3& sum, double) { return sum; });
  for (int i = 0; i < level_count; ++i) {
    const double gloss = gloss_of_level(i);
    levels_.push_back({gloss, lobe_map(seen, gloss, quick ? widest_quick_map : widest_lobe_map, threads)});
  }
  stack_ = stacked(levels_, threads);

  // Every pixel gets a little of the mean as weight, because bilinear look-up finds light in black pixels
  // beside bright ones.
  double mean = 0, most = 0;
  for (int y = 0; y < map_.height; ++y)
    for (int x = 0; x < map_.width; ++x) {
      most = std::max(most, luminance_at(map_, x, y));
      mean += luminance_at(map_, x, y) * solid_angle(map_, y) / (4 * pi);
    }
  if (mean > 0) contrast_ = most / mean;
  const double floor = mean > 0 ? 0.01 * mean : 1;
  double total = 0;
  for (int y = 0; y < map_.height; ++y) {
    double row = 0;
    for (int x = 0; x < map_.width; ++x) column_sums_.push_back(row += luminance_at(map_, x, y) + floor);
    for (int x = 0; x < map_.width; ++x)
      column_sums_[column_sums_.size() - 1 - static_cast<std::size_t>(x)] /= row;
    row_sums_.push_back(total += row * solid_angle(map_, y));
  }
  for (double& sum : row_sums_) sum /= total;
}

Vec3 Environment::radiance(const Vec3& d) const {
  return look_up(map_, place_of(d));
}

Vec3 Environment::irradiance(const Vec3& n) const {
  return look_up(irradiance_, place_of(n));
}

Vec3 Environment::at_level(const Vec3& r, double level) const {
  const auto first = std::min(static_cast<int>(std::max(level, 0.0)), level_count - 2);
  const double share = std::clamp(level - first, 0.0, 1.0);
  const ambient_text::vec3 place = ambient_text::octahedral_place({r[0], r[1], r[2]});
  // As look_up(), of two levels at once.
  const double x = place.x * (level_tile - 2) + 0.5, y = place.y * (level_tile - 2) + 0.5;
  const int x0 = std::clamp(static_cast<int>(x), 0, level_tile - 2),
            y0 = std::clamp(static_cast<int>(y), 0, level_tile - 2);
  const double fx = x - x0, fy = y - y0;
  Vec3 out{};
  for (int i = 0; i < 2; ++i) {
    const double weight = i == 0 ? 1 - share : share;
    const int top = (first + i) * level_tile + y0;
    const auto a = stack_.at(x0, top), b = stack_.at(x0 + 1, top), c = stack_.at(x0, top + 1),
               d = stack_.at(x0 + 1, top + 1);
    for (std::size_t k = 0; k < 3; ++k)
      out[k] += weight * ((double{a[k]} * (1 - fx) + double{b[k]} * fx) * (1 - fy) +
                          (double{c[k]} * (1 - fx) + double{d[k]} * fx) * fy);
  }
  return out;
}

Vec3 Environment::specular(const Vec3& r, double gloss) const {
  return at_level(r, level_of_gloss(std::clamp(gloss, 0.0, 1.0)));
}

Environment::Blurred Environment::blurred(double blur) const {
  const Image& picture = smaller_map_.values.empty() ? map_ : smaller_map_;
  const double at = std::clamp(blur, 0.0, 1.0) * level_count;
  const auto first = std::min(static_cast<std::size_t>(at), levels_.size() - 1);
  return {first == 0 ? &picture : &levels_[first - 1].map, &levels_[first].map,
          at - static_cast<double>(first)};
}

Vec3 Environment::Blurred::at(const Vec3& d) const {
  const MapPlace place = place_of(d);
  const Vec3 a = look_up(*sharp, place), b = look_up(*dull, place);
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = a[i] * (1 - share) + b[i] * share;
  return out;
}

Vec3 Environment::sample(double u, double v) const {
  const auto row = std::upper_bound(row_sums_.begin(), row_sums_.end() - 1, v) - row_sums_.begin();
  const double row_before = row == 0 ? 0 : row_sums_[static_cast<std::size_t>(row - 1)];
  const double in_row = (v - row_before) / (row_sums_[static_cast<std::size_t>(row)] - row_before);
  const auto begin = column_sums_.begin() + row * map_.width;
  const auto column = std::upper_bound(begin, begin + map_.width - 1, u) - begin;
  const double column_before = column == 0 ? 0 : begin[column - 1];
  const double in_column = (u - column_before) / (begin[column] - column_before);
  // Within a pixel, directions are spread evenly over the solid angle, that is linearly in the cosine.
  const double top = std::cos(pi * double(row) / map_.height),
               bottom = std::cos(pi * double(row + 1) / map_.height);
  const double y = top + (bottom - top) * std::clamp(in_row, 0.0, 1.0);
  const double phi = 2 * pi * ((double(column) + std::clamp(in_column, 0.0, 1.0)) / map_.width - 0.5);
  const double sine = std::sqrt(std::max(0.0, (1 - y) * (1 + y)));
  return {sine * std::sin(phi), y, -sine * std::cos(phi)};
}

double Environment::pdf(const Vec3& d) const {
  const MapPlace place = place_of(d);
  const int x = std::clamp(static_cast<int>(place.u * map_.width), 0, map_.width - 1);
  const int y = std::clamp(static_cast<int>(place.v * map_.height), 0, map_.height - 1);
  const auto row = static_cast<std::size_t>(y);
  const double in_row = row_sums_[row] - (row == 0 ? 0 : row_sums_[row - 1]);
  const auto at = row * static_cast<std::size_t>(map_.width) + static_cast<std::size_t>(x);
  const double in_column = column_sums_[at] - (x == 0 ? 0 : column_sums_[at - 1]);
  return in_row * in_column / solid_angle(map_, y);
}

EnvironmentTurn::EnvironmentTurn(double degrees) {
  // A turn of 0 is the exact identity, so that it does not change a scene by rounding.
  if (degrees == 0) return;
  cos_ = std::cos(degrees * (pi / 180));
  sin_ = std::sin(degrees * (pi / 180));
}

Image environment_picture(const Studio& studio, int width, unsigned threads) {
  return filled(width, threads, [&](const Vec3& d) { return etak::radiance(studio, d); });
}

namespace {

// Those of the studios that somebody holds, and the one of the standard light.
struct KnownEnvironments {
  std::mutex guard;
  std::map<std::pair<std::string, double>, std::weak_ptr<const Environment>> made;
  std::shared_ptr<const Environment> standard;
};
KnownEnvironments& known_environments() {
  static KnownEnvironments known;
  return known;
}

const Studio& studio_named(const std::string& name) {
  if (const Studio* found = find_studio(name)) return *found;
  throw Error::at(printable(name), "no studio", joined(named_studios(), ", ", &NamedStudio::name));
}

}  // namespace

std::shared_ptr<const Environment> known_studio_environment(const std::string& name, double scale) {
  KnownEnvironments& known = known_environments();
  const std::lock_guard lock(known.guard);
  const auto found = known.made.find({name, scale});
  return found == known.made.end() ? nullptr : found->second.lock();
}

std::shared_ptr<const Environment> quick_studio_environment(const std::string& name, double scale,
                                                            unsigned threads) {
  return std::make_shared<const Environment>(
      environment_picture(studio_named(name), quick_studio_width, threads), scale, name, threads,
      Environment::Prefilter::quick);
}

std::shared_ptr<const Environment> studio_environment(const std::string& name, double scale,
                                                      unsigned threads) {
  const Studio& studio = studio_named(name);
  static std::mutex making;
  // Whoever asks for the same one meanwhile gets this one.
  const std::lock_guard one_at_a_time(making);
  if (auto out = known_studio_environment(name, scale)) return out;
  const auto out =
      std::make_shared<const Environment>(environment_picture(studio, 1024, threads), scale, name, threads);
  KnownEnvironments& known = known_environments();
  const std::lock_guard lock(known.guard);
  known.made[{name, scale}] = out;
  const LightSetup standard = studio_lights();
  if (name == standard.environment && scale == standard.environment_scale) known.standard = out;
  return out;
}

}  // namespace etak
