// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "core/image/picture.h"
#include "core/judge/target.h"

namespace etak {

/// Opens a picture of a target; called once for each pass over the pixels.
using PictureOpener = std::function<std::unique_ptr<RowSource>(const TargetFile&)>;

/// Opens a picture of a target: the file at its path, or its bytes, which then must outlive the source.
/// Throws Error.
std::unique_ptr<RowSource> open_target_file(const TargetFile& file, const PictureDoor& door);

/// Opens the rows of F0 and gloss, or of diffuse and alpha, that the rules see: those that the file holds with fewer channels
/// are filled from what the target says (spread_rows()), and a fourth channel comes from the file that holds it.
std::unique_ptr<RowSource> open_page(const CheckTarget& target, const TargetFile& file,
                                     const PictureOpener& open);

/// The pictures of a target as the rules see them (a metal-rough set is converted first), for mask pictures and
/// thumbnails. Throws Error.
Pictures load_pictures(const CheckTarget& target, const PictureDoor& door);

}  // namespace etak
