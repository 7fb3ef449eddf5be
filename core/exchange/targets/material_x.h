// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/engine_values.h"

namespace etak {

// The text of targets that are nodes of MaterialX 1.39.
inline constexpr std::string_view material_x_opens =
    "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
inline constexpr std::string_view material_x_closes = "</materialx>\n";

/// A node whose kind has the target's name and whose inputs are the fields, and the material that has it.
std::string material_x_body(const ExportSurface& surface, const EngineValues& values);

}  // namespace etak
