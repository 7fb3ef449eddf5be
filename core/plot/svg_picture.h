// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

#include "core/image/picture.h"

namespace etak {

/// The pixels of a file that svg_file() has made, in the size that the file asks for, as codes of sRGB. It draws
/// what these files hold and no other SVG: lines, arcs of half a circle, rectangles and text under a style sheet.
///   text   draws a line of text (PictureDoor)
Image8 svg_picture(std::string_view svg,
                   const std::function<TextPicture(std::string_view text, int size)>& text);

}  // namespace etak
