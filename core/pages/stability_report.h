// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/study/stability/stability.h"

namespace etak {

// The results of the stiff and extreme cases.

/// Three or more lines for each case, and a last line that begins with "PASSED:" or "FAILED:".
std::string stability_text(const std::vector<StabilityCase>& cases);
/// {"schema": "etak-stability/1", "passed": true, "cases": [...]}
std::string stability_json(const std::vector<StabilityCase>& cases);
/// An HTML table for report pages, such as error_time_page().
std::string stability_html(const std::vector<StabilityCase>& cases);

}  // namespace etak
