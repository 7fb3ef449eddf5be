// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/judge/pixels/evidence.h"
#include "core/judge/rule.h"
#include "core/judge/settings.h"

namespace etak {

/// What the looks at picture files are wanted for.
///   wide    16 bits of 8-bit content (ETK715)
///   edges   seams (ETK716)
struct LooksWanted {
  bool wide = false, edges = false;
};
LooksWanted looks_wanted(const Settings& settings);

/// Whether a limit of the rule is set, and the rule is on.
bool has_limit(std::string_view rule, const Settings& settings);

/// Looks at a picture file. Throws Error for one that cannot be read.
///   tiles   which axes it is laid beside itself along
PictureLook look_at_picture(const PictureFile& file, FileRole role, std::array<bool, 2> tiles,
                            LooksWanted wanted, const PictureDoor& door);

/// Looks at those of a target's pictures that are not judged as tiles of pages.
void look_at_pictures(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                      Evidence& evidence);

}  // namespace etak
