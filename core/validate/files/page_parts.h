// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/validate/files/load.h"

namespace etak {

struct Evidence;

// Materials whose parts lie apart on a page (Manifest::parts), as etak pack --goal one-page lays them.

/// Both pictures of a material whose parts lie apart, put together from its regions of the page's files. Throws Error for a page that
/// does not hold a region.
Pictures put_together(const CheckTarget& target, const PictureOpener& open);

/// Puts the places of findings about such a material on the page: of colours and F0 where these lie.
void put_parts_on_page(const CheckTarget& target, const Evidence& evidence, CheckedFile& file);

}  // namespace etak
