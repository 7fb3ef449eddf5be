// SPDX-License-Identifier: Apache-2.0
#include "core/render/environment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/once.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/math/functions.h"
#include "core/render/ambient/lat_long.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/ambient/prefilter.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr int level_count = lobe_levels;
// Prefiltering reads a map of at most this many columns: finer detail is smaller than the narrowest lobe
// (e = 4096, about 5 degrees wide).
constexpr int prefilter_width = 512;
constexpr double widest_lobe_map = 256;
// The widths of the map that quick prefiltering reads, and of the picture of a studio that is prefiltered so.
constexpr int quick_width = 128, quick_studio_width = 256;
constexpr int studio_width = 1024;
constexpr double widest_quick_map = 64;

// A map of width x width/2 pixels whose values are value(direction).
template <class Value>
Image filled(int width, unsigned threads, Value value) {
  Image out(width, width / 2, 3);
  parallel_chunks(static_cast<std::size_t>(out.height), threads, 1,
                  [&](std::size_t row, std::size_t, unsigned) {
                    const int y = static_cast<int>(row);
                    const MapRow angles((y + 0.5) / out.height);
                    for (int x = 0; x < out.width; ++x) {
                      const Vec3 v = value(direction_at((x + 0.5) / out.width, angles));
                      for (std::size_t i = 0; i < 3; ++i) out.at(x, y)[i] = static_cast<float>(v[i]);
                    }
                  });
  return out;
}

}  // namespace

struct Environment::Refined {
  Once once;
  LightSamples light;
};

Environment::Environment(const Image& lat_long, double scale, const std::string& what, unsigned threads,
                         Prefilter prefilter, bool levels) {
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
  quick_ = prefilter == Prefilter::quick;
  const Image seen = at_most(map_, quick_ ? quick_width : prefilter_width);
  irradiance_ = irradiance_of(seen, threads);
  if (levels) make_levels(seen, threads);
  refined_ = std::make_shared<std::array<Refined, 2>>();

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

void Environment::make_levels(const Image& seen, unsigned threads) {
  for (int i = 0; i < level_count; ++i) {
    const double gloss = gloss_of_level(i);
    levels_.push_back({gloss, lobe_map(seen, gloss, quick_ ? widest_quick_map : widest_lobe_map, threads,
                                       prefilter_width)});
  }
  std::vector<const Image*> maps;
  for (const Level& level : levels_) maps.push_back(&level.map);
  stack_ = stacked(maps, level_tile, threads);
}

Vec3 Environment::radiance(const Vec3& d) const {
  return look_up(map_, place_of(d));
}

Vec3 Environment::irradiance(const Vec3& n) const {
  return look_up(irradiance_, place_of(n));
}

Vec3 Environment::at_level(const Vec3& r, double level) const {
  return in_stack(stack_, level_tile, r, level);
}

const LightSamples& Environment::samples(bool bright_apart, unsigned threads) const {
  Refined& out = (*refined_)[bright_apart ? 1 : 0];
  out.once.call([&] { out.light = light_samples(map_, bright_apart, threads); });
  return out.light;
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
  const double top = math::cos(pi * double(row) / map_.height),
               bottom = math::cos(pi * double(row + 1) / map_.height);
  const double y = top + (bottom - top) * std::clamp(in_row, 0.0, 1.0);
  const double phi = 2 * pi * ((double(column) + std::clamp(in_column, 0.0, 1.0)) / map_.width - 0.5);
  const double sine = std::sqrt(std::max(0.0, (1 - y) * (1 + y)));
  return {sine * math::sin(phi), y, -sine * math::cos(phi)};
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
  cos_ = math::cos(degrees * (pi / 180));
  sin_ = math::sin(degrees * (pi / 180));
}

Image environment_picture(const Studio& studio, int width, unsigned threads) {
  return filled(width, threads, [&](const Vec3& d) { return etak::radiance(studio, d); });
}

namespace {

// The environments of the studios that somebody holds, and the one of the standard light.
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

std::shared_ptr<const Environment> studio_above_ground(const std::string& name, double scale,
                                                       unsigned threads, Environment::Prefilter prefilter) {
  const int width = prefilter == Environment::Prefilter::quick ? quick_studio_width : studio_width;
  return std::make_shared<const Environment>(environment_picture(studio_named(name), width, threads), scale,
                                             name, threads, prefilter, false);
}

std::shared_ptr<const Environment> studio_environment(const std::string& name, double scale,
                                                      unsigned threads) {
  const Studio& studio = studio_named(name);
  static std::mutex making;
  // Whoever asks for the same one meanwhile gets this one.
  const std::lock_guard one_at_a_time(making);
  if (auto out = known_studio_environment(name, scale)) return out;
  const auto out = std::make_shared<const Environment>(environment_picture(studio, studio_width, threads),
                                                       scale, name, threads);
  KnownEnvironments& known = known_environments();
  const std::lock_guard lock(known.guard);
  known.made[{name, scale}] = out;
  const LightSetup standard = studio_lights();
  if (name == standard.environment && scale == standard.environment_scale) known.standard = out;
  return out;
}

}  // namespace etak
