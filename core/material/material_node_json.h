// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/json/node_json.h"
#include "core/material/material.h"

namespace etak {

// For the readers of documents that hold materials; no other header includes this.

/// A material file that is part of a document; parse_material() is this for a document of its own. Throws
/// Error with the JSON pointer within the document.
Material read_material(const JsonNode& node);

}  // namespace etak
