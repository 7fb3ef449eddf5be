// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/judge/rule_check.h"

namespace etak {

/// The rows of the rule table, one per file of this folder.
#define ETAK_RULE(name) extern const Rule name;
#include "core/judge/rules/rules.inc"
#undef ETAK_RULE

/// Whether codes are the grey 127 or 128 that scales from 0 to 1 begin with in many programs.
inline bool is_middle_grey(const std::array<int, 3>& codes) {
  return codes == std::array{127, 127, 127} || codes == std::array{128, 128, 128};
}

/// The kinds of pictures that a project sets limits for.
enum class PictureClass { colour, normal, data };

/// The eye sees less detail of gloss, height and occlusion, too, than of colours.
inline PictureClass picture_class(FileRole role) {
  if (role == FileRole::normal) return PictureClass::normal;
  return traits(role).data || role == FileRole::gloss || role == FileRole::height ||
                 role == FileRole::occlusion
             ? PictureClass::data
             : PictureClass::colour;
}

/// The parameter that limits pictures of a role, as rules name theirs: "colour_side", "normal_side", "data_side".
inline std::string parameter_of_class(FileRole role, std::string_view what) {
  const PictureClass of = picture_class(role);
  const std::string name = of == PictureClass::normal ? "normal"
                           : of == PictureClass::data ? "data"
                                                      : "colour";
  return name + "_" + std::string(what);
}

}  // namespace etak
