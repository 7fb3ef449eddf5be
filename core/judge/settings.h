// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/finding.h"
#include "core/maps/file_role.h"

namespace etak {

/// Which severities and limits hold where the configuration says nothing.
///   standard   named "default"
///   strict     warnings of the default become errors, and albedo is held to the tighter published bounds
///   film       strict, but sides need not be powers of two and F0 above 1 is kept as information
///   custom     every rule is off until the configuration turns it on
enum class Profile { standard, strict, film, custom };
std::string_view name(Profile profile);  // "default", "strict", "film", "custom"
std::optional<Profile> profile_named(std::string_view text);

/// The curve between 8-bit codes and linear light.
///   srgb      piecewise, IEC 61966-2-1 (Hoffman's tables)
///   power_22  exponent 1/2.2 (Schueler's tables)
///   linear    none
enum class TextureTransfer { srgb, power_22, linear };
std::string_view name(TextureTransfer transfer);  // "srgb", "power-2.2", "linear"
std::optional<TextureTransfer> texture_transfer_named(std::string_view text);

/// The configuration of one rule. Where it gives no value, that of the profile holds.
struct RuleSetting {
  std::optional<Severity> severity;
  std::map<std::string, double, std::less<>> parameters;
  friend bool operator==(const RuleSetting&, const RuleSetting&) = default;
};

/// The value of F0 that is compared with the zone: luminance Y, or the largest channel.
enum class ZoneMetric { luminance, max };

/// The forbidden zone and the region analysis of the 1xx and 2xx rules.
struct ZoneSettings {
  double low = 0.20, high = 0.45;  // open interval of linear F0
  ZoneMetric metric = ZoneMetric::luminance;
  int erode = 3;                    // side of the square that masks are eroded by: 1 (off), 3 or 5
  int min_area_px = 32;             // smallest region
  double min_area_share = 0.00001;  // of the tile, besides min_area_px (0.001 %)
  friend bool operator==(const ZoneSettings&, const ZoneSettings&) = default;
};

/// Smallest region that counts in a tile of `tile_texels`: min_area_px, or the share where that is more; but
/// never more than half of the tile, so that a texture of a few texels is judged too.
std::size_t least_region(const ZoneSettings& zone, std::size_t tile_texels);

/// Findings that somebody has seen and accepts.
struct AllowEntry {
  std::string rule;      // id or prefix
  std::string file;      // pattern; empty: every file
  std::string material;  // pattern; empty: every material
  std::string tile;      // pattern; empty: every tile
  std::string reason;    // required
  std::string expires;   // "2027-01-01"; empty: never
  friend bool operator==(const AllowEntry&, const AllowEntry&) = default;
};

class KnownMaterials;

/// Everything that decides what is found. Equal settings and equal files give equal findings.
struct Settings {
  Profile profile = Profile::standard;
  TextureTransfer transfer = TextureTransfer::srgb;
  bool transfer_stated = false;         // by the user: ETK403 is then silent
  bool alpha_is_transparency = false;   // 0 < alpha < 255 does not count as opaque
  GreenAxis green = GreenAxis::unsaid;  // of normal maps whose names do not say it
  Severity fail_on = Severity::error;
  std::map<std::string, RuleSetting, std::less<>> rules;  // by whole id: prefixes are resolved by the reader
  ZoneSettings zone;
  std::vector<AllowEntry> allow;
  std::shared_ptr<const KnownMaterials> known;  // nearest.h; null: the materials of the built-in library
  friend bool operator==(const Settings&, const Settings&) = default;
};

struct Rule;

/// The severity of a rule under these settings. A rule that is `off` is not run and needs no data.
Severity severity_of(const Rule& rule, const Settings& settings);

/// Value of a rule's parameter: the setting's, else the profile's. Asking for a parameter that the rule does
/// not have is the caller's mistake.
double parameter_of(const Rule& rule, std::string_view parameter, const Settings& settings);

/// A hash of 32 hexadecimal digits over the settings that decide what is found: rules with severities and
/// parameters, zone, transfer, the meaning of alpha, and the materials of the library. Allowances and fail_on
/// judge what was found and are left out.
std::string settings_hash(const Settings& settings);

}  // namespace etak
