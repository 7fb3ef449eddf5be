// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>

#include "app/viewport/display.h"

namespace etak {

/// What a viewport shows, for pictures of any size, which any thread may draw.
struct SavedView {
  ViewState state;
  ViewDisplay display;
  QImage photograph;           // in place of side b; null: none
  double photograph_from = 0;  // the share of the width from which on it is seen
  QSize size;                  // of the viewport in device pixels

  /// The refined picture, drawn by the CPU renderer of core. Throws Error.
  ///   transparent   without what is behind the object, and without the photograph; the opacity is the alpha of the picture
  ///   rows_done     as in draw_view()
  QImage picture(const QSize& size, bool transparent, const RowsDone& rows_done) const;

  /// How many rows are done when the picture is. Throws Error.
  std::size_t rows(const QSize& size, bool transparent) const;
};

}  // namespace etak
