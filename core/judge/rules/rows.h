// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/judge/rule_check.h"

namespace etak {

/// The rows of the rule table, one per file of this folder.
#define ETAK_RULE(name) extern const Rule name;
#include "core/judge/rules/rules.inc"
#undef ETAK_RULE

}  // namespace etak
