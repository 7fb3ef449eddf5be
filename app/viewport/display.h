// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <string>

#include "core/color/ocio.h"
#include "core/render/view_state.h"

namespace etak {

/// While a view moves, it is drawn at half its size where a whole picture takes longer than this, in ms.
inline constexpr double fluid_ms = 33;

/// How a state's pictures come to the screen: by OpenColorIO for both devices, or (both null) by a tone curve
/// and sRGB.
struct ViewDisplay {
  std::string config, display, view;  // as the state names them
  std::shared_ptr<const OcioDisplay> cpu;
  std::shared_ptr<const OcioShader> gpu;
  Tone tone = Tone::plain;  // where no names are given

  bool is_of(const ViewState& state) const {
    return config == state.ocio_config && display == state.ocio_display && view == state.ocio_view &&
           (tone == state.tone || !state.plain_display());
  }
};

/// Reads the config: not for the thread of windows, but where all three names are empty. Throws Error.
///   tone   where all three names are empty
ViewDisplay open_display(const std::string& config, const std::string& display, const std::string& view,
                         Tone tone = Tone::plain);

/// Codes of a picture in linear light, which already holds the exposure.
QImage shown(const Image& linear, const ViewDisplay& display, unsigned threads);

/// The picture of a state by core's CPU renderer. Throws Error.
QImage cpu_picture(const ViewState& state, const ViewDisplay& display, const QSize& size, unsigned threads);

}  // namespace etak
