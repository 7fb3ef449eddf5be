// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/rects/rects.h"

namespace etak::rects {

/// Packs without regard to an earlier layout; sizes and options are checked already.
RectLayout pack_fresh(std::span<const RectSize> sizes, const RectOptions& options);

/// Sets the page sides of a layout to what its form and its places need.
void fit_pages(std::span<const RectSize> sizes, const RectOptions& options, RectLayout& layout);

/// The previous layout with the new rectangles put into its gaps, or `fresh` where that costs more than
/// previous.most_extra_area allows.
RectLayout keep_previous(std::span<const RectSize> sizes, const RectOptions& options,
                         const PreviousRects& previous, RectLayout fresh);

}  // namespace etak::rects
