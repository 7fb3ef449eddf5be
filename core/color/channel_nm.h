// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace etak {

/// About where red, green and blue of sRGB have their weight, nm.
inline constexpr std::array<double, 3> channel_nm{611, 549, 464};

}  // namespace etak
