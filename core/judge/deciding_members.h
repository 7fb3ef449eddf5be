// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/members.h"
#include "core/judge/nearest.h"
#include "core/judge/target.h"

namespace etak {

// What decides the results of a target and of a run, for the keys of caches and the digests of shards: members() of the
// values that a check is told, as base/members.h asks for them. Each function names all members of its struct, so that
// a new one is a compile error here until it is told, or left out for a stated reason.

/// Bytes and paths are left out: what files hold is told by their hashes, and files that were moved give the same results.
template <class To>
void members(To& to, const TargetFile& value) {
  const auto& [role, path, label, guessed, channels, green, bytes] = value;
  to.member("role", role);
  to.member("label", label);
  to.member("guessed", guessed);
  to.member("channels", channels);
  to.member("green", green);
}

template <class To>
void members(To& to, const CheckTile& value) {
  const auto& [name, material, surface_class, box, page, typical_gloss, gutter, mips, flat, flat_f0,
               island_of, layers, own_around] = value;
  to.member("name", name);
  to.member("material", material);
  to.member("surface_class", surface_class);
  to.member("box", box);
  to.member("page", page);
  to.member("typical_gloss", typical_gloss);
  to.member("gutter", gutter);
  to.member("mips", mips);
  to.member("flat", flat);
  to.member("flat_f0", flat_f0);
  to.member("island_of", island_of);
  to.member("layers", layers);
  to.member("own_around", own_around);
}

template <class To>
void members(To& to, const AtlasRect& value) {
  const auto& [name, island, page, x, y, width, height, rotated, crop, source_width, source_height, gutter,
               mips, inset, repeats, source_gutter, holds] = value;
  to.member("name", name);
  for (const int number : {island, page, x, y, width, height, source_width, source_height, gutter, mips})
    to.member("", number);
  to.member("crop", crop);
  to.member("inset", inset);
  for (const bool is : {rotated, repeats, source_gutter}) to.member("", is);
  to.member("holds", holds);
}

/// The path of the scene is left out, as those of files are.
template <class To>
void members(To& to, const Manifest& value) {
  const auto& [tiles, gutter, mips, transfer, material, surface_class, layers, linear8_f0, transparent,
               one_texture, scene, layout_alone, parts, packed, specular_weighs_diffuse] = value;
  to.member("tiles", tiles);
  to.member("gutter", gutter);
  to.member("mips", mips);
  to.member("transfer", transfer);
  to.member("material", material);
  to.member("surface_class", surface_class);
  to.member("layers", layers);
  to.member("has_scene", !scene.empty());
  to.member("parts", parts);
  for (const bool is : {linear8_f0, transparent, one_texture, layout_alone, packed, specular_weighs_diffuse})
    to.member("", is);
}

template <class To>
void members(To& to, const CheckTarget& value) {
  const auto& [label, files, manifest, udim, tile, beside] = value;
  to.member("label", label);
  to.member("files", files);
  to.member("manifest", manifest);
  to.member("udim", udim);
  to.member("tile", tile);
  to.member("beside", beside);
}

template <class To>
void members(To& to, const RuleSetting& value) {
  const auto& [severity, parameters] = value;
  to.member("severity", severity);
  to.member("parameters", parameters);
}

template <class To>
void members(To& to, const ZoneSettings& value) {
  const auto& [low, high, metric, erode, min_area_px, min_area_share] = value;
  to.member("low", low);
  to.member("high", high);
  to.member("metric", metric);
  to.member("erode", erode);
  to.member("min_area_px", min_area_px);
  to.member("min_area_share", min_area_share);
}

template <class To>
void members(To& to, const AllowEntry& value) {
  const auto& [rule, file, material, tile, reason, expires] = value;
  for (const std::string* text : {&rule, &file, &material, &tile, &reason, &expires}) to.member("", *text);
}

template <class To>
void members(To& to, const Settings& value) {
  const auto& [profile, transfer, transfer_stated, alpha_is_transparency, green, fail_on, rules, zone, allow,
               known] = value;
  to.member("profile", profile);
  to.member("transfer", transfer);
  to.member("transfer_stated", transfer_stated);
  to.member("alpha_is_transparency", alpha_is_transparency);
  to.member("green", green);
  to.member("fail_on", fail_on);
  to.member("rules", rules);
  to.member("zone", zone);
  to.member("allow", allow);
  to.member("known", known ? known->hash() : std::string());
}

}  // namespace etak
