// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/image/image.h"

namespace etak::test {

/// Writes a TIFF file with codes of 8 or 16 bits, or 32-bit floats, by OpenImageIO: ZIP compression, and a last channel
/// of two or four that is no factor of the colour.
void write_tiff(const std::string& path, const Image8& image);
void write_tiff(const std::string& path, const Image16& image);
void write_tiff(const std::string& path, const Image& image);

}  // namespace etak::test
