// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/sources/plane.h"

namespace etak {

/// The door to every picture format that OpenImageIO reads (target etak::picture_door).
PictureDoor picture_door();

}  // namespace etak
