// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/blocks/astc_door.h"

namespace etak {

// The only source of etak that uses astcenc. It is a part of the target etak::image_io, which programs load when they
// first need it.

/// The encoder and the decoder of ASTC.
AstcDoor astc_door();

}  // namespace etak
