// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/saved_view.h"

#include <QPainter>
#include <algorithm>

#include "app/viewport/sides.h"
#include "core/base/parallel.h"
#include "core/render/display.h"

namespace etak {
namespace {

bool any_seen_through(const std::vector<ViewTile>& tiles) {
  return std::ranges::any_of(tiles, [](const ViewTile& tile) { return is_seen_through(tile.scene); });
}

QImage without_background(ViewState state, const ViewDisplay& display, const QSize& size,
                          const RowsDone& rows_done) {
  const unsigned threads = thread_count(0);
  state.backdrop = {};
  const Image picture = unmultiplied(cut_out(
      [&](const Vec3& background) {
        state.background = scaled(background, 1 / state.exposure);
        return draw_view(state, size.width(), size.height(), threads, rows_done);
      },
      any_seen_through(view_tiles(state, size.width(), size.height()))));
  QImage out = shown(picture, display, threads).convertToFormat(QImage::Format_RGBA8888);
  for (int y = 0; y < out.height(); ++y) {
    std::uint8_t* const row = out.scanLine(y);
    for (int x = 0; x < out.width(); ++x) row[4 * x + 3] = to_code(picture.at(x, y)[3]);
  }
  return out;
}

}  // namespace

QImage SavedView::picture(const QSize& wanted, bool transparent, const RowsDone& rows_done) const {
  ViewState refined = state;
  refined.refined = true;
  const ViewDisplay shows =
      display.is_of(state) ? display
                           : open_display(state.ocio_config, state.ocio_display, state.ocio_view, state.tone);
  if (transparent) return without_background(refined, shows, wanted, rows_done);
  QImage out = cpu_picture(refined, shows, wanted, thread_count(0), rows_done);
  if (!photograph.isNull()) {
    QPainter painter(&out);
    paint_photograph(painter, photograph, out.rect(), photograph_from * out.width());
  }
  return out;
}

std::size_t SavedView::rows(const QSize& wanted, bool transparent) const {
  const std::vector<ViewTile> tiles = view_tiles(state, wanted.width(), wanted.height());
  std::size_t out = 0;
  for (const ViewTile& tile : tiles) out += static_cast<std::size_t>(tile.scene.height);
  return transparent && any_seen_through(tiles) ? 2 * out : out;
}

}  // namespace etak
