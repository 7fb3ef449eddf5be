// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <string>

#include "core/color/ocio.h"
#include "core/render/view_state.h"

namespace etak {

/// The transform from linear light to the screen: an OpenColorIO display for the CPU and for OpenGL, or a tone
/// curve and sRGB where `cpu` and `gpu` are null.
struct ViewDisplay {
  std::string config, display, view;  // the names in the state
  std::shared_ptr<const OcioDisplay> cpu;
  std::shared_ptr<const OcioShader> gpu;
  Tone tone = Tone::plain;  // where no names are given

  bool is_of(const ViewState& state) const {
    return config == state.ocio_config && display == state.ocio_display && view == state.ocio_view &&
           (tone == state.tone || !state.plain_display());
  }
};

/// Opens the display. The user-interface thread should call it only where all three names are empty, because
/// otherwise it reads the config. Throws Error.
///   tone   of the display where all three names are empty
ViewDisplay open_display(const std::string& config, const std::string& display, const std::string& view,
                         Tone tone = Tone::plain);

/// The 8-bit codes of a picture in linear light (4 channels), which must be multiplied by the exposure
/// already.
QImage shown(const Image& linear, const ViewDisplay& display, unsigned threads);

/// The picture of a state as the CPU renderer of core draws it, `size` in pixels. Throws Error.
///   rows_done   as in draw_view()
QImage cpu_picture(const ViewState& state, const ViewDisplay& display, const QSize& size, unsigned threads,
                   const RowsDone& rows_done = {});

}  // namespace etak
