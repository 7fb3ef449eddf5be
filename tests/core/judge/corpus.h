// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/random.h"
#include "core/image/image.h"
#include "core/judge/check_pictures.h"

/// Made-up texture sets with known properties, for tests and benchmarks. Everything follows from the seed.
namespace etak::test {

/// splitmix64: the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : numbers_(seed) {}
  std::uint64_t next() { return numbers_.next(); }
  double unit() { return numbers_.uniform(); }  // [0, 1)
  int below(int count);                         // 0 .. count - 1
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  SplitMix numbers_;
};

inline std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

inline void set_rgb(std::span<std::uint8_t> texel, std::array<int, 3> codes) {
  for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(codes[c]);
}

template <class Act>
void each_texel(Image8& image, Act act) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) act(image.at(x, y), x, y);
}

/// A texture pair, and the metallic channel of a metal-rough set (else 0 x 0).
struct TextureSet {
  Image8 a, b, metallic;
  Manifest manifest;
  Pixels<float> b_floats = {};  // in place of b: a float file's values, linear
};

/// Findings of the rules on a set.
CheckedFile check_set(const TextureSet& set, const Settings& settings = {}, unsigned threads = 1);
bool found(const CheckedFile& file, std::string_view rule, Severity at_least = Severity::info);
std::size_t errors(const CheckedFile& file);

/// One colour all over: F0 and diffuse as codes, gloss and diffuse with a little noise so that nothing else
/// is remarkable.
TextureSet flat_set(int size, std::array<int, 3> specular, std::array<int, 3> diffuse,
                    std::uint64_t seed = 1);

/// Share of a metal in each texel, 0..1: random blobs, drawn at twice the size and averaged (2x2
/// anti-aliasing), then blurred with a Gaussian.
Pixels<float> blob_mask(int size, double sigma, std::uint64_t seed);

enum class Blend { linear, encoded };
/// Grey F0 `low` and `high` mixed by a mask.
TextureSet blended_set(const Pixels<float>& mask, double low, double high, Blend blend);

/// Where the mask is 0 furthest around: the middle of the largest square without metal.
std::array<int, 2> emptiest_place(const Pixels<float>& mask);

/// An ordinary, right set of one to four materials (dielectrics, and metals of the library) with noise and
/// soft edges.
TextureSet natural_set(int size, std::uint64_t seed);

/// One defect.
struct Mutation {
  std::string_view rule;
  std::string_view what;
  std::function<void(TextureSet&, Random&)> inject;
  int least_size = 0;  // of the set, where the rule asks for many texels
  std::function<bool(const TextureSet&)> applies =
      nullptr;                         // whether the set can have the defect; null: all can
  std::optional<Severity> least = {};  // of the finding; none: a warning, a hint where the rule is one
};
const std::vector<Mutation>& mutations();       // of texels alone
const std::vector<Mutation>& mutations_told();  // of texels against what a layout, or the file, says of them

/// How often the defect that each pixel rule is to find was found, and what came up without one.
struct RuleScore {
  std::string rule;
  std::size_t injected = 0, found = 0;
  std::size_t false_sets = 0;  // untouched sets with a finding of the rule at warning or above
  std::size_t hints = 0;       // untouched sets with a hint of the rule
};
struct Scores {
  std::vector<RuleScore> rules;
  std::size_t untouched = 0, untouched_errors = 0, untouched_warnings = 0;
  std::vector<std::string> missed;  // "ETK101 in set 17"
};

/// Draws every defect into every set. A rule that is off by default is on for its defect; one that finds the
/// like in the untouched set already is left out there.
///   larger   the set again with more texels, for defects that need them; none: the defect is left out
Scores score_mutations(const std::vector<TextureSet>& sets,
                       const std::function<TextureSet(std::size_t, int)>& larger);

/// Over `count` natural sets of a size.
Scores score_natural_sets(std::size_t count, int size);

}  // namespace etak::test
