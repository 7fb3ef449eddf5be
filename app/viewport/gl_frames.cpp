// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_frames.h"

#include "app/viewport/background.h"
#include "app/viewport/frame_share.h"

namespace etak {

GlFrames::GlFrames(bool waits) : painter_(waits) {}
GlFrames::~GlFrames() = default;

GlTarget& GlFrames::of_size(std::unique_ptr<GlTarget>& kept, const QSize& size) {
  if (!kept || kept->size() != size) kept = gl_target(size);
  return *kept;
}

GlFrame GlFrames::draw(const GlJob& job) {
  GlFrame out;
  out.size = job.size;
  out.share = job.share;
  const QSize drawn_size = FrameShare::size(job.size, job.share);
  std::vector<ViewTile> tiles;
  out.refused = failure_of([&] { tiles = view_tiles(job.state, drawn_size.width(), drawn_size.height()); });
  out.failed = failure_of([&] {
    // Enlarged here and not where it is shown, because the user-interface thread must not wait for the driver to
    // compile how.
    const bool whole = drawn_size == job.size;
    const GlTarget& shown = of_size(targets_[next_], job.size);
    const GlTarget& target = whole ? shown : of_size(small_, drawn_size);
    GlPainter::Rows rows;
    if (job.state.refined) rows = {job.band * GlJob::band_rows, GlJob::band_rows};
    const GlPainter::Drawn drawn = painter_.draw(tiles, job.state.environment, job.display, target, rows);
    out.context_lost = drawn.context_lost;
    out.refined = job.state.refined;
    if (out.refined && !job.is_last_band()) return;
    next_ = 1 - next_;
    out.texture = shown.texture();
    out.background = drawn.background;
    out.frame_ms = drawn.frame_ms + (whole ? 0 : painter_.enlarge(target, shown));
    out.compile_ms = drawn.compile_ms;
  });
  return out;
}

QImage GlFrames::picture(const GlJob& job) {
  return painter_.picture(view_tiles(job.state, job.size.width(), job.size.height()), job.state.environment,
                          job.display, job.size);
}

}  // namespace etak
