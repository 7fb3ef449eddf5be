// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/image/image.h"

namespace etak::test {

/// Writes a TIFF file by OpenImageIO: codes of 8 or 16 bits or 32-bit floats, with ZIP compression. Colour is
/// not multiplied by the last of two or four channels.
void write_tiff(const std::string& path, const Image8& image);
void write_tiff(const std::string& path, const Image16& image);
void write_tiff(const std::string& path, const Image& image);

}  // namespace etak::test
