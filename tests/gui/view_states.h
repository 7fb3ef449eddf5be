// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "app/viewport/viewport.h"
#include "core/render/surface_textures.h"

namespace etak::test {

/// Gold under the default lights with the default models; side b has another gloss.
ViewState gold_state();

/// The same state with `model` on side a. Side a has a diffuse colour, which diffuse and combined models
/// show.
ViewState state_with(const Model& model);

/// The difference between two pictures inside the object.
struct Apart {
  int codes = 0;       // largest difference of a channel
  double delta_e = 0;  // mean CIEDE2000
  int x = 0, y = 0;    // pixel of the largest difference
  int pixels = 0;      // number of pixels compared
};
///   coverage   a picture with the coverage of the object in its fourth channel; only pixels that the object
///              covers fully are compared
Apart apart(const QImage& a, const QImage& b, const Image& coverage);

/// The longest time in milliseconds that a test waits for anything.
inline constexpr int patience_ms = 20000;

}  // namespace etak::test
