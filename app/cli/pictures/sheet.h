// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/pictures/render.h"
#include "core/image/image.h"

namespace etak::cli {

/// Eight materials (columns) under every model of the registry (rows), then with the default models under the
/// hemispheres alone, under etak's environment, and at three glosses. Of the arguments gloss, size (of one
/// sphere; 128 where none is given), exposure and transfer count.
///   scene   gets exposure and transfer, for writing the sheet
Image draw_sheet(RenderArguments& arguments, unsigned threads, Scene& scene);

}  // namespace etak::cli
