// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/picture.h"

namespace etak::editor {

/// The reader and writer of pictures that are no plain PNG. OpenImageIO and the 250 libraries that it needs are in a module,
/// because the loader takes 0.4 s for them, and the first picture needs none of them; the first use opens the module.
/// Any thread may use the door. Its functions throw Error where the module cannot be opened.
PictureDoor picture_door();

}  // namespace etak::editor
