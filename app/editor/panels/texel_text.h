// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPoint>
#include <QString>

#include "core/project/project.h"

namespace etak::editor {

/// What a texel of a channel holds, for people: of colours codes, linear numbers and luminance; of F0 the zone and the nearest
/// measured material too; of gloss roughness and exponent; of normals how far they lean. Empty outside of the texture, and
/// where the channel has none.
QString texel_text(const SurfaceTextures& textures, Channel channel, const QPoint& at);

}  // namespace etak::editor
