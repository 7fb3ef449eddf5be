// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/image/any_image.h"
#include "core/validate/target.h"

namespace etak {

/// A picture file, opened: PNG is read row by row, all else at once by the decoder. Throws Error that names
/// the path.
std::unique_ptr<RowSource> open_picture(const std::string& path, const PictureDecoder& decoder);

/// The same of a file that can be read row by row; null for others.
std::unique_ptr<RowSource> open_rows(const std::string& path);

/// The head alone, where the format lets it be read alone (PNG); else the whole is decoded.
///   bytes   of the file, when it is in memory; else empty
TextureHeader read_texture_header(const std::string& path, std::string_view bytes, const std::string& label,
                                  const PictureDecoder& decoder);

/// All of a picture as codes, 16 bits rounded to 8; floats clamped to 0..1 and, but for the fourth channel,
/// encoded to sRGB. Channels as stored.
///   bytes   of the file, when it is in memory; else empty
Image8 load_codes(const std::string& path, std::string_view bytes, const std::string& label,
                  const PictureDecoder& decoder, TextureHeader& header);

}  // namespace etak
