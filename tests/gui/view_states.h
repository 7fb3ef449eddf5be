// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "app/viewport/viewport.h"
#include "core/render/surface_textures.h"

namespace etak::test {

/// Gold under the default lights, b the same with another gloss; both under the default models.
ViewState gold_state();

/// The same surface under `model` on side a, with a body where the model or its partner shows one.
ViewState state_with(const Model& model);

/// How far two pictures are apart inside the object and over all of it.
struct Apart {
  int codes = 0;       // largest difference of a channel
  double delta_e = 0;  // mean CIEDE2000
  int x = 0, y = 0;    // where the largest is
  int pixels = 0;      // compared
};
/// `coverage`: linear picture with coverage in its fourth channel; only pixels fully covered count.
Apart apart(const QImage& a, const QImage& b, const Image& coverage);

/// The seconds a test waits for anything.
inline constexpr int patience_ms = 20000;

}  // namespace etak::test
