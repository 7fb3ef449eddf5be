// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/files/steady_file.h"

namespace etak {

/// A PNG file with what another file said beside its texels.
///   left_out   types of the chunks that did not come along, each once, in the order of the file
struct PngWithChunks {
  std::string file;
  std::vector<std::string> left_out;
};

/// Puts the ancillary chunks of `original` (colour profile, transfer curve, density, texts) into `made`,
/// before and behind the image data as they stood. Both hold pictures of the same size; the texels may
/// differ. These chunks stay out: those of another colour type or depth (tRNS, bKGD, sBIT, hIST) unless the
/// two files agree in both, those of animations, and those that ask to be dropped once texels change
/// (ISO/IEC 15948, 14.2: an upper-case fourth letter).
///   made       a PNG file by write_png()
///   original   a whole PNG file
PngWithChunks with_chunks_of(std::string_view made, ByteSource& original);

/// A PNG file without what it says beside its texels: its critical chunks and tRNS stay. Read as glTF reads
/// pictures, which takes no notice of colour profiles and transfer curves in files, it is the same picture.
/// nullopt for what is no PNG file, or not a whole one.
std::optional<std::string> texels_alone(ByteSource& file);
/// How many bytes that would be; texels are not read.
std::optional<std::size_t> size_of_texels_alone(ByteSource& file);

}  // namespace etak
