// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/choose/choose.h"

namespace etak {

/// For people, and for `etak shader` and `etak pack`.
std::string choice_text(const std::vector<Choice>& choices, const CostTable& costs,
                        std::string_view scene = {});
std::string choice_json(const std::vector<Choice>& choices, const CostTable& costs,
                        std::string_view scene = {});

}  // namespace etak
