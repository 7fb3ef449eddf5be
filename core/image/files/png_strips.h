// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/files/png.h"

namespace etak {

/// How many rows write_png() makes a strip of; the last strip may have fewer. Each strip is one call of the
/// sink, from which callers can tell the progress of a long file.
int png_strip_rows(const PictureHeader& header, PngLevel level);

}  // namespace etak
