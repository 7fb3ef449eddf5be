// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/error_time.h"

namespace etak {

// The functions that measure the families (target etak::study_run).
#define ETAK_FAMILY(id, function) ErrorTimeFamily function(const ReportOptions& options);
#include "core/study/families/families.inc"
#undef ETAK_FAMILY

}  // namespace etak
