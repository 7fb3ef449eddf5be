// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QRectF>
#include <array>
#include <optional>

#include "app/viewport/display.h"
#include "core/render/sheet.h"

namespace etak {

/// The place of a photograph in a view: as large as fits without being cut, in the middle.
QRectF photograph_place(const QImage& photograph, const QRectF& view);

/// Draws the photograph over a view from the column `from` on, with grey beside it.
void paint_photograph(QPainter& painter, const QImage& photograph, const QRectF& view, double from);

/// The mean codes of the photograph in `side` x `side` units of the view around a place; none beside the photograph.
std::optional<std::array<int, 3>> photograph_codes(const QImage& photograph, const QRectF& view,
                                                   const QPointF& at, double side);

/// How far side a of the state is from side b, or from the photograph where there is one, both as the display shows them,
/// over the object in a picture of `size`. Throws Error as draw_view() does.
DifferencePicture difference_of_sides(ViewState state, const ViewDisplay& display, const QImage& photograph,
                                      const QSize& size);

}  // namespace etak
