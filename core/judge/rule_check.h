// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/color/luminance.h"
#include "core/judge/nearest.h"
#include "core/judge/pixels/evidence.h"
#include "core/judge/rules.h"
#include "core/judge/settings.h"

namespace etak {

/// A tile and its plateaus of one kind, at least one.
struct TilePlateaus {
  const TileEvidence& tile;
  const PlateauSummary& plateaus;
};

/// The argument of a rule's check: the evidence, the settings, and functions that report findings.
class RuleCheck {
 public:
  RuleCheck(const Rule& rule, const CheckTarget& target, const Settings& settings, const Evidence& evidence,
            const CodeTables& tables, std::vector<Finding>& findings);

  const CheckTarget& target;
  const Settings& settings;
  const Evidence& evidence;
  const CodeTables& tables;

  /// Value of a parameter of the rule.
  double parameter(std::string_view name) const;
  Severity severity() const { return severity_; }

  /// The rule's severity raised to at least (lowered to at most) this one; a severity that the configuration
  /// gives to the rule stays as it is.
  Severity at_least(Severity severity) const;
  Severity at_most(Severity severity) const;

  /// The datasets of a material file or spectrum; none for other targets.
  std::span<const SpectralRows> datasets() const;

  /// The tiles with plateaus of this kind.
  std::vector<TilePlateaus> regions(RegionKind kind) const;

  /// Adds a finding with the rule's facts filled in, about the whole target, a dataset, a picture, a map or a
  /// tile. The reference holds until the next finding is added.
  Finding& report();
  Finding& report(const SpectralRows& rows);
  Finding& report(const PictureEvidence& picture);
  Finding& report(const MapEvidence& map);
  Finding& report(const TileEvidence& tile, FileRole role);

  /// Adds a finding about plateaus, with the box around all of them, their whole area, and the F0 of the one
  /// that is shown, or the largest; report_diffuse() gives the colour of the diffuse texture.
  Finding& report(const TileEvidence& tile, const PlateauSummary& plateaus);
  Finding& report(const TileEvidence& tile, const PlateauSummary& plateaus, const Plateau& shown);
  Finding& report_diffuse(const TileEvidence& tile, const PlateauSummary& plateaus);

  /// "0.041 (byte 56, grey)" or "1.00 0.77 0.34 (bytes 255 227 157)".
  std::string colour(const std::array<double, 3>& linear) const;
  std::array<int, 3> bytes(const std::array<double, 3>& linear) const;

  /// Label of the target's file with this role, or of the one whose picture holds its texels; the target's own
  /// where there is none.
  std::string file_of(FileRole role) const;

  /// Whether gloss (alpha) comes from a channel of the pictures and is not filled in.
  bool has_gloss() const;
  bool has_alpha() const;

  /// The least number of texels in a tile that a rule without regions reports.
  std::size_t least_area(const TileEvidence& tile) const;

 private:
  Finding& report(const TileEvidence& tile, const PlateauSummary& plateaus, const Plateau& shown,
                  FileRole role);

  const Rule& rule_;
  Severity severity_;
  bool fixed_severity_;
  std::vector<Finding>& findings_;
};

/// act(map) for every map of this role.
template <class Act>
void for_each_map(const RuleCheck& check, FileRole role, Act act) {
  for (const MapEvidence& map : check.evidence.maps)
    if (map.role == role) act(map);
}

/// "2,914 px (0.07 %)".
std::string area_text(std::size_t area, std::size_t of);
/// "1,234,567".
std::string in_thousands(std::size_t number);
/// Percent with two significant digits: "0.07 %", "12 %".
std::string percent(double share);

}  // namespace etak
