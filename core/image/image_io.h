// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/image/picture.h"

namespace etak {

// The one door to OpenImageIO (target etak::image_io, only where that library is found; no part of
// etak::core, so that the start-up program stays light). core/image/load.h opens any picture, and PNG without
// OpenImageIO.
//
// The fourth channel of etak's pictures is gloss as often as opacity, and colour under opacity 0 counts.
// OpenImageIO takes a fourth channel of a PNG for opacity and multiplies the colour by it (its issues 528,
// 760, 2887, 3917, 4314), losing both; so every input is opened and every output written with
// oiio:UnassociatedAlpha = 1.
//
// All throw Error that names the path: also for files that change while they are read
// (core/base/files/steady_file.h; OpenImageIO is never given a path to open), for files that are empty or cut
// short (OpenImageIO fills up what is missing of some and calls it success), for CMYK (OpenImageIO converts
// by a formula that no printer uses), deep pictures, and those of more than max_image_side on a side or 4
// channels. A palette is expanded to RGB or RGBA.

PictureHeader read_picture_header(const std::string& path);

/// Any picture file OpenImageIO knows, 8- and 16-bit codes as code / 255 and code / 65535. No curve is
/// undone: PNG codes stay encoded. NaN and infinity stay for the caller to judge.
Image read_image(const std::string& path);

/// A picture in the kind of values its file has.
Picture read_picture(const std::string& path);

/// The same of a file that is in memory. The format is known by its first bytes, else by the ending of
/// `label`.
///   label   for messages: the path, or what the bytes are a part of
Picture read_picture(std::string_view bytes, const std::string& label);

/// These for load_picture(), and those that write floats.
PictureDoor picture_door();

/// The whole file is made in memory and put in place at once (write_file of core/base/files/file.h).
///   overwrite   false: an existing file is an Error
void write_png(const std::string& path, const Image8& image, bool overwrite);

/// OpenEXR, ZIP compression.
///   floats   32-bit values; else half: 11 bits of precision, at most 65504 (larger ones are written as that)
void write_exr(const std::string& path, const Image& image, bool floats, bool overwrite);

/// Files of 32-bit floats in memory, ZIP compression. Nothing is multiplied by the fourth channel, and no
/// reader is asked to: it is called `fourth` in OpenEXR, and is unassociated alpha (for `fourth` = "alpha")
/// or unspecified in TIFF.
std::string exr_bytes(const Image& image, const std::string& fourth);
std::string tiff_bytes(const Image& image, const std::string& fourth);

}  // namespace etak
