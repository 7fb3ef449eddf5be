// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/study/stability/stability.h"

namespace etak {

// The results of the stiff and extreme cases.

/// Three or more lines for each case, and a last line that begins with "PASSED:" or "FAILED:". Cases that
/// fail come first, then those in which the usual formula fails.
///   all   false: the other cases are counted in one line instead
std::string stability_text(const std::vector<StabilityCase>& cases, bool all = false);
/// {"schema": "etak-stability/1", "passed": true, "cases": [...]}
std::string stability_json(const std::vector<StabilityCase>& cases);
/// HTML tables for report pages, such as error_time_page(), in the order of stability_text(). Cases in which
/// the usual formula does not fail are folded away.
std::string stability_html(const std::vector<StabilityCase>& cases);

}  // namespace etak
