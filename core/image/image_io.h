// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/image/picture.h"

namespace etak {

// The only sources of etak that use OpenImageIO. They are the target etak::image_io, which is built where
// that library is found and is no part of etak::core, so that the etak program starts fast. To open any
// picture, use core/image/load.h, which reads PNG without OpenImageIO.
//
// The fourth channel of etak's pictures is gloss as often as opacity, and colour under opacity 0 counts.
// OpenImageIO takes the fourth channel of a PNG for opacity and multiplies the colour by it (its issues 528,
// 760, 2887, 3917, 4314), which loses both. Every file is therefore opened, and every file written, with
// oiio:UnassociatedAlpha = 1.
//
// All functions throw Error that names the path. Besides unreadable files, these are errors:
//   files that change while they are read (core/base/files/steady_file.h; OpenImageIO is never given a path
//     to open)
//   files that are empty or cut short (for some formats OpenImageIO fills up the missing part and reports
//     success)
//   CMYK pictures (OpenImageIO converts them by a formula that no printer uses) and deep pictures
//   pictures of more than max_image_side pixels on a side or of more than 4 channels
// A palette is expanded to RGB or RGBA.

PictureHeader read_picture_header(const std::string& path);

/// Reads a picture of a format that picture_format() knows. Codes of 8 and 16 bits become code / 255 and code / 65535.
/// No transfer curve is undone: the values of a PNG stay encoded. NaN and infinity are kept as they are.
Image read_image(const std::string& path);

/// Reads a picture in the kind of values that its file has: 8-bit codes, 16-bit codes or floats.
Picture read_picture(const std::string& path);

/// Reads a file that is in memory. The format is told by the first bytes, or else by the ending of
/// `label`.
///   label   for messages: the path, or the name of the thing that contains the bytes
Picture read_picture(std::string_view bytes, const std::string& label);

/// A line of text in DejaVu Sans, of which the file is looked for where systems keep it. Throws Error where there is none,
/// and for letters beyond ASCII other than a degree sign at the end.
///   size   of the font in pixels
TextPicture text_picture(std::string_view text, int size);

/// The functions above and below as a PictureDoor, for load_picture(), for writing floats and for text, the decoders of
/// mesh_codecs.h, and astc_codec.h.
PictureDoor picture_door();

/// Writes a PNG file. The whole file is made in memory and then put in place at once (write_file of
/// core/base/files/file.h).
///   overwrite   false: throws Error where the file exists
void write_png(const std::string& path, const Image8& image, bool overwrite);

/// Writes an OpenEXR file with ZIP compression, likewise.
///   floats   true: 32-bit values; false: half floats, which have 11 bits of precision and reach 65504
///            (larger values are written as 65504)
void write_exr(const std::string& path, const Image& image, bool floats, bool overwrite);

/// Files of 32-bit floats with ZIP compression, made in memory. Colour is not multiplied by the fourth
/// channel, and the file does not ask readers to multiply it: OpenEXR names the channel `fourth`, and TIFF
/// declares it unassociated alpha (where `fourth` is "alpha") or unspecified.
std::string exr_bytes(const Image& image, const std::string& fourth);
std::string tiff_bytes(const Image& image, const std::string& fourth);

/// A lossless WebP file, made in memory, of a picture whose values are codes of 8 bits as fractions of 255. Codes under
/// alpha 0 are kept. Grey becomes RGB, which is what the format has. At most 16383 pixels on a side.
std::string webp_bytes(const Image& image);

}  // namespace etak
