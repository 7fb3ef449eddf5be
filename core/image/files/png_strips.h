// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/files/png.h"

namespace etak {

/// Rows that write_png() hands to its sink with each call, the last one excepted: so long work can tell how
/// far it is.
int png_strip_rows(const PictureHeader& header, PngLevel level);

}  // namespace etak
