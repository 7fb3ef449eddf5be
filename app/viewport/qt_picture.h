// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <algorithm>

#include "core/color/rgb.h"
#include "core/image/image.h"

namespace etak {

inline QColor qt_color(const Srgb8& codes) {
  return {codes.r, codes.g, codes.b};
}

/// The first three channels of a picture.
inline QImage qt_image(const Image8& codes) {
  QImage out(codes.width, codes.height, QImage::Format_RGB888);
  for (int y = 0; y < codes.height; ++y)
    std::copy_n(codes.at(0, y).data(), std::size_t{3} * static_cast<std::size_t>(codes.width),
                out.scanLine(y));
  return out;
}

/// An icon that looks the same in selected rows and disabled buttons, over which the style would lay a colour.
inline QIcon untinted_icon(const QPixmap& picture) {
  QIcon out(picture);
  out.addPixmap(picture, QIcon::Selected);
  out.addPixmap(picture, QIcon::Disabled);
  return out;
}

}  // namespace etak
