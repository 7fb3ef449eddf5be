// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "core/image/image.h"
#include "core/render/scene.h"

namespace etak {

std::string_view name(Transfer transfer);  // "srgb", "power-0.45", "sqrt", "linear"
std::optional<Transfer> transfer_named(std::string_view text);

/// Codes of the first three channels of `picture`: transfer of exposure x value, clamped to [0, 1], rounded
/// to nearest; the sRGB codes are those of srgb_u8 (core/color/srgb.h). NaN becomes 0.
Image8 to_codes(const Image& picture, double exposure, Transfer transfer);

/// `picture` with three channels, times exposure.
Image exposed(const Image& picture, double exposure);

}  // namespace etak
