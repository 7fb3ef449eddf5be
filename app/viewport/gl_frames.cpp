// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_frames.h"

#include "app/viewport/frame_share.h"
#include "app/viewport/gl_textures.h"
#include "core/base/error.h"

namespace etak {

GlFrames::GlFrames() = default;
GlFrames::~GlFrames() = default;

GlTarget& GlFrames::of_size(std::unique_ptr<GlTarget>& kept, const QSize& size) {
  if (!kept || kept->size() != size) kept = painter_.target(size);
  return *kept;
}

GlFrame GlFrames::draw(const GlJob& job) {
  GlFrame out;
  out.size = job.size;
  out.share = job.share;
  out.drawn = FrameShare::size(job.size, job.share);
  std::vector<ViewTile> tiles;
  try {
    tiles = view_tiles(job.state, out.drawn.width(), out.drawn.height());
  } catch (const Error& error) {
    out.refused = QString::fromUtf8(error.what());
  }
  try {
    const GlTarget& target = of_size(targets_[next_], out.drawn);
    const GlPainter::Drawn drawn = painter_.draw(tiles, job.state.environment, job.display, target);
    next_ = 1 - next_;
    out.texture = target.texture();
    out.background = drawn.background;
    out.frame_ms = drawn.frame_ms;
    out.compile_ms = drawn.compile_ms;
    out.context_lost = drawn.context_lost;
  } catch (const Error& error) {
    out.failed = QString::fromUtf8(error.what());
  }
  return out;
}

QImage GlFrames::picture(const GlJob& job) {
  return painter_.picture(view_tiles(job.state, job.size.width(), job.size.height()), job.state.environment,
                          job.display, job.size);
}

}  // namespace etak
