// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/names/picture_sets.h"
#include "core/validate/find/find_targets.h"
#include "core/validate/find/picture_namer.h"

namespace etak {

/// The target of a set of pictures.
///   manifest   what the run states of all pictures
FoundTarget target_of_set(const PictureSet& set, const Manifest& manifest, PictureNamer& namer);

/// The result of a set that is not judged, because something of it is missing (ETK002). Its files are opened, so that
/// one that cannot be read is told.
///   door   null: nothing is opened
CheckedFile lone_set(const CheckTarget& target, const std::string& missing, const Settings& settings,
                     const PictureDoor* door);

/// Takes the marks of UDIM tiles away where there is no second tile: a number alone, such as that of
/// chair_1234_diff.png, makes no set of tiles.
void settle_tiles(std::vector<FoundTarget>& targets);

}  // namespace etak
