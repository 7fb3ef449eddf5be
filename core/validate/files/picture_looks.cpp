// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/picture_looks.h"

#include <algorithm>

#include "core/image/load.h"
#include "core/judge/rules.h"
#include "core/validate/files/load.h"

namespace etak {

bool has_limit(std::string_view id, const Settings& settings) {
  const Rule& rule = *find_rule(id);
  return severity_of(rule, settings) != Severity::off &&
         std::ranges::any_of(rule.parameters, [&](const RuleParameter& parameter) {
           return parameter.value == 0 && parameter_of(rule, parameter.name, settings) > 0;
         });
}

LooksWanted looks_wanted(const Settings& settings) {
  return {severity_of(*find_rule("ETK715"), settings) != Severity::off, has_limit("ETK716", settings)};
}

PictureLook look_at_picture(const PictureFile& file, FileRole role, std::array<bool, 2> tiles,
                            LooksWanted wanted, const PictureDoor& door) {
  PictureLook out;
  out.label = file.label;
  out.role = role;
  out.narrow = wanted.wide && holds_8_bits(file, door);
  if (!wanted.edges || !(tiles[0] || tiles[1])) return out;
  EdgeSteps steps = edge_steps(*open_picture(file, door));
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (!tiles[axis]) steps.across[axis] = 0;
  out.steps = steps;
  return out;
}

void look_at_pictures(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                      Evidence& evidence) {
  const LooksWanted wanted = looks_wanted(settings);
  if (!target.manifest.tiles.empty() || !target.manifest.parts.empty() || !(wanted.wide || wanted.edges))
    return;
  for (const TargetFile& file : target.files)
    if (is_picture(file.role))
      evidence.looks.push_back(look_at_picture(file.picture(), file.role, {true, true}, wanted, door));
}

}  // namespace etak
