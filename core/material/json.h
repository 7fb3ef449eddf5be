// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/material/material.h"

namespace etak {

/// Reads a material file (resources/schema/material.schema.json). Throws Error with the JSON pointer of what
/// is wrong, or line and column where the text is no JSON; refuses duplicate keys, unknown keys and nesting
/// deeper than 16.
///   file   name for messages
Material parse_material(std::string_view text, std::string_view file);

/// The file's text: one row of data per line, shortest numbers that read back equal, in the key order of the
/// schema.
std::string format_material(const Material& material);

}  // namespace etak
