// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "core/color/srgb.h"
#include "core/image/image.h"
#include "core/validate/repairs/repair_files.h"
#include "tests/core/judge/corpus.h"

/// Right sets, the same sets with a defect, and the repaired copies of a folder.
namespace etak::test {

constexpr int set_edge = 128;

using PictureCodes = std::variant<Image8, Image16>;
using NamedPictures = std::map<std::string, PictureCodes>;  // by file name

/// A linear or plain value as a code of the picture's depth.
template <class Value>
Value coded(double value) {
  const double full = sizeof(Value) == 1 ? 255 : 65535;
  return static_cast<Value>(std::lround(full * std::clamp(value, 0.0, 1.0)));
}

/// A square with another F0 inside of a picture.
struct Patch {
  int x = 40, y = 50, size = 30;
  bool holds(int column, int row) const {
    return column >= x && column < x + size && row >= y && row < y + size;
  }
};

/// F0 of a dielectric with a gentle variation, so that plateaus hold more than one code; gloss is noise.
template <class Value>
Pixels<Value> varied_f0(Random& random, double f0, double spread) {
  Pixels<Value> out(set_edge, set_edge, 4);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const double wave = spread * std::sin(x / 23.0) * std::cos(y / 31.0);
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = coded<Value>(srgb_encode(f0 + wave));
      out.at(x, y)[3] = coded<Value>(random.between(0.3, 0.7));
    }
  return out;
}

Image8 noisy_diffuse(Random& random);

/// Unit normals of a wavy surface, whose slopes reach 0.8 times `steep`.
template <class Value>
Pixels<Value> wavy_normals(Random& random, double steep = 1) {
  const double p = random.between(0, 6), q = random.between(0, 6);
  Pixels<Value> out(set_edge, set_edge, 3);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const double u = steep * (0.6 * std::sin(x / 9.0 + p) + 0.2 * std::sin(y / 5.0)),
                   v = steep * 0.6 * std::cos(y / 11.0 + q);
      const double length = std::sqrt(u * u + v * v + 1);
      const std::array<double, 3> n{u / length, v / length, 1 / length};
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = coded<Value>((n[c] + 1) / 2);
    }
  return out;
}

template <class Value, class Curve>
void put_through(Pixels<Value>& image, const Curve& curve) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const double full = sizeof(Value) == 1 ? 255 : 65535;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (i % channels < 3) image.values[i] = coded<Value>(curve(image.values[i] / full));
}

struct Planted {
  NamedPictures right, wrong;
  std::string repaired;       // the file that the defect is in
  std::string material = {};  // that the set is said to be of
  std::string rule;
};

template <class Value>
Planted curve_of_normals(Random& random, double (*curve)(double), double steep = 1) {
  auto map = wavy_normals<Value>(random, steep);
  Planted out;
  out.rule = "ETK704";
  out.repaired = "crate_normal.png";
  out.right = {{"crate_normal.png", map}};
  put_through(map, curve);
  out.wrong = {{"crate_normal.png", map}};
  return out;
}

/// A patch of a right set that went through the curve once more.
Planted doubled_patch(Random& random);

struct RepairedFolder {
  RepairReport report;
  ValidationReport before, after;  // of the originals and of the copies
};

/// Checks `from`, repairs it into the new folder `to`, and checks that.
///   material   that the sets are said to be of; may be empty
RepairedFolder repair_folder(const std::string& from, const std::string& to,
                             const std::string& material = {});
std::string file_of_codes(const PictureCodes& codes);
void put_pictures(const std::string& folder, const NamedPictures& pictures);
PictureCodes loaded_codes(const std::string& path);
bool has_rule(const ValidationReport& report, const std::string& rule);

}  // namespace etak::test
