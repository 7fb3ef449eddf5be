// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "core/judge/finding.h"

namespace etak {

class RuleCheck;

/// What a rule needs in order to judge. Pixels are read only where some rule needs them.
enum class Need : std::uint32_t {
  header = 1u << 0,       // size, channels, depth, declared colour space
  bytes_a = 1u << 1,      // codes of the diffuse + alpha picture
  bytes_b = 1u << 2,      // codes of the specular + gloss picture
  floats = 1u << 3,       // values of float files, before they become codes
  regions = 1u << 4,      // plateaus of one of the region kinds
  metal_rough = 1u << 5,  // the metallic channel of a metal-rough set
  layout = 1u << 6,       // tiles of an atlas
  scene = 1u << 7,        // a glTF document
  material = 1u << 8,     // material files and spectra
  named = 1u << 9,        // the name of the material
  maps = 1u << 10,        // normal, occlusion and emissive maps, which have a pass of their own
  wide = 1u << 11,        // the codes of pictures of 16 bits, as their files have them
  edges = 1u << 12,       // how pictures continue beside themselves, where a limit asks for it
  sources = 1u << 13,     // pictures that textures in blocks were made of
};

/// A set of needs.
class Needs {
 public:
  constexpr Needs() = default;
  constexpr Needs(std::initializer_list<Need> needs) {
    for (const Need need : needs) bits_ |= static_cast<std::uint32_t>(need);
  }
  constexpr bool has(Need need) const { return (bits_ & static_cast<std::uint32_t>(need)) != 0; }
  constexpr bool pixels() const {
    return has(Need::bytes_a) || has(Need::bytes_b) || has(Need::floats) || has(Need::metal_rough);
  }
  constexpr bool none() const { return bits_ == 0; }
  constexpr Needs& operator|=(Needs other) {
    bits_ |= other.bits_;
    return *this;
  }
  friend constexpr bool operator==(Needs, Needs) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// The conditions whose plateaus the region analysis finds (core/judge/pixels/regions.h).
enum class RegionKind : std::uint8_t {
  zone,                // ETK101: F0 in the forbidden zone
  f0_low,              // ETK103
  f0_zero,             // ETK104
  gem,                 // ETK105
  coloured,            // ETK106: dielectric F0 with a hue
  metal_with_diffuse,  // ETK108
  black_diffuse,       // ETK109
  any_f0,              // ETK111, ETK112, ETK401 to ETK403: every flat F0
  half_metal,          // ETK113
  dark_metal,          // ETK114
  blue_metal,          // ETK115: F0 of a metal, more blue than red
  albedo_dark,         // ETK202
  albedo_bright,       // ETK203
  albedo_single,       // ETK204
};

/// A number that a configuration may change: [rules] ETK202 = { min_byte = 50 }.
struct RuleParameter {
  std::string_view name;
  double value;         // of the default profile
  double strict_value;  // of the profiles strict and film
  std::string_view unit;
  std::string_view meaning;
};

/// The parameters of a rule, at most `most`.
class RuleParameters {
 public:
  static constexpr std::size_t most = 5;

  constexpr RuleParameters() = default;
  constexpr RuleParameters(std::initializer_list<RuleParameter> rows) : size_(rows.size()) {
    std::copy(rows.begin(), rows.end(), rows_.begin());
  }
  constexpr bool empty() const { return size_ == 0; }
  constexpr const RuleParameter* begin() const { return rows_.data(); }
  constexpr const RuleParameter* end() const { return rows_.data() + size_; }

 private:
  std::array<RuleParameter, most> rows_{};
  std::size_t size_ = 0;
};

/// The severity of a rule by the default profile, and by the profile strict where that differs.
struct RuleSeverity {
  Severity standard, strict;
  constexpr RuleSeverity(Severity both) : standard(both), strict(both) {}
  constexpr RuleSeverity(Severity of_default, Severity of_strict) : standard(of_default), strict(of_strict) {}
};

/// A row of the rule table: all that help, documentation, SARIF and editors show of a rule. Each rule stands
/// in a file of its own, core/judge/rules/etk###_slug.cpp; rules/rules.inc lists them.
struct Rule {
  std::string_view id;     // "ETK101"
  std::string_view slug;   // "f0-forbidden-zone"
  std::string_view title;  // "F0 lies where no common material is"
  RuleSeverity severity;
  Needs needs = {};
  RuleParameters parameters = {};
  std::string_view source;                // article, tool or measurement that the rule rests on
  std::string_view what;                  // what is reported, with its condition
  std::string_view why;                   // why it is a mistake
  std::string_view example;               // how the mistake comes about, in words
  std::string_view fix;                   // what to do
  std::optional<RegionKind> region = {};  // what a mask picture of its findings shows
  void (*check)(RuleCheck&) = nullptr;    // null: a rule of the tool itself (9xx)

  /// "Input", "Specular / F0", ... by the id's hundreds.
  std::string_view family() const;
};

}  // namespace etak
