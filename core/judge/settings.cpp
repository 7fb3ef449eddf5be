// SPDX-License-Identifier: Apache-2.0
#include "core/judge/settings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/judge/nearest.h"
#include "core/judge/rules.h"

namespace etak {

namespace {

constexpr std::array<std::pair<Profile, std::string_view>, 4> profiles{{{Profile::standard, "default"},
                                                                        {Profile::strict, "strict"},
                                                                        {Profile::film, "film"},
                                                                        {Profile::custom, "custom"}}};
constexpr std::array<std::pair<TextureTransfer, std::string_view>, 3> transfers{
    {{TextureTransfer::srgb, "srgb"},
     {TextureTransfer::power_22, "power-2.2"},
     {TextureTransfer::linear, "linear"}}};

template <class Rows, class Value>
std::string_view name_in(const Rows& rows, Value value) {
  for (const auto& [row, text] : rows)
    if (row == value) return text;
  return "";
}

template <class Value, std::size_t count>
std::optional<Value> named_in(const std::array<std::pair<Value, std::string_view>, count>& rows,
                              std::string_view text) {
  for (const auto& [value, row] : rows)
    if (row == text) return value;
  return std::nullopt;
}

const RuleSetting* setting_of(const Rule& rule, const Settings& settings) {
  const auto found = settings.rules.find(rule.id);
  return found == settings.rules.end() ? nullptr : &found->second;
}

}  // namespace

std::string_view name(Profile profile) {
  return name_in(profiles, profile);
}

std::optional<Profile> profile_named(std::string_view text) {
  return named_in(profiles, text);
}

std::string_view name(TextureTransfer transfer) {
  return name_in(transfers, transfer);
}

std::optional<TextureTransfer> texture_transfer_named(std::string_view text) {
  return named_in(transfers, text == "gamma22" ? "power-2.2" : text);  // its older name
}

std::size_t least_region(const ZoneSettings& zone, std::size_t tile_texels) {
  const double texels = static_cast<double>(tile_texels);
  const double wanted = std::max<double>(zone.min_area_px, std::ceil(zone.min_area_share * texels));
  return static_cast<std::size_t>(std::max(1.0, std::min(wanted, std::floor(texels / 2))));
}

Severity severity_of(const Rule& rule, const Settings& settings) {
  const RuleSetting* setting = setting_of(rule, settings);
  if (setting != nullptr && setting->severity) return *setting->severity;
  // No profile turns off the rules of the tool itself: a file that could not be checked is not clean.
  const bool of_the_tool = is_of_the_tool(rule.id);
  switch (settings.profile) {
    case Profile::standard:
      return rule.severity.standard;
    case Profile::strict:
      return rule.severity.strict;
    case Profile::film:
      // Renderers for film take pictures of any size and keep float reflectances above 1.
      return rule.id == "ETK009" || rule.id == "ETK107" ? Severity::info : rule.severity.strict;
    case Profile::custom:
      return of_the_tool ? rule.severity.standard : Severity::off;
  }
  return rule.severity.standard;
}

double parameter_of(const Rule& rule, std::string_view parameter, const Settings& settings) {
  if (const RuleSetting* setting = setting_of(rule, settings))
    if (const auto found = setting->parameters.find(parameter); found != setting->parameters.end())
      return found->second;
  const auto row = std::find_if(rule.parameters.begin(), rule.parameters.end(),
                                [&](const RuleParameter& p) { return p.name == parameter; });
  assert(row != rule.parameters.end());
  const bool strict = settings.profile == Profile::strict || settings.profile == Profile::film;
  return strict ? row->strict_value : row->value;
}

std::string settings_hash(const Settings& settings) {
  const ZoneSettings& zone = settings.zone;
  std::string text(name(settings.profile));
  const auto add = [&](std::string_view part) { (text += part) += '\n'; };
  add(name(settings.transfer));
  add(settings.transfer_stated ? "stated" : "");
  add(settings.alpha_is_transparency ? "transparency" : "mask");
  add(name(settings.green));
  for (const double value : {zone.low, zone.high, zone.min_area_share}) add(number(value, 17));
  for (const int value : {static_cast<int>(zone.metric), zone.erode, zone.min_area_px})
    add(std::to_string(value));
  for (const Rule* rule : rules()) {
    add(rule->id);
    add(name(severity_of(*rule, settings)));
    for (const RuleParameter& parameter : rule->parameters)
      add(number(parameter_of(*rule, parameter.name, settings), 17));
  }
  text += known_materials(settings).hash();
  ContentHash hash;
  hash.add(text);
  return hash.hex();
}

}  // namespace etak
