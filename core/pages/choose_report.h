// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/choose/choose.h"

namespace etak {

/// The output of `etak choose`, as a table for people and as JSON (resources/schema/choose.schema.json) for
/// programs, `etak shader` and `etak pack` among them.
///   costs   the table that the choices were made with
///   scene   name of the scene's file; empty: the materials are of the library
std::string choice_text(const std::vector<Choice>& choices, const CostTable& costs,
                        std::string_view scene = {});
std::string choice_json(const std::vector<Choice>& choices, const CostTable& costs,
                        std::string_view scene = {});

}  // namespace etak
