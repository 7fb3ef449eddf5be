// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/judge/rule_check.h"

namespace etak {

/// Reports what cannot be read for a reason that is the rule's (rule_of_unreadable()).
void report_unreadable(RuleCheck& check, const Rule& rule);

}  // namespace etak
