// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/study/stability/stability.h"

namespace etak {

// The stiff and extreme cases for people and machines.

std::string stability_text(const std::vector<StabilityCase>& cases);
std::string stability_json(const std::vector<StabilityCase>& cases);
/// A table for report pages.
std::string stability_html(const std::vector<StabilityCase>& cases);

}  // namespace etak
